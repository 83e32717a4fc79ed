// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/laser/simulated_laser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hitos {
namespace {

constexpr double kTurn = 2.0 * kPi;
/// A ray may miss a wall's end by this part of the wall's length and still hit it, so that none
/// slips through where two walls meet.
constexpr double kEndReach = 1e-12;

/// Range of the ray from the origin along the unit vector (cos, sin) to the segment a-b, both in
/// the laser frame; infinity where it passes.
double range_to(const Point2& a, const Point2& b, double cosine, double sine) {
    const double missed = std::numeric_limits<double>::infinity();
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    // a + s (b - a) = r u, solved by Cramer's rule.
    const double determinant = cosine * dy - sine * dx;
    if (determinant == 0.0) {
        // Along the wall: its nearer end, if the ray runs into it at all.
        const double near = std::min(a.x * cosine + a.y * sine, b.x * cosine + b.y * sine);
        return a.x * sine - a.y * cosine == 0.0 && near >= 0.0 ? near : missed;
    }
    const double s = (sine * a.x - cosine * a.y) / determinant;
    const double range = (a.x * dy - a.y * dx) / determinant;
    const bool hit = s >= -kEndReach && s <= 1.0 + kEndReach && range >= 0.0;
    return hit ? range : missed;
}

/// Bearing in [0, 2 pi) counted from the fan's first ray in the direction that it sweeps.
double from_first_ray(const Point2& point, double min_angle_rad, bool clockwise) {
    const double left = std::fmod(std::atan2(point.y, point.x) - min_angle_rad, kTurn);
    const double angle = clockwise ? -left : left;
    return angle < 0.0 ? angle + kTurn : angle;
}

}  // namespace

SimulatedLaser::SimulatedLaser(std::vector<WallSegment> walls, const Fan& fan)
    : walls_(std::move(walls)),
      fan_(fan),
      step_rad_(fan.count > 1 ? fan.step_rad() : 1.0),
      directions_(ray_directions(fan, 0.0, step_rad_)) {}

void SimulatedLaser::cast(const Pose& pose_world_robot, std::vector<RayHit>& out) const {
    out.assign(fan_.count, RayHit{});
    const Pose pose_world_laser = compose(pose_world_robot, fan_.pose_robot_laser);
    const Pose pose_laser_world = inverse(pose_world_laser);
    const Point2 laser{pose_world_laser.x, pose_world_laser.y};
    const bool clockwise = step_rad_ < 0.0;
    const double step = std::abs(step_rad_);
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        if (distance(walls_[i], laser) > fan_.max_range_m) continue;
        const Point2 a = transform(pose_laser_world, walls_[i].a);
        const Point2 b = transform(pose_laser_world, walls_[i].b);
        const auto offer = [&](double first, double last) {
            // One ray more on each side: the bearings are rounded, range_to() decides.
            const double low = std::max(0.0, std::ceil(first / step) - 1.0);
            const double high = std::min(fan_.count - 1.0, std::floor(last / step) + 1.0);
            if (high < low) return;
            const auto end = static_cast<std::size_t>(high) + 1;
            for (auto k = static_cast<std::size_t>(low); k < end; ++k) {
                const double range = range_to(a, b, directions_[k].x, directions_[k].y);
                RayHit& hit = out[k];
                if (range < hit.range_m && range <= fan_.max_range_m) {
                    hit = {range, static_cast<int>(i)};
                }
            }
        };
        double first = from_first_ray(a, fan_.min_angle_rad, clockwise);
        double last = from_first_ray(b, fan_.min_angle_rad, clockwise);
        if (first > last) std::swap(first, last);
        // A wall is seen under less than half a turn: the smaller of the two angles between its
        // ends, which may lie across the first ray. A fan of a whole turn has rays at both ends of
        // it, so every angle is offered a turn further too.
        constexpr double kHalf = kPi - 1e-9;
        const double seen = last - first;
        if (seen <= kHalf) {
            offer(first, last);
            offer(first + kTurn, last + kTurn);
        } else if (seen >= kTurn - kHalf) {
            offer(last - kTurn, first);
            offer(last, first + kTurn);
        } else {
            offer(0.0, kTurn);  // through the laser itself, where no angle says anything
        }
    }
}

RayHit SimulatedLaser::hit(const Pose& pose_world_robot, std::uint32_t ray) const {
    const Pose pose_laser_world = inverse(compose(pose_world_robot, fan_.pose_robot_laser));
    const Point2& direction = directions_[ray];
    RayHit hit;
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        const Point2 a = transform(pose_laser_world, walls_[i].a);
        const Point2 b = transform(pose_laser_world, walls_[i].b);
        const double range = range_to(a, b, direction.x, direction.y);
        if (range < hit.range_m && range <= fan_.max_range_m) hit = {range, static_cast<int>(i)};
    }
    return hit;
}

std::vector<Point2> ray_directions(const Fan& fan, double turned_rad, double step_rad) {
    std::vector<Point2> directions;
    directions.reserve(fan.count);
    for (std::uint32_t ray = 0; ray < fan.count; ++ray) {
        const double angle = turned_rad + fan.min_angle_rad + ray * step_rad;
        directions.push_back({std::cos(angle), std::sin(angle)});
    }
    return directions;
}

void interpolate(std::span<RayHit> hits, int n, double max_range_m) {
    const auto block = static_cast<std::size_t>(n);
    for (std::size_t from = 0; from + 1 < hits.size(); from += block) {
        const std::size_t to = std::min(from + block, hits.size() - 1);
        const double right = std::min(hits[from].range_m, max_range_m);
        const double left = std::min(hits[to].range_m, max_range_m);
        const bool bare = std::isinf(hits[from].range_m) && std::isinf(hits[to].range_m);
        const auto steps = static_cast<double>(to - from);
        for (std::size_t ray = from + 1; ray < to; ++ray) {
            hits[ray] = {};
            if (bare) continue;
            hits[ray].range_m = left - static_cast<double>(to - ray) * (left - right) / steps;
        }
    }
}

Fan fan_of(const LaserParams& laser) {
    const double half_rad = laser.field_of_view_deg / 360.0 * kPi;
    Fan fan;
    fan.min_angle_rad = -half_rad + laser.fan_turn_deg / 180.0 * kPi;
    fan.max_angle_rad = half_rad + laser.fan_turn_deg / 180.0 * kPi;
    if (laser.clockwise) std::swap(fan.min_angle_rad, fan.max_angle_rad);
    fan.count = static_cast<std::uint32_t>(laser.rays);
    fan.max_range_m = laser.max_range_m;
    fan.pose_robot_laser = {laser.mount_x_m, laser.mount_y_m,
                            laser.mount_heading_deg / 180.0 * kPi};
    return fan;
}

}  // namespace hitos
