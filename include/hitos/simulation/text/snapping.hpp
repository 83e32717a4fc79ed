// SPDX-License-Identifier: GPL-3.0-or-later
// Where a point is meant to be that is drawn near something: ends, walls, right angles, a grid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hitos/base/geometry.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// Lengths in metres.
struct SnapOptions {
    double grid_m = 0.1;   ///< multiples of it; 0: there is no grid
    double reach_m = 0.2;  ///< what is further from the cursor draws it no more
    bool to_walls = true;  ///< to ends of walls and onto them
    bool right_angles = true;
};

enum class SnappedTo : std::uint8_t { nothing, grid, end, wall, right_angle };

/// Where a cursor was drawn to, and by what.
struct Snapped {
    Point2 at;
    SnappedTo to = SnappedTo::nothing;
};

/// What a line is drawn from, if it is one.
struct SnapFrom {
    std::optional<Point2> point;
    /// The point before that one: right angles are those of the axes and of this piece.
    std::optional<Point2> before;
};

/// The point that `cursor` stands for. Ends come first, those of walls and `ends`; then right
/// angles to what is drawn, by whole steps of the grid from its point; then the nearest wall; then
/// the grid. Coordinates are of whole micrometres but for those of ends.
Snapped snap(std::span<const WallSegment> walls, std::span<const Point2> ends, const Point2& cursor,
             const SnapFrom& from, const SnapOptions& options);

/// To the micrometre, so that no digits of arithmetic get into files.
Point2 to_the_micrometre(const Point2& point);

}  // namespace hitos
