// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/seen_wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "wall_finder.hpp"

namespace hitos {
namespace {

constexpr double kAside = 3.0 * kPi / 180.0;
constexpr double kAcross = 0.1;           // [m] from the line
constexpr double kGapInWall = 0.6;        // [m] between neighbours along it, narrower than a door
constexpr double kShortest = 0.5;         // [m]
constexpr double kLeastCosine = 0.94;     // of the angle between a point's normal and the wall's
constexpr std::size_t kFewestOfWall = 6;  // points

double bearing_of(const SurfacePoint& p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
}

/// A line by a point on it and the unit normal towards the laser.
struct Line {
    Point2 at;
    Point2 normal;

    double away(const SurfacePoint& p) const {
        return (static_cast<double>(p.x) - at.x) * normal.x +
               (static_cast<double>(p.y) - at.y) * normal.y;
    }
    /// To the left, as who looks at it has it.
    double along(const SurfacePoint& p) const {
        return (static_cast<double>(p.x) - at.x) * normal.y -
               (static_cast<double>(p.y) - at.y) * normal.x;
    }
    Point2 place(double along_m) const {
        return {at.x + along_m * normal.y, at.y - along_m * normal.x};
    }
};

/// A point of the scan beside a line.
struct Support {
    double along;
    std::size_t point;
};

/// The points of the line that hang together with the one at `seed`, to the left.
std::vector<Support> support_of(std::span<const SurfacePoint> points, const Line& line,
                                std::size_t seed) {
    std::vector<Support> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& p = points[i];
        const double cosine =
            static_cast<double>(p.nx) * line.normal.x + static_cast<double>(p.ny) * line.normal.y;
        if (i != seed && (std::abs(line.away(p)) > kAcross || cosine < kLeastCosine)) continue;
        all.push_back({line.along(p), i});
    }
    std::ranges::sort(all, [](const Support& a, const Support& b) {
        return a.along < b.along || (a.along == b.along && a.point < b.point);
    });
    const auto middle = std::ranges::find(all, seed, &Support::point);
    auto begin = middle;
    while (begin != all.begin() && begin->along - (begin - 1)->along <= kGapInWall) --begin;
    auto end = middle + 1;
    while (end != all.end() && end->along - (end - 1)->along <= kGapInWall) ++end;
    return {begin, end};
}

/// Through points with the least squares of their distances.
Line fitted(std::span<const SurfacePoint> points, std::span<const Support> support,
            const Line& before) {
    const auto n = static_cast<double>(support.size());
    Line line = before;
    double along = 0.0;
    double away = 0.0;
    for (const Support& one : support) {
        along += one.along / n;
        away += before.away(points[one.point]) / n;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (const Support& one : support) {
        xx += (one.along - along) * (one.along - along);
        xy += (one.along - along) * (before.away(points[one.point]) - away);
    }
    if (!(xx > 0.0)) return before;
    const Point2 on = before.place(along);
    line.at = {on.x + away * before.normal.x, on.y + away * before.normal.y};
    // The line turns by its slope against the one before.
    const double turn = std::atan(xy / xx);
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    line.normal = {c * before.normal.x - s * before.normal.y,
                   s * before.normal.x + c * before.normal.y};
    return line;
}

std::optional<SeenWall> wall_about(std::span<const SurfacePoint> points, std::size_t seed) {
    constexpr int kRounds = 5;
    const SurfacePoint& p = points[seed];
    Line line{{static_cast<double>(p.x), static_cast<double>(p.y)},
              {static_cast<double>(p.nx), static_cast<double>(p.ny)}};
    std::vector<Support> support;
    for (int round = 0; round < kRounds; ++round) {
        support = support_of(points, line, seed);
        line = fitted(points, support, line);
    }
    const double from = line.along(points[support.front().point]);
    const double to = line.along(points[support.back().point]);
    if (support.size() < kFewestOfWall || to - from < kShortest) return std::nullopt;
    return SeenWall{line.place(to), line.place(from),
                    bearing_of(points[support[support.size() / 2].point])};
}

}  // namespace

std::optional<SeenWall> find_wall(std::span<const SurfacePoint> points, const Pose& eye,
                                  double bearing_rad) {
    double nearest = kAside;
    std::optional<std::size_t> seed;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].has_normal()) continue;
        const double bearing = std::atan2(static_cast<double>(points[i].y) - eye.y,
                                          static_cast<double>(points[i].x) - eye.x) -
                               eye.theta;
        const double aside = std::abs(wrap_angle(bearing - bearing_rad));
        if (aside >= nearest) continue;
        nearest = aside;
        seed = i;
    }
    return seed ? wall_about(points, *seed) : std::nullopt;
}

std::optional<SeenWall> seen_wall(const Scan& scan, double range_m, double bearing_rad) {
    std::vector<SurfacePoint> points;
    find_surface_points(scan, range_m, points);
    return find_wall(points, {}, bearing_rad);
}

std::vector<SeenWall> seen_walls(const Scan& scan, double range_m) {
    constexpr double kSame = 0.3;  // [m] between the ends of one that was found from two points
    std::vector<SurfacePoint> points;
    find_surface_points(scan, range_m, points);
    std::vector<SeenWall> walls;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].has_normal()) continue;
        const auto about = wall_about(points, i);
        if (!about) continue;
        // By its bearing, as it will be found again.
        const auto wall = find_wall(points, {}, about->bearing);
        if (!wall || std::ranges::any_of(walls, [&](const SeenWall& one) {
                return distance(one.left, wall->left) < kSame &&
                       distance(one.right, wall->right) < kSame;
            })) {
            continue;
        }
        walls.push_back(*wall);
    }
    return walls;
}

}  // namespace hitos
