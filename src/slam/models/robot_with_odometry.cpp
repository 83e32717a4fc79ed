// SPDX-License-Identifier: GPL-3.0-or-later
// "Diferencial con odometría" [T 7.4.1]: the controls and noise of constant sigma, none at rest.

#include <utility>

#include "robot_of_steps.hpp"
#include "robots.hpp"

namespace hitos {
namespace {

class RobotWithOdometry final : public RobotOfSteps {
  public:
    explicit RobotWithOdometry(MotionParams params) : params_(std::move(params)) {}

    Eigen::Matrix3d noise_covariance(const Pose& /*pose*/,
                                     const MotionIncrement& increment) const override {
        if (!increment.moved()) return Eigen::Matrix3d::Zero();
        return constant_covariance(params_);
    }

  private:
    StepWithNoise motion(const MotionIncrement& increment) const override {
        return constant_noise(params_, increment.pose_start_end);
    }

    MotionParams params_;
};

}  // namespace

MotionModelEntry robot_with_odometry() {
    MotionModelEntry entry;
    entry.word = "odometry";
    entry.label = HITOS_TEXT("ParameterChoice", "Differential with odometry");
    entry.purpose = "controls and noise of constant sigma";
    entry.reads = {"motion.unit", "motion.sigma_x", "motion.sigma_y", "motion.sigma_theta"};
    entry.make = [](const MotionParams& p) { return std::make_unique<RobotWithOdometry>(p); };
    return entry;
}

}  // namespace hitos
