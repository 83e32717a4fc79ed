// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/laser_fan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fan_fit.hpp"
#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr float kNoReading = std::numeric_limits<float>::quiet_NaN();

/// How far off its ray a bearing may lie, in steps: of lasers that are mounted apart by an angle
/// that is no whole number of steps, the rays of one would be bent.
constexpr double kOffRay = 0.05;

}  // namespace

MountedScan mounted_scan(const LaserScanMessage& scan, const Transform& robot_laser) {
    constexpr double kTilt = 3.0 * kPi / 180.0;
    const double upward = robot_laser.upward();
    if (!(std::abs(upward) >= std::cos(kTilt))) {
        const double tilt = std::acos(std::clamp(std::abs(upward), 0.0, 1.0)) * 180.0 / kPi;
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors",
                                     "the laser \"%1\" is tilted by %2°; expected one that is "
                                     "level or upside down, to 3°"),
                          scan.header.frame, std::round(tilt));
    }
    const auto rays = static_cast<std::uint32_t>(scan.ranges_m.size());
    if (rays > 1 && !(std::abs(scan.step_rad) > 0.0)) {
        throw FormatError(
            {}, 0, HITOS_TEXT("Errors", "field \"%1\": found %2, expected a step between rays"),
            "angle_increment", scan.step_rad);
    }
    MountedScan mounted;
    mounted.stamp_ns = scan.header.stamp_ns;
    mounted.fan.pose_robot_laser = robot_laser.plane();
    mounted.fan.count = rays;
    mounted.fan.upside_down = upward < 0.0;
    double least = scan.min_range_m;
    double greatest = scan.max_range_m;
    mounted.swapped_limits = greatest > 0.0 && greatest < least && std::isfinite(least);
    if (mounted.swapped_limits) std::swap(least, greatest);
    mounted.least_range_m = least;
    if (std::isfinite(greatest)) mounted.fan.max_range_m = std::max(0.0, greatest);
    mounted.ranges_m = scan.ranges_m;
    if (mounted.fan.max_range_m > 0.0)
        mounted.walls_beyond.note(scan.ranges_m, mounted.fan.max_range_m);
    for (float& range : mounted.ranges_m) {
        const bool measured = std::isfinite(range) && range > 0.0F;
        if (measured) ++mounted.readings;
        if (measured && static_cast<double>(range) < least) ++mounted.too_near;
        if (!measured || static_cast<double>(range) < least) range = kNoReading;
    }
    if (scan.ray_time_s != 0.0) {
        for (std::uint32_t i = 0; i < rays; ++i) {
            mounted.ray_times_s.push_back(static_cast<float>(i * scan.ray_time_s));
        }
    }
    // Seen from above, a laser upside down turns the other way round.
    const double sense = mounted.fan.upside_down ? -1.0 : 1.0;
    double first = sense * scan.min_angle_rad;
    double last = sense * (scan.min_angle_rad + (rays - 1) * scan.step_rad);
    if (last < first) {
        mounted.clockwise = true;
        std::swap(first, last);
        std::ranges::reverse(mounted.ranges_m);
        std::ranges::reverse(mounted.ray_times_s);
    }
    mounted.fan.min_angle_rad = first;
    mounted.fan.max_angle_rad = last;
    return mounted;
}

std::optional<MountedScan> merged(const MountedScan& a, const MountedScan& b) {
    constexpr std::int64_t kOneTimeNs = 1'000'000;
    constexpr double kOnePlace = 1e-3;
    const Fan& fan = a.fan;
    const Pose& here = fan.pose_robot_laser;
    const Pose& there = b.fan.pose_robot_laser;
    const double step = fan.step_rad();
    const double other = b.fan.step_rad();
    const auto most = static_cast<double>(std::max(a.fan.count, b.fan.count));
    const bool alike = std::abs(a.stamp_ns - b.stamp_ns) <= kOneTimeNs &&
                       std::hypot(here.x - there.x, here.y - there.y) <= kOnePlace && step > 0.0 &&
                       std::abs(step - other) * most <= kOffRay * step &&
                       fan.max_range_m == b.fan.max_range_m;
    if (!alike) return std::nullopt;
    // Where b's first ray lies, in steps from a's: on the turn that brings the fans nearest.
    const double shift = there.theta - here.theta;
    const double middle = (fan.min_angle_rad + fan.max_angle_rad) / 2.0;
    const double middle_b = (b.fan.min_angle_rad + b.fan.max_angle_rad) / 2.0 + shift;
    const double begin_b =
        middle + wrap_angle(middle_b - middle) + (b.fan.min_angle_rad + shift - middle_b);
    const double place = (begin_b - fan.min_angle_rad) / step;
    const double nearest = std::round(place);
    if (!(std::abs(place - nearest) <= kOffRay)) return std::nullopt;
    const double low = std::min(0.0, nearest);
    const double high = std::max<double>(fan.count, nearest + static_cast<double>(b.fan.count));
    constexpr double kRounding = 1e-6;
    if (!((high - low - 1.0) * step <= 2.0 * kPi + kRounding)) return std::nullopt;
    // Steps may be as small as a damaged file likes: then so many would lie between the two.
    if (!(high - low <= kMostScannerRays)) return std::nullopt;

    MountedScan both = a;
    both.stamp_ns = std::min(a.stamp_ns, b.stamp_ns);
    both.number = std::max(a.number, b.number);
    both.device = nullptr;
    both.fan.count = static_cast<std::uint32_t>(high - low);
    both.fan.min_angle_rad = fan.min_angle_rad + low * step;
    both.fan.max_angle_rad = both.fan.min_angle_rad + (high - low - 1.0) * step;
    both.ranges_m.assign(both.fan.count, kNoReading);
    const bool timed = !a.ray_times_s.empty() || !b.ray_times_s.empty();
    both.ray_times_s.assign(timed ? both.fan.count : 0, 0.0F);
    const auto lay = [&](const MountedScan& scan, double begin) {
        const auto first = static_cast<std::size_t>(begin - low);
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            float& range = both.ranges_m[first + i];
            if (std::isnan(scan.ranges_m[i]) || range < scan.ranges_m[i]) continue;
            range = scan.ranges_m[i];
            if (!scan.ray_times_s.empty()) both.ray_times_s[first + i] = scan.ray_times_s[i];
        }
    };
    lay(a, 0.0);
    lay(b, nearest);
    return both;
}

