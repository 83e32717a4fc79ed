// SPDX-License-Identifier: GPL-3.0-or-later
// "Diferencial sin odometría" [T 7.4.1]: the controls are ignored, the particles only spread.

#include <utility>

#include "motion_noise.hpp"
#include "robots.hpp"

namespace hitos {
namespace {

/// Its controls mean nothing, rest included: noise is drawn in every step.
class RobotWithoutOdometry final : public Robot {
  public:
    explicit RobotWithoutOdometry(MotionParams params) : params_(std::move(params)) {}

    Pose mean(const Pose& pose, const MotionIncrement& /*increment*/) const override {
        return pose;
    }
    Pose sample(const Pose& pose, const MotionIncrement& /*increment*/,
                RandomStream& random) const override {
        return moved(constant_noise(params_, {}), pose, random);
    }
    bool sample_row(std::span<Pose> poses, const MotionIncrement& /*increment*/,
                    const RandomRow& row) const override {
        move_row(constant_noise(params_, {}), poses, row);
        return true;
    }
    Eigen::Matrix3d noise_covariance(const Pose& /*pose*/,
                                     const MotionIncrement& /*increment*/) const override {
        return constant_covariance(params_);
    }

  private:
    MotionParams params_;
};

}  // namespace

MotionModelEntry robot_without_odometry() {
    MotionModelEntry entry;
    entry.word = "no-odometry";
    entry.label = HITOS_TEXT("ParameterChoice", "Differential without odometry");
    entry.purpose = "controls are ignored and the particles only spread";
    entry.reads = {"motion.unit", "motion.sigma_x", "motion.sigma_y", "motion.sigma_theta"};
    entry.reads_odometry = false;
    entry.make = [](const MotionParams& p) { return std::make_unique<RobotWithoutOdometry>(p); };
    return entry;
}

}  // namespace hitos
