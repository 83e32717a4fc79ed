// SPDX-License-Identifier: GPL-3.0-or-later
// The motion models that Hitos brings along, one file each.
#pragma once

#include "hitos/slam/robot.hpp"

namespace hitos {

MotionModelEntry robot_with_odometry();
MotionModelEntry robot_without_odometry();
MotionModelEntry robot_proportional();
MotionModelEntry robot_increments();
MotionModelEntry robot_registered();

}  // namespace hitos
