// SPDX-License-Identifier: GPL-3.0-or-later
// Scans of straight walls, drawn ray by ray, for the tests of registration.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/features/control.hpp"
#include "surface_points.hpp"

namespace hitos::test {

/// Closed polygons and single walls as pairs of ends.
inline Walls closed(const std::vector<Point2>& corners) {
    Walls walls;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        walls.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
    }
    return walls;
}

inline double range_to(const Walls& walls, const Pose& pose, double angle) {
    const double c = std::cos(pose.theta + angle);
    const double s = std::sin(pose.theta + angle);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : walls) {
        const double wx = b.x - a.x;
        const double wy = b.y - a.y;
        const double det = c * -wy + s * wx;
        if (std::abs(det) < 1e-12) continue;
        const double dx = a.x - pose.x;
        const double dy = a.y - pose.y;
        const double t = (dx * -wy + dy * wx) / det;
        const double u = (c * dy - s * dx) / det;
        if (t > 0.0 && u >= 0.0 && u <= 1.0) nearest = std::min(nearest, t);
    }
    return nearest;
}

/// Normal noise of `sigma` on ranges where there is an engine.
inline Scan drawn_scan(const Walls& walls, const Pose& pose, const Fan& fan, double sigma = 0.0,
                       std::mt19937* engine = nullptr) {
    Scan scan;
    scan.fan = fan;
    std::normal_distribution<double> normal;
    bool running = false;
    for (std::uint32_t ray = 0; ray < scan.fan.count; ++ray) {
        const double angle = scan.fan.angle_rad(ray);
        double range = range_to(walls, pose, angle);
        if (!(range < fan.max_range_m)) {
            running = false;
            continue;
        }
        if (engine != nullptr) range += sigma * normal(*engine);
        if (!running) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        running = true;
        scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
        scan.rays.push_back(ray);
    }
    return scan;
}

/// 181 rays over half a turn.
inline Scan drawn_scan(const Walls& walls, const Pose& pose, double sigma = 0.0,
                       std::mt19937* engine = nullptr, double furthest = 30.0) {
    return drawn_scan(walls, pose, {-kPi / 2.0, kPi / 2.0, 181, furthest, {}}, sigma, engine);
}

inline std::vector<SurfacePoint> drawn_points(const Walls& walls, const Pose& pose,
                                              double sigma = 0.0, std::mt19937* engine = nullptr) {
    std::vector<SurfacePoint> points;
    find_surface_points(drawn_scan(walls, pose, sigma, engine), 80.0, points);
    return points;
}

/// The control that drives from one pose to the next in a second.
inline Control control_between(const Pose& from, const Pose& to) {
    return {twist_between(between(from, to), 1.0), 1.0};
}

/// A room of 8 m x 6 m with a recess, unlike itself turned or shifted.
inline Walls recess_room() {
    return closed({{-4, -3}, {4, -3}, {4, 1}, {2.5, 1}, {2.5, 3}, {-1, 3}, {-1, 2}, {-4, 2}});
}

}  // namespace hitos::test
