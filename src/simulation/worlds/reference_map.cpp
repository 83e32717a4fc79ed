// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/worlds/reference_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace hitos {
namespace {

/// Drawings are exact to their rounding: below these, two walls are on one line, two points one.
constexpr double kSamePlace = 1e-6;  // m
constexpr double kSameAngle = 1e-6;  // rad

/// The wall's infinite line. A wall along an axis gives the very digits it was drawn with, where
/// the general formula may cost the last one.
Recta line_of(const WallSegment& wall) {
    if (wall.a.x == wall.b.x) return normalized({wall.a.x, 0.0});
    if (wall.a.y == wall.b.y) return normalized({wall.a.y, kPi / 2.0});
    return line_through(wall.a, wall.b);
}

/// The point that two walls of different directions share.
std::optional<Point2> shared_point(const WallSegment& one, const WallSegment& other) {
    const Point2 d{one.b.x - one.a.x, one.b.y - one.a.y};
    const Point2 e{other.b.x - other.a.x, other.b.y - other.a.y};
    const double determinant = d.x * e.y - d.y * e.x;
    if (std::abs(determinant) <= kSameAngle * std::hypot(d.x, d.y) * std::hypot(e.x, e.y)) {
        return std::nullopt;
    }
    // An end of a wall that lies on the other one is taken as it was drawn, digit by digit.
    for (const Point2& end : {one.a, one.b}) {
        if (distance(other, end) <= kSamePlace) return end;
    }
    for (const Point2& end : {other.a, other.b}) {
        if (distance(one, end) <= kSamePlace) return end;
    }
    const Point2 gap{other.a.x - one.a.x, other.a.y - one.a.y};
    const double s = (gap.x * e.y - gap.y * e.x) / determinant;
    const double t = (gap.x * d.y - gap.y * d.x) / determinant;
    if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return std::nullopt;
    return Point2{one.a.x + s * d.x, one.a.y + s * d.y};
}

void add_marks(const World& world, const Pose& pose_start_world, LandmarkMap& map) {
    const MarkParams& marks = world.landmarks;
    std::int32_t identity = 0;
    for (const Point2& mark : marks.at) {
        const Point2 point = transform(pose_start_world, mark);
        ICaracteristica& landmark = map.emplace_back();
        landmark.value = Esquina{point.x, point.y};
        if (marks.told() && marks.identities) landmark.identity = identity++;
    }
}

}  // namespace

LandmarkMap reference_map(const World& world) {
    const Pose pose_start_world = inverse(world.tour.start);
    LandmarkMap map;
    if (world.landmarks.told()) {
        add_marks(world, pose_start_world, map);
        return map;
    }
    std::vector<WallSegment> walls = world.walls;
    for (WallSegment& wall : walls) {
        wall.a = transform(pose_start_world, wall.a);
        wall.b = transform(pose_start_world, wall.b);
    }
    std::vector<Recta> lines;
    for (const WallSegment& wall : walls) {
        // The ends against the line, not the angles: rounding turns a short wall by more.
        const bool known = std::ranges::any_of(lines, [&](const Recta& line) {
            return std::abs(signed_distance(line, wall.a)) <= kSamePlace &&
                   std::abs(signed_distance(line, wall.b)) <= kSamePlace;
        });
        if (!known) lines.push_back(line_of(wall));
    }
    std::vector<Point2> corners;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (std::size_t k = i + 1; k < walls.size(); ++k) {
            const std::optional<Point2> point = shared_point(walls[i], walls[k]);
            if (!point) continue;
            const bool known = std::ranges::any_of(corners, [&](const Point2& corner) {
                return std::hypot(corner.x - point->x, corner.y - point->y) <= kSamePlace;
            });
            if (!known) corners.push_back(*point);
        }
    }
    for (const Recta& line : lines) map.push_back({line});
    for (const Point2& corner : corners) map.push_back({Esquina{corner.x, corner.y}});
    add_marks(world, pose_start_world, map);
    return map;
}

}  // namespace hitos
