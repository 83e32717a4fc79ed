// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/robot.hpp"

#include "robots.hpp"

namespace hitos {

MotionIncrement sum_controls(std::span<const Control> controls) {
    return {driven_way(controls), nullptr};
}

MotionIncrement motion_increment(const SlamInput& input) {
    return {driven_way(input.controls), input.registered};
}

Eigen::Matrix3d Robot::jacobian(const Pose& pose, const MotionIncrement& increment) const {
    const Pose after = mean(pose, increment);
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    f(0, 2) = pose.y - after.y;
    f(1, 2) = after.x - pose.x;
    return f;
}

Registry<MotionModelEntry>& motion_models() {
    static Registry<MotionModelEntry> registry(
        "motion model", "motion.model",
        {robot_with_odometry(), robot_without_odometry(), robot_proportional(), robot_increments(),
         robot_registered()});
    return registry;
}

std::unique_ptr<Robot> make_robot(const MotionParams& params) {
    return motion_models().find(params.model).make(params);
}

}  // namespace hitos
