// SPDX-License-Identifier: GPL-3.0-or-later
// The things of a drawn world: found below a cursor, put in, moved, measured out, taken out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "hitos/base/translatable.hpp"
#include "hitos/simulation/text/world_text.hpp"

namespace hitos {

enum class ItemKind : std::uint8_t { wall, door, box, person, way_point, start };

/// A thing of a world, or part of it. Walls are those of the file itself: what a drawing holds is
/// changed there. Boxes are the events of that kind, counted among themselves.
struct WorldItem {
    ItemKind kind = ItemKind::wall;
    std::size_t index = 0;  ///< among those of its kind; of a wall its polyline
    /// Points of the polyline or way that are meant; of what has one point only both are 0.
    std::size_t first = 0;
    std::size_t last = 0;
    friend bool operator==(const WorldItem&, const WorldItem&) = default;
};

/// What is nearest to the point [m, world frame] and not further than `within_m`: points before the
/// pieces between them.
std::optional<WorldItem> item_at(const WorldText& text, const Point2& point, double within_m);

/// The whole that a part belongs to.
WorldItem whole_of(const WorldText& text, const WorldItem& item);

/// Its points [m], those of first to last; four of a box, round it. Empty where it is no more.
Polyline outline_of(const WorldText& text, const WorldItem& item);

/// These put something in, at the end of its list. What cannot be is refused as WorldText does,
/// and nothing has changed then.
void add_wall(WorldText& text, const Polyline& wall);
/// Walls along it (within a centimetre) get a gap as wide as the door. It is open from the start,
/// by an event of the tour.
void add_door(WorldText& text, const Point2& a, const Point2& b);
void add_box(WorldText& text, const Point2& middle, double side_m);
void add_person(WorldText& text, const Polyline& way);
/// At the end of the tour; velocities that were driven by hand give way to it.
void add_way_point(WorldText& text, const Point2& point);

/// Moves its points by that much; a point that begins and ends a closed wall stays one. A door
/// moved as a whole takes its gap along.
void move_item(WorldText& text, const WorldItem& item, const Point2& by_m);
/// Takes it out: of a wall the piece, or the point between two pieces; of a person's way the point,
/// else the person. A door gives back the wall that led straight to it, up to the wall at its other
/// side. The start stays.
void remove_item(WorldText& text, const WorldItem& item);

/// One of the numbers that say what an item is.
struct ItemNumber {
    std::string_view name;  ///< translated in the context "WorldItem"
    std::string_view unit;  ///< "m", "m/s", "°"
    double value = 0.0;
    friend bool operator==(const ItemNumber&, const ItemNumber&) = default;
};

/// Of a piece its length and direction, of a person's way speed and radius, else where it is.
std::vector<ItemNumber> numbers_of(const WorldText& text, const WorldItem& item);
/// Changes the number at that place. A piece is turned and made longer about its first point.
void set_number(WorldText& text, const WorldItem& item, std::size_t place, double value);

}  // namespace hitos
