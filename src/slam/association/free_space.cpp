// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_space.hpp"

#include <cmath>

#include "models/sensor_recta.hpp"

namespace hitos {
namespace {

constexpr std::size_t kMostRays = 120;
/// A reading that much beyond a landmark, or before it, is not the landmark's.
constexpr double kBeyond = 0.3;
/// The ends of an extent scatter as the poses do from which they were seen.
constexpr double kEnds = 0.2;
/// Rays along a wall may miss it by a small error of its angle: the cosine of the steepest.
constexpr double kSteepest = 0.26;
/// How far beside a corner a ray may pass it.
constexpr double kBeside = 0.15;

}  // namespace

void FreeSpace::set(const Scan& scan) {
    mounting_ = scan.fan.pose_robot_laser;
    const Pose robot = inverse(mounting_);
    rays_.clear();
    const std::size_t every = (scan.points.size() + kMostRays - 1) / kMostRays;
    for (std::size_t i = 0; i < scan.points.size(); i += every) {
        const Point2 hit = transform(robot, scan.points[i]);
        const double range = std::hypot(hit.x, hit.y);
        if (range > 0.0) rays_.push_back({hit.x / range, hit.y / range, range});
    }
}

Sight FreeSpace::sight(const Pose& laser, const Recta& line, const Extent& extent) const {
    constexpr int kFewest = 5;
    if (!std::isfinite(extent.low) || !std::isfinite(extent.high)) return Sight::unknown;
    const Pose world = inverse(laser);
    const Recta local = SensorRecta::moved(world, line);  // rho may be negative: no matter
    const Extent along = SensorRecta::moved(world, line, extent);
    const double c = std::cos(local.theta);
    const double s = std::sin(local.theta);
    const double low = along.low + kEnds;
    const double high = along.high - kEnds;
    int through = 0;
    int all = 0;
    for (const Ray& ray : rays_) {
        const double towards = ray.cosine * c + ray.sine * s;
        if (std::abs(towards) < kSteepest) continue;
        const double range = local.rho / towards;
        const double place = range * (ray.sine * c - ray.cosine * s);
        if (range < kBeyond || place < low || place > high) continue;
        if (ray.range < range - kBeyond) continue;  // something stands before it
        ++all;
        if (ray.range > range + kBeyond) ++through;
    }
    return through >= kFewest && 10 * through >= 9 * all ? Sight::missing : Sight::unknown;
}

Sight FreeSpace::sight(const Pose& laser, const Esquina& corner, const Extent& /*extent*/) const {
    constexpr int kFewest = 2;
    const Esquina local = transform(inverse(laser), corner);
    int through = 0;
    for (const Ray& ray : rays_) {
        const double ahead = local.x * ray.cosine + local.y * ray.sine;
        const double beside = local.y * ray.cosine - local.x * ray.sine;
        if (ahead < kBeyond || std::abs(beside) > kBeside) continue;
        if (ray.range < ahead + kBeyond) return Sight::unknown;
        ++through;
    }
    return through >= kFewest ? Sight::missing : Sight::unknown;
}

}  // namespace hitos
