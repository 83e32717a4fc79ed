// SPDX-License-Identifier: GPL-3.0-or-later
// The odometry's increments and noise in proportion to each of them [P eq 10-14].

#include <cmath>
#include <utility>

#include "robot_of_steps.hpp"
#include "robots.hpp"

namespace hitos {
namespace {

/// Independent noise on the step ahead, the step sideways and the turn, all in the robot's frame at
/// the step's beginning; the sigma of each is its ratio times the increment itself. Q = G S G' with
/// G the rotation by the heading before the step and S the diagonal of the squared sigmas
/// [P eq 14].
class RobotIncrements final : public RobotOfSteps {
  public:
    explicit RobotIncrements(MotionParams params) : params_(std::move(params)) {}

    Eigen::Matrix3d noise_covariance(const Pose& pose,
                                     const MotionIncrement& increment) const override {
        const Pose& step = increment.pose_start_end;
        const Eigen::Vector3d sigma(params_.ratio_x * step.x, params_.ratio_y * step.y,
                                    params_.ratio_theta * step.theta);
        Eigen::Matrix3d g = Eigen::Matrix3d::Identity();
        g(0, 0) = g(1, 1) = std::cos(pose.theta);
        g(1, 0) = std::sin(pose.theta);
        g(0, 1) = -g(1, 0);
        return g * sigma.cwiseAbs2().asDiagonal() * g.transpose();
    }

  private:
    StepWithNoise motion(const MotionIncrement& increment) const override {
        const Pose& step = increment.pose_start_end;
        StepWithNoise motion{lane_of(step)};
        motion.m00 = params_.ratio_x * std::abs(step.x);
        motion.m11 = params_.ratio_y * std::abs(step.y);
        motion.sigma_theta = params_.ratio_theta * std::abs(step.theta);
        return motion;
    }

    MotionParams params_;
};

}  // namespace

MotionModelEntry robot_increments() {
    MotionModelEntry entry;
    entry.word = "increments";
    entry.label = HITOS_TEXT("ParameterChoice", "Increments");
    entry.purpose = "controls and noise in proportion to each increment of the odometry";
    entry.reads = {"motion.ratio_x", "motion.ratio_y", "motion.ratio_theta"};
    entry.make = [](const MotionParams& p) { return std::make_unique<RobotIncrements>(p); };
    return entry;
}

}  // namespace hitos
