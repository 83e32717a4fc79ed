#include "hitos/slam/robot.hpp"

#include <cmath>

namespace hitos {

MotionIncrement sum_controls(std::span<const Control> controls) {
    MotionIncrement sum;
    for (const Control& control : controls) {
        sum.pose_start_end =
            compose(sum.pose_start_end, displacement(control.twist, control.duration_s));
        sum.path_m += std::hypot(control.twist.v, control.twist.v_lateral) * control.duration_s;
        sum.turned_rad += std::abs(control.twist.w) * control.duration_s;
    }
    return sum;
}

Robot::Robot(const MotionParams& params) : params_(params) {}

Pose Robot::mean(const Pose& pose_world_robot, const MotionIncrement& increment) const {
    if (params_.model == MotionModel::no_odometry) return pose_world_robot;
    return compose(pose_world_robot, increment.pose_start_end);
}

bool Robot::moves(const MotionIncrement& increment) const {
    return params_.model == MotionModel::no_odometry || increment.moved();
}

Eigen::Matrix3d Robot::jacobian(const Pose& pose_world_robot,
                                const MotionIncrement& increment) const {
    const Pose after = mean(pose_world_robot, increment);
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    f(0, 2) = pose_world_robot.y - after.y;
    f(1, 2) = after.x - pose_world_robot.x;
    return f;
}

Eigen::Matrix3d Robot::noise_covariance(const Pose& pose_world_robot,
                                        const MotionIncrement& increment) const {
    Eigen::Matrix3d q = Eigen::Matrix3d::Zero();
    if (!moves(increment)) return q;
    if (params_.model == MotionModel::proportional) {
        const double heading = pose_world_robot.theta + 0.5 * increment.pose_start_end.theta;
        const double c = std::cos(heading);
        const double s = std::sin(heading);
        const double along = params_.var_along_m2_per_m * increment.path_m;
        const double across = params_.var_across_m2_per_m * increment.path_m;
        q(0, 0) = along * c * c + across * s * s;
        q(0, 1) = q(1, 0) = (along - across) * c * s;
        q(1, 1) = along * s * s + across * c * c;
        q(2, 2) = params_.var_theta_rad2_per_rad * increment.turned_rad +
                  params_.var_theta_rad2_per_m * increment.path_m;
        return q;
    }
    q(0, 0) = params_.sigma_x_m * params_.sigma_x_m;
    q(1, 1) = params_.sigma_y_m * params_.sigma_y_m;
    q(2, 2) = params_.sigma_theta_rad * params_.sigma_theta_rad;
    return q;
}

Pose Robot::sample(const Pose& pose_world_robot, const MotionIncrement& increment,
                   RandomStream& random) const {
    Pose pose = mean(pose_world_robot, increment);
    if (!moves(increment)) return pose;
    const auto [n0, n1] = random.normal_pair();
    const double n2 = random.normal_pair()[0];
    if (params_.model == MotionModel::proportional) {
        const double along = n0 * std::sqrt(params_.var_along_m2_per_m * increment.path_m);
        const double across = n1 * std::sqrt(params_.var_across_m2_per_m * increment.path_m);
        const double heading = pose_world_robot.theta + 0.5 * increment.pose_start_end.theta;
        pose.x += along * std::cos(heading) - across * std::sin(heading);
        pose.y += along * std::sin(heading) + across * std::cos(heading);
        pose.theta = wrap_angle(
            pose.theta + n2 * std::sqrt(params_.var_theta_rad2_per_rad * increment.turned_rad +
                                        params_.var_theta_rad2_per_m * increment.path_m));
        return pose;
    }
    pose.x += params_.sigma_x_m * n0;
    pose.y += params_.sigma_y_m * n1;
    pose.theta = wrap_angle(pose.theta + params_.sigma_theta_rad * n2);
    return pose;
}

}  // namespace hitos
