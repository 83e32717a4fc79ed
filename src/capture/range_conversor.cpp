// SPDX-License-Identifier: GPL-3.0-or-later
#include "range_conversor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hitos {

void RangeConversor::Readings::clear() {
    time_s = 0.0;
    fan = {};
    max_is_exact = false;
    carries_odometry = false;
    ranges_m.clear();
    bearings_rad.clear();
    ray_times_s.clear();
}

RangeConversor::RangeConversor(ReadOptions options)
    : options_(std::move(options)), laser_pose_(laser_pose_of(options_.laser_pose)) {}

void RangeConversor::refuse_turns(const Fan& fan) const {
    constexpr double kMost = 4.0 * kPi;
    const double turn = std::abs(fan.max_angle_rad - fan.min_angle_rad) * options_.fan_scale;
    if (turn <= kMost) return;
    throw FormatError(
        {}, 0,
        HITOS_TEXT("Errors",
                   "its rays go over %1 degrees, expected no more than a turn; if its angles are "
                   "in degrees and not in radians: --set source.fan_scale=%2"),
        std::round(turn * kDegreesPerRadian), std::to_string(kRadiansPerDegree));
}

/// Puts the laser, and its rays' times, where the options say.
void RangeConversor::mount(Readings& readings) const {
    if (options_.ray_time_s != 0.0) {
        readings.ray_times_s.clear();
        for (std::size_t i = 0; i < readings.ranges_m.size(); ++i) {
            readings.ray_times_s.push_back(
                static_cast<float>(static_cast<double>(i) * options_.ray_time_s));
        }
    }
    if (!laser_pose_) return;
    Fan& fan = readings.fan;
    fan.pose_robot_laser = laser_pose_->pose_robot_laser;
    fan.upside_down = laser_pose_->upside_down;
    if (!laser_pose_->upside_down) return;
    fan.min_angle_rad = -fan.min_angle_rad;
    fan.max_angle_rad = -fan.max_angle_rad;
    for (double& bearing : readings.bearings_rad) bearing = -bearing;
}

double RangeConversor::limit(const Readings& readings) const {
    if (options_.max_range_m > 0.0) return options_.max_range_m;
    const double stated = readings.fan.max_range_m;
    if (stated > 0.0) {
        // A missing return is written as the maximum with the readings' three decimals.
        const double as_written = std::min(stated, std::round(stated * 1000.0) / 1000.0);
        // Scanners that state 81.92 write 81.91.
        const bool code_below = no_return_m_ && *no_return_m_ < as_written;
        return readings.max_is_exact || !code_below ? as_written : *no_return_m_ - kNoReturnMargin;
    }
    return no_return_m_ ? *no_return_m_ - kNoReturnMargin : kAssumedLimit;
}

void RangeConversor::point_along(const Fan& fan) {
    Fan key = fan;
    key.max_range_m = 0.0;
    if (key == directions_fan_ && directions_.size() == fan.count) return;
    directions_fan_ = key;
    directions_.resize(fan.count);
    const double step = fan.step_rad();
    for (std::size_t i = 0; i < directions_.size(); ++i) {
        const double angle =
            fan.pose_robot_laser.theta + fan.min_angle_rad + static_cast<double>(i) * step;
        directions_[i] = {std::cos(angle), std::sin(angle)};
    }
}

void RangeConversor::point_along(const Pose& pose_robot_laser,
                                 const std::vector<double>& bearings_rad) {
    directions_fan_ = {};
    directions_.resize(bearings_rad.size());
    for (std::size_t i = 0; i < bearings_rad.size(); ++i) {
        const double angle = pose_robot_laser.theta + bearings_rad[i];
        directions_[i] = {std::cos(angle), std::sin(angle)};
    }
}

bool RangeConversor::read(const RawLine& line, Readings& out) {
    if (!parse_scan(line, out)) return false;
    if (options_.range_scale != 1.0 || options_.range_offset_m != 0.0) {
        // To the micrometre: what is written as the greatest range is that, whatever the unit.
        const auto put_right = [this](double range) {
            const double metres = range * options_.range_scale + options_.range_offset_m;
            return std::round(metres * 1e6) * 1e-6;
        };
        for (double& range : out.ranges_m) {
            if (range > 0.0) range = put_right(range);
        }
        if (out.fan.max_range_m > 0.0) out.fan.max_range_m = put_right(out.fan.max_range_m);
    }
    if (out.fan.count > 0 || out.bearings_rad.empty()) {
        refuse_turns(out.fan);
    } else {  // irregular bearings
        const auto [least, greatest] = std::ranges::minmax(out.bearings_rad);
        refuse_turns({least, greatest, 0, 0.0, {}});
    }
    if (options_.fan_scale != 1.0) {
        out.fan.min_angle_rad *= options_.fan_scale;
        out.fan.max_angle_rad *= options_.fan_scale;
        for (double& bearing : out.bearings_rad) bearing *= options_.fan_scale;
    }
    return true;
}

std::optional<Scan> RangeConversor::scan(const RawLine& line) {
    readings_.clear();
    if (!read(line, readings_)) return std::nullopt;
    mount(readings_);
    const double greatest = limit(readings_);
    const Pose& mount = readings_.fan.pose_robot_laser;
    if (readings_.bearings_rad.empty()) {
        point_along(readings_.fan);
    } else {
        point_along(mount, readings_.bearings_rad);
    }

    Scan scan;
    scan.time_s = readings_.time_s;
    scan.fan = readings_.fan;
    if (options_.max_range_m > 0.0) scan.fan.max_range_m = options_.max_range_m;
    scan.line = line.number;
    scan.carries_odometry = readings_.carries_odometry;
    scan.points.reserve(readings_.ranges_m.size());
    scan.rays.reserve(readings_.ranges_m.size());
    bool run_open = false;
    for (std::size_t i = 0; i < readings_.ranges_m.size(); ++i) {
        const double range = readings_.ranges_m[i];
        if (!(range > options_.min_range_m && range < greatest)) {  // so that NaN is none
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        scan.points.push_back(
            {mount.x + range * directions_[i].x, mount.y + range * directions_[i].y});
        scan.rays.push_back(static_cast<std::uint32_t>(i));
        if (!readings_.ray_times_s.empty()) scan.times_s.push_back(readings_.ray_times_s[i]);
    }
    return scan;
}

Fan fan_of_bearings(const std::vector<double>& bearings_rad) {
    constexpr double kRegular = 1e-4;  // bearings are logged with four or five decimals
    if (bearings_rad.empty()) return {};
    Fan fan;
    fan.min_angle_rad = bearings_rad.front();
    fan.max_angle_rad = bearings_rad.back();
    fan.count = static_cast<std::uint32_t>(bearings_rad.size());
    if (fan.count == 1) return fan;
    const double step = (fan.max_angle_rad - fan.min_angle_rad) / (fan.count - 1);
    if (std::abs(step) < kRegular) return {};
    for (std::size_t i = 0; i < bearings_rad.size(); ++i) {
        const double regular = fan.min_angle_rad + static_cast<double>(i) * step;
        if (std::abs(bearings_rad[i] - regular) > kRegular) return {};
    }
    return fan;
}

}  // namespace hitos