std::optional<MountedScan> joined(const MountedScan& scan, const MountedScan& next) {
    constexpr double kOffRayOfParts = 0.5;  // some drivers round the angles of each part
    constexpr std::int64_t kLongestTurnNs = 1'000'000'000;
    const double step = scan.fan.step_rad();
    const double turn = 2.0 * kPi;
    const std::int64_t later_ns = next.stamp_ns - scan.stamp_ns;
    const bool alike = step > 0.0 && scan.fan.pose_robot_laser == next.fan.pose_robot_laser &&
                       scan.fan.max_range_m == next.fan.max_range_m &&
                       std::abs(next.fan.step_rad() - step) < kOffRay * step && later_ns >= 0 &&
                       later_ns < kLongestTurnNs;
    if (!alike) return std::nullopt;
    const bool behind = !scan.clockwise;
    const Fan& lower = behind ? scan.fan : next.fan;
    const Fan& upper = behind ? next.fan : scan.fan;
    const double off = wrap_angle(upper.min_angle_rad - lower.max_angle_rad) / step - 1.0;
    const double missing =
        std::round(off);                  // rays between the parts; less than 0: that are in both
    constexpr double kMostRays = 3.0;     // drivers cut turns so roughly;
    constexpr double kMostMissing = 0.1;  // of a turn: what they leave out, or what was lost
    const double all_rays = scan.fan.count + missing + next.fan.count;
    const double surplus =
        std::max(0.0, all_rays - std::round(turn / step));  // beyond the whole turn
    if (next.clockwise != scan.clockwise || std::abs(off - missing) > kOffRayOfParts ||
        missing < -kMostRays || missing > std::max(kMostRays, kMostMissing * turn / step) ||
        surplus > kMostRays || next.fan.count <= surplus - std::min(missing, 0.0)) {
        return std::nullopt;
    }
    // Of parts that do not say it, the rays are measured at the pace at which the parts come.
    const auto later_s = static_cast<float>(static_cast<double>(later_ns) * 1e-9);
    const float pace_s = later_s / static_cast<float>(scan.fan.count + missing);
    const auto times_of = [&](const MountedScan& part, float begin_s) {
        std::vector<float> times = part.ray_times_s;
        const auto rays = static_cast<float>(part.ranges_m.size());
        for (std::size_t i = 0; times.size() < part.ranges_m.size(); ++i) {
            const auto place = static_cast<float>(i);
            times.push_back(pace_s * (behind ? place : rays - 1.0F - place));
        }
        for (float& time : times) time += begin_s;
        return times;
    };
    MountedScan both = scan;
    both.ray_times_s = times_of(scan, 0.0F);
    // Where parts overlap the one before has the rays; where they do not meet, rays have no
    // reading.
    const auto between_parts = static_cast<std::ptrdiff_t>(missing);
    const auto put_in = [&](std::vector<float>& all, std::vector<float> more, float none) {
        const auto last = static_cast<std::ptrdiff_t>(surplus);
        behind ? more.erase(more.end() - last, more.end())
               : more.erase(more.begin(), more.begin() + last);
        const auto inner = behind ? more.begin() : more.end();
        if (between_parts > 0) {
            more.insert(inner, static_cast<std::size_t>(between_parts), none);
        } else if (behind) {
            more.erase(inner, inner - between_parts);
        } else {
            more.erase(inner + between_parts, inner);
        }
        all.insert(behind ? all.end() : all.begin(), more.begin(), more.end());
    };
    put_in(both.ranges_m, next.ranges_m, kNoReading);
    put_in(both.ray_times_s, times_of(next, later_s), later_s);
    both.number = next.number;
    both.fan.count = static_cast<std::uint32_t>(both.ranges_m.size());
    if (!behind) both.fan.min_angle_rad -= (both.fan.count - scan.fan.count) * step;
    both.fan.max_angle_rad = both.fan.min_angle_rad + (both.fan.count - 1) * step;
    return both;
}

}  // namespace hitos
