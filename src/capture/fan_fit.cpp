// SPDX-License-Identifier: GPL-3.0-or-later
#include "fan_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// How far from its ray a bearing may lie, in steps of the fan.
constexpr double kOffGrid = 0.05;

double step_of(const Fan& fan) {
    return fan.count > 1 ? fan.step_rad() : 1.0;
}

std::vector<double> bearings_of(const Scan& scan) {
    std::vector<double> bearings;
    bearings.reserve(scan.points.size());
    for (const Point2& point : scan.points) bearings.push_back(std::atan2(point.y, point.x));
    return bearings;
}

/// The ray of a bearing, or -1 where none is near.
std::ptrdiff_t ray_of(const Fan& fan, double bearing) {
    const double position = (bearing - fan.min_angle_rad) / step_of(fan);
    const double nearest = std::round(position);
    if (std::abs(position - nearest) > kOffGrid) return -1;
    if (nearest < 0.0 || nearest > static_cast<double>(fan.count) - 1.0) return -1;
    return static_cast<std::ptrdiff_t>(nearest);
}

bool fits(const Fan& fan, const std::vector<double>& bearings) {
    return fan.count > 0 && std::all_of(bearings.begin(), bearings.end(),
                                        [&fan](double b) { return ray_of(fan, b) >= 0; });
}

/// The smallest step between neighbours; infinite where there are none.
double smallest_step(const std::vector<double>& bearings) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < bearings.size(); ++i) {
        smallest = std::min(smallest, std::abs(bearings[i] - bearings[i - 1]));
    }
    return smallest;
}

bool has_step(const Fan& fan, double step) {
    return std::isinf(step) || std::abs(step_of(fan) - step) <= 2.0 * kOffGrid * step;
}

/// The half circles that scanners sweep, in steps of 1, 1/2 and 1/4 degree.
std::array<Fan, 3> usual_fans() {
    std::array<Fan, 3> fans;
    std::uint32_t count = 181;
    for (Fan& fan : fans) {
        fan.min_angle_rad = -kPi / 2.0;
        fan.max_angle_rad = kPi / 2.0;
        fan.count = count;
        count = 2 * count - 1;
    }
    return fans;
}

/// The line a + k step through the bearings, by least squares over whole k. The first guess of the
/// step may be off by some per cent, so k is counted from neighbour to neighbour.
Fan fitted_fan(const std::vector<double>& bearings, double smallest) {
    const double sign = bearings.back() < bearings.front() ? -1.0 : 1.0;
    double k = 0.0;
    double n = 0.0;
    double sum_k = 0.0;
    double sum_kk = 0.0;
    double sum_b = 0.0;
    double sum_kb = 0.0;
    for (std::size_t i = 0; i < bearings.size(); ++i) {
        if (i > 0) k += std::round(sign * (bearings[i] - bearings[i - 1]) / smallest);
        n += 1.0;
        sum_k += k;
        sum_kk += k * k;
        sum_b += bearings[i];
        sum_kb += k * bearings[i];
    }
    const double slope = (n * sum_kb - sum_k * sum_b) / (n * sum_kk - sum_k * sum_k);
    Fan fan;
    if (!(k >= 0.0 && k < kMostScannerRays)) return fan;  // no scanner's
    fan.min_angle_rad = (sum_b - slope * sum_k) / n;
    fan.max_angle_rad = fan.min_angle_rad + slope * k;
    fan.count = static_cast<std::uint32_t>(k) + 1;
    return fan;
}

}  // namespace

void FanFitter::fail(const Scan& scan, const Message& problem) const {
    throw FormatError(path_, 0,
                      HITOS_TEXT("Errors",
                                 "the scan of line %1 (time %2) cannot be written as ranges: %3; "
                                 "write it in the normalized format"),
                      scan.line, std::to_string(scan.time_s), problem);
}

void FanFitter::derive(const Scan& scan) {
    constexpr double kFinestStep = 1e-4;
    const std::vector<double> bearings = bearings_of(scan);
    const double smallest = smallest_step(bearings);
    if (smallest < kFinestStep) {
        fail(scan, message(HITOS_TEXT("Errors", "two of its points have one bearing")));
    }
    if (has_step(derived_, smallest) && fits(derived_, bearings)) return;
    for (const Fan& usual : usual_fans()) {
        if (has_step(usual, smallest) && fits(usual, bearings)) {
            derived_ = usual;
            return;
        }
    }
    if (bearings.size() == 1) {
        derived_ = {bearings.front(), bearings.front(), 1, 0.0, {}};
        return;
    }
    const Fan fan = fitted_fan(bearings, smallest);
    if (fan.count == 0 || !fits(fan, bearings)) {
        fail(scan, message(HITOS_TEXT("Errors", "its points do not lie on regular rays")));
    }
    derived_ = fan;
}

Sweep FanFitter::sweep(const Scan& scan) {
    const bool has_rays = scan.fan.count > 0 && scan.rays.size() == scan.points.size();
    if (!has_rays) derive(scan);
    Sweep result;
    result.fan = has_rays ? scan.fan : derived_;
    if (!has_rays) result.fan.max_range_m = scan.fan.max_range_m;
    if (!(result.fan.max_range_m > 0.0)) result.fan.max_range_m = kUnknownMaxRange;
    result.ranges_m.assign(result.fan.count, 0.0);
    const Pose pose_laser_robot = inverse(result.fan.pose_robot_laser);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const Point2 point = transform(pose_laser_robot, scan.points[i]);
        const double range = std::hypot(point.x, point.y);
        const std::ptrdiff_t ray = has_rays ? static_cast<std::ptrdiff_t>(scan.rays[i])
                                            : ray_of(result.fan, std::atan2(point.y, point.x));
        if (ray < 0 || ray >= static_cast<std::ptrdiff_t>(result.fan.count)) {
            fail(scan, message(HITOS_TEXT("Errors", "a point belongs to ray %1 of %2"), ray,
                               result.fan.count));
        }
        if (!(range < result.fan.max_range_m)) {
            fail(scan,
                 message(HITOS_TEXT("Errors", "a point is %1 m away, its greatest range is %2 m"),
                         std::to_string(range), std::to_string(result.fan.max_range_m)));
        }
        double& known = result.ranges_m[static_cast<std::size_t>(ray)];
        if (known == 0.0 || range < known) known = range;
    }
    return result;
}

}  // namespace hitos
