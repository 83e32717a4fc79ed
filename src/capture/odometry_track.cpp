// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/odometry_track.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {

void OdometryTrack::read_to(double time_s) {
    constexpr double kKept = 20.0;
    while (!ended_ && (knots_.empty() || knots_.back().time_s < time_s)) {
        const std::optional<Odometria> reading = next_();
        if (!reading) {
            ended_ = true;
            break;
        }
        Knot knot{reading->time_s, {}, reading->twist};
        if (!knots_.empty()) {
            const Knot& last = knots_.back();
            knot.pose = compose(last.pose, displacement(knot.twist, knot.time_s - last.time_s));
        }
        knots_.push_back(knot);
    }
    while (knots_.size() > 2 && knots_[1].time_s < time_s - kKept) knots_.pop_front();
}

Pose OdometryTrack::at(double time_s) {
    constexpr double kGoesOn = 1.0;
    read_to(time_s);
    if (knots_.empty()) return {};
    const auto after = std::ranges::lower_bound(knots_, time_s, {}, &Knot::time_s);
    if (after == knots_.begin()) return after->pose;
    const Knot& before = *(after - 1);
    const bool beyond = after == knots_.end();
    const double seconds = time_s - before.time_s;
    return compose(before.pose, displacement(beyond ? before.twist : after->twist,
                                             beyond ? std::min(seconds, kGoesOn) : seconds));
}

namespace {

/// The ray of a fan nearest to a bearing in the laser's frame; `otherwise` where it lies outside.
std::uint32_t nearest_ray(const Fan& fan, double bearing, std::uint32_t otherwise) {
    const double step = fan.step_rad();
    if (step == 0.0) return otherwise;
    const double middle = (fan.min_angle_rad + fan.max_angle_rad) / 2.0;
    const double from_middle = wrap_angle(bearing - middle);
    double ray = std::round((middle + from_middle - fan.min_angle_rad) / step);
    if (fan.closed()) ray = ray < 0.0 ? ray + fan.count : std::fmod(ray, fan.count);
    return ray >= 0.0 && ray < fan.count ? static_cast<std::uint32_t>(ray) : otherwise;
}

}  // namespace

void unwarp(Scan& scan, OdometryTrack& track) {
    const Pose odom_scan = track.at(scan.time_s);
    const Pose laser_robot = inverse(scan.fan.pose_robot_laser);
    for (std::size_t i = 0; i < scan.times_s.size(); ++i) {
        const Pose odom_ray = track.at(scan.time_s + static_cast<double>(scan.times_s[i]));
        Point2& point = scan.points[i];
        point = transform(between(odom_scan, odom_ray), point);
        const Point2 seen = transform(laser_robot, point);
        scan.rays[i] = nearest_ray(scan.fan, std::atan2(seen.y, seen.x), scan.rays[i]);
    }
    scan.times_s.clear();
}

}  // namespace hitos
