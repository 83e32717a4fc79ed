// "Diferencial con odometría" [T 7.4.1]: the controls and noise of constant sigma, none at rest.

#include "constant_noise.hpp"
#include "robots.hpp"

namespace hitos {
namespace {

class RobotWithOdometry final : public Robot {
  public:
    explicit RobotWithOdometry(const MotionParams& params) : noise_(params) {}

    Pose mean(const Pose& pose, const MotionIncrement& increment) const override {
        return compose(pose, increment.pose_start_end);
    }
    Pose sample(const Pose& pose, const MotionIncrement& increment,
                RandomStream& random) const override {
        const Pose after = mean(pose, increment);
        return increment.moved() ? noise_.added_to(after, random) : after;
    }
    bool sample_row(std::span<Pose> poses, const MotionIncrement& increment,
                    const RandomRow& row) const override {
        if (!increment.moved()) return false;
        noise_.add_row(poses, increment.pose_start_end, row);
        return true;
    }
    Eigen::Matrix3d noise_covariance(const Pose& /*pose*/,
                                     const MotionIncrement& increment) const override {
        if (!increment.moved()) return Eigen::Matrix3d::Zero();
        return noise_.covariance();
    }

  private:
    ConstantNoise noise_;
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
