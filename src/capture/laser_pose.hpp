// SPDX-License-Identifier: GPL-3.0-or-later
// Where a laser sits, as users say it.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hitos/base/geometry.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// A pose as users say it.
struct PoseWords {
    double x;  ///< [m]
    double y;  ///< [m]
    double degrees;

    Pose pose() const { return {x, y, wrap_angle(degrees * kRadiansPerDegree)}; }
};
/// Of three words that are finite numbers; nothing of others.
std::optional<PoseWords> pose_words(std::span<const std::string_view> words);

struct LaserPose {
    Pose pose_robot_laser;     ///< [m], [rad]
    bool upside_down = false;  ///< its rays go the other way round

    /// What the laser sees there, on the robot.
    Point2 mounted(const Point2& seen) const {
        return transform(pose_robot_laser, {seen.x, upside_down ? -seen.y : seen.y});
    }
    LandmarkSighting mounted(const LandmarkSighting& seen) const {
        const Point2 point = mounted(seen.point());
        return {std::hypot(point.x, point.y), std::atan2(point.y, point.x), seen.identity};
    }
};

/// "x,y,degrees" or "x,y,degrees,upside-down"; nothing of an empty text. Throws ConfigError, under
/// the parameter's key, for another one.
std::optional<LaserPose> laser_pose_of(std::string_view text);
/// Such a text, to centimetres.
std::string text_of(const LaserPose& pose);

}  // namespace hitos
