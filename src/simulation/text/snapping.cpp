// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/text/snapping.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hitos {
namespace {

double to_step(double value, double step) {
    return step > 0.0 ? std::round(value / step) * step : value;
}

/// Keeps what is nearest to the cursor and near enough.
class Nearest {
  public:
    Nearest(const Point2& cursor, double reach_m) : cursor_(cursor), reach_(reach_m) {}

    /// `place` is what is kept where `near` is near.
    void offer(const Point2& near, const Snapped& place) {
        const double away = distance(cursor_, near);
        if (away > reach_) return;
        reach_ = away;
        found_ = place;
    }
    const std::optional<Snapped>& found() const { return found_; }

  private:
    Point2 cursor_;
    double reach_;
    std::optional<Snapped> found_;
};

/// A straight line by a point of it and its direction, of length 1.
struct Direction {
    Point2 from;
    Point2 along;

    double way_to(const Point2& point) const {
        return (point.x - from.x) * along.x + (point.y - from.y) * along.y;
    }
    Point2 at(double way) const { return {from.x + way * along.x, from.y + way * along.y}; }
    /// How far along it crosses the wall, if it does.
    std::optional<double> crossing(const WallSegment& wall) const {
        const Point2 w{wall.b.x - wall.a.x, wall.b.y - wall.a.y};
        const double across = along.x * w.y - along.y * w.x;
        if (across == 0.0) return std::nullopt;
        const Point2 to{wall.a.x - from.x, wall.a.y - from.y};
        const double share = (to.x * along.y - to.y * along.x) / across;
        if (!(share >= 0.0 && share <= 1.0)) return std::nullopt;
        return (to.x * w.y - to.y * w.x) / across;
    }
};

Direction ray_between(const Point2& a, const Point2& b) {
    const double length = distance(a, b);
    return {a, {(b.x - a.x) / length, (b.y - a.y) / length}};
}

std::optional<Snapped> nearest_end(std::span<const WallSegment> walls, std::span<const Point2> ends,
                                   const Point2& cursor, const SnapOptions& options) {
    Nearest nearest(cursor, options.reach_m);
    for (const Point2& end : ends) nearest.offer(end, {end, SnappedTo::end});
    if (!options.to_walls) return nearest.found();
    for (const WallSegment& wall : walls) {
        nearest.offer(wall.a, {wall.a, SnappedTo::end});
        nearest.offer(wall.b, {wall.b, SnappedTo::end});
    }
    return nearest.found();
}

/// Along the axes, or along or across the piece before; up to a wall that is met near the cursor.
std::optional<Snapped> right_angle(std::span<const WallSegment> walls, const Point2& cursor,
                                   const SnapFrom& from, const SnapOptions& options) {
    if (!options.right_angles || !from.point) return std::nullopt;
    const Point2 origin = *from.point;
    std::vector<Direction> rays = {{origin, {1.0, 0.0}}, {origin, {0.0, 1.0}}};
    if (from.before && *from.before != origin) {
        const Point2 along = ray_between(*from.before, origin).along;
        rays.push_back({origin, along});
        rays.push_back({origin, {-along.y, along.x}});
    }
    Nearest nearest(cursor, options.reach_m);
    for (const Direction& ray : rays) {
        const double way = ray.way_to(cursor);
        const double step = to_step(way, options.grid_m);
        if (step != 0.0) nearest.offer(ray.at(way), {ray.at(step), SnappedTo::right_angle});
    }
    const auto found = nearest.found();
    if (!found || !options.to_walls) return found;
    Nearest wall_there(cursor, options.reach_m);
    const Direction taken = ray_between(origin, found->at);
    for (const WallSegment& wall : walls) {
        const auto way = taken.crossing(wall);
        if (way && *way > 0.0) wall_there.offer(taken.at(*way), {taken.at(*way), SnappedTo::wall});
    }
    return wall_there.found() ? wall_there.found() : found;
}

std::optional<Snapped> onto_wall(std::span<const WallSegment> walls, const Point2& cursor,
                                 const SnapOptions& options) {
    if (!options.to_walls) return std::nullopt;
    Nearest nearest(cursor, options.reach_m);
    for (const WallSegment& wall : walls) {
        const Direction ray = ray_between(wall.a, wall.b);
        const double length = distance(wall.a, wall.b);
        const double way = ray.way_to(cursor);
        const double step = std::clamp(to_step(way, options.grid_m), 0.0, length);
        nearest.offer(ray.at(std::clamp(way, 0.0, length)), {ray.at(step), SnappedTo::wall});
    }
    return nearest.found();
}

}  // namespace

Point2 to_the_micrometre(const Point2& point) {
    constexpr double kDigit = 1e6;
    // 0.0 is added so that no zero has a sign.
    return {std::round(point.x * kDigit) / kDigit + 0.0,
            std::round(point.y * kDigit) / kDigit + 0.0};
}

Snapped snap(std::span<const WallSegment> walls, std::span<const Point2> ends, const Point2& cursor,
             const SnapFrom& from, const SnapOptions& options) {
    if (const auto end = nearest_end(walls, ends, cursor, options)) return *end;
    auto place = right_angle(walls, cursor, from, options);
    if (!place) place = onto_wall(walls, cursor, options);
    if (!place && options.grid_m > 0.0) {
        place = Snapped{{to_step(cursor.x, options.grid_m), to_step(cursor.y, options.grid_m)},
                        SnappedTo::grid};
    }
    if (!place) place = Snapped{cursor, SnappedTo::nothing};
    place->at = to_the_micrometre(place->at);
    return *place;
}

}  // namespace hitos
