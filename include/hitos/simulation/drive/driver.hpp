// SPDX-License-Identifier: GPL-3.0-or-later
// The robot's driver, for who drives it goal by goal.
#pragma once

#include "hitos/base/geometry.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// The velocities [m/s, rad/s] that the driver of way points asks for on its way to a goal (world
/// frame) at which the robot is to stop: docs/simulation.md has the law. None within the tolerance
/// at which a way point is passed.
Twist towards(const Pose& pose, const Point2& goal, const RobotParams& robot);

}  // namespace hitos
