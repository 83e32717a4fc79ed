// SPDX-License-Identifier: GPL-3.0-or-later
// Poses with the vectors and matrices of estimation, in world axes [m, m, rad].
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// The pose with (x, y, theta) added to its own, as estimators move it: not a motion of the robot.
inline Pose shifted(const Pose& pose, const Eigen::Vector3d& by) {
    return {pose.x + by(0), pose.y + by(1), wrap_angle(pose.theta + by(2))};
}

/// What turns (x, y, theta) of a frame that is turned by `heading` into the axes of the one it is
/// turned in; the heading's own component stays.
inline Eigen::Matrix3d turn_of(double heading_rad) {
    const double c = std::cos(heading_rad);
    const double s = std::sin(heading_rad);
    Eigen::Matrix3d turn;
    turn << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
    return turn;
}

}  // namespace hitos
