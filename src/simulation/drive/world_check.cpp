// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/world_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/driven_path.hpp"

namespace hitos {
namespace {

constexpr double kJoint = 1e-3;  // m, by which walls reach beyond their ends

/// The widest angle that no wall covers, seen from a point.
std::optional<double> way_out(const std::vector<WallSegment>& walls, const Point2& from) {
    std::vector<std::pair<double, double>> covered;  // from, to, counter-clockwise
    covered.reserve(walls.size() + 1);
    for (const WallSegment& wall : walls) {
        const double length = std::hypot(wall.b.x - wall.a.x, wall.b.y - wall.a.y);
        const double dx = (wall.b.x - wall.a.x) * kJoint / length;
        const double dy = (wall.b.y - wall.a.y) * kJoint / length;
        double a = std::atan2(wall.a.y - dy - from.y, wall.a.x - dx - from.x);
        double b = std::atan2(wall.b.y + dy - from.y, wall.b.x + dx - from.x);
        if (a > b) std::swap(a, b);
        if (b - a <= kPi) {
            covered.emplace_back(a, b);
        } else {  // round the back
            covered.emplace_back(-kPi, a);
            covered.emplace_back(b, kPi);
        }
    }
    if (covered.empty()) return 0.0;
    std::ranges::sort(covered);
    // An opening round the back is met at its end.
    double seen = covered.front().first;
    double widest = 0.0;
    std::optional<double> found;
    for (const auto& [begin, end] : covered) {
        if (begin - seen > widest) {
            widest = begin - seen;
            found = seen + widest / 2.0;
        }
        seen = std::max(seen, end);
    }
    const double back = covered.front().first + 2.0 * kPi - seen;
    if (back > widest) found = wrap_angle(seen + back / 2.0);
    return found;
}

/// With closed doors, and the boxes that stand there.
std::vector<WallSegment> walls_at_first(const World& world) {
    std::vector<WallSegment> walls = world.walls;
    walls.insert(walls.end(), world.doors.begin(), world.doors.end());
    for (const Disturbance& event : world.tour.events) {
        if (event.kind != DisturbanceKind::box || event.at_s > 0.0) continue;
        const Polyline outline = box_outline(event);
        for (std::size_t i = 1; i < outline.size(); ++i) {
            walls.push_back({outline[i - 1], outline[i], 0, event.line});
        }
    }
    return walls;
}

}  // namespace

WorldCheck check_world(const World& world) {
    const std::vector<WallSegment> walls = walls_at_first(world);
    const Point2 start{world.tour.start.x, world.tour.start.y};
    WorldCheck check;
    check.nearest_m = std::numeric_limits<double>::infinity();
    for (const WallSegment& wall : walls)
        check.nearest_m = std::min(check.nearest_m, distance(wall, start));
    for (std::size_t i = 0; i < world.landmarks.radii_m.size(); ++i) {
        check.nearest_m = std::min(
            check.nearest_m, distance(world.landmarks.at[i], start) - world.landmarks.radii_m[i]);
    }
    check.start_free = check.nearest_m >= world.robot.radius_m;
    check.way_out_rad = way_out(walls, start);
    check.has_tour = !world.tour.way_points.empty() || !world.tour.commands.empty();
    if (check.has_tour) {
        try {
            drive(world);
        } catch (const Error& error) {
            check.tour_problem = error.message();
        }
    }
    return check;
}

std::vector<Message> sentences_of(const WorldCheck& check, const World& world) {
    const std::string nearest = fmt::format("{:.3f}", check.nearest_m);
    const std::string radius = fmt::format("{:g}", world.robot.radius_m);
    std::vector<Message> sentences;
    sentences.push_back(
        check.start_free
            ? message(HITOS_TEXT("Errors", "start: free, %1 m from what is nearest"), nearest)
            : message(HITOS_TEXT("Errors",
                                 "start: %1 m from what is nearest, expected at least the robot's "
                                 "radius of %2 m"),
                      nearest, radius));
    sentences.push_back(
        check.closed()
            ? message(HITOS_TEXT("Errors", "room: closed, every ray from the start meets a wall"))
            : message(HITOS_TEXT("Errors",
                                 "room: open, a ray from the start at %1 degrees meets no wall"),
                      fmt::format("{:.1f}", *check.way_out_rad * 180.0 / kPi)));
    sentences.insert(sentences.end(), world.drawing_warnings.begin(), world.drawing_warnings.end());
    if (!check.has_tour) {
        sentences.push_back(message(
            HITOS_TEXT("Errors", "tour: none yet; it can be driven by hand, or given way points")));
    } else if (check.tour_problem.empty()) {
        sentences.push_back(message(HITOS_TEXT("Errors", "tour: hits no wall")));
    } else {
        sentences.push_back(message(HITOS_TEXT("Errors", "tour: %1"), check.tour_problem));
    }
    return sentences;
}

}  // namespace hitos
