// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "hitos/base/geometry.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {
namespace {

double cross(const Point2& a, const Point2& b) {
    return a.x * b.y - a.y * b.x;
}
Point2 minus(const Point2& a, const Point2& b) {
    return {a.x - b.x, a.y - b.y};
}

}  // namespace

double distance(const WallSegment& wall, const Point2& point) {
    const Point2 along = minus(wall.b, wall.a);
    const Point2 to = minus(point, wall.a);
    const double length2 = along.x * along.x + along.y * along.y;
    const double t = std::clamp((to.x * along.x + to.y * along.y) / length2, 0.0, 1.0);
    return std::hypot(to.x - t * along.x, to.y - t * along.y);
}

double distance(const WallSegment& wall, const Point2& from, const Point2& to) {
    if (from == to) return distance(wall, from);
    const Point2 along = minus(wall.b, wall.a);
    const Point2 way = minus(to, from);
    const bool wall_is_cut =
        (cross(way, minus(wall.a, from)) > 0.0) != (cross(way, minus(wall.b, from)) > 0.0);
    const bool way_is_cut =
        (cross(along, minus(from, wall.a)) > 0.0) != (cross(along, minus(to, wall.a)) > 0.0);
    if (wall_is_cut && way_is_cut) return 0.0;
    // Segments that do not cross are nearest at an end of one of them.
    const WallSegment driven{from, to, 0, 0};
    return std::min({distance(wall, from), distance(wall, to), distance(driven, wall.a),
                     distance(driven, wall.b)});
}

Polyline box_outline(const Disturbance& box) {
    const double half = box.values[2] / 2.0;
    const auto corner = [&](double x, double y) {
        return Point2{box.values[0] + x * half, box.values[1] + y * half};
    };
    return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)};
}

}  // namespace hitos
