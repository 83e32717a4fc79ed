// SPDX-License-Identifier: GPL-3.0-or-later
// The controls and noise whose variance grows with the motion (SPEC 5).

#include <cmath>
#include <utility>

#include "robot_of_steps.hpp"
#include "robots.hpp"

namespace hitos {
namespace {

/// Independent noise along and across the mean heading of the step, and on the heading; with d the
/// length of the path and a the sum of absolute turns, their variances are var_along d,
/// var_across d and var_theta_per_rad a + var_theta_per_m d.
class RobotProportional final : public RobotOfSteps {
  public:
    explicit RobotProportional(MotionParams params) : params_(std::move(params)) {}

    /// R diag(along, across) R' with R the rotation by the mean heading.
    Eigen::Matrix3d noise_covariance(const Pose& pose,
                                     const MotionIncrement& increment) const override {
        Eigen::Matrix3d q = Eigen::Matrix3d::Zero();
        if (!increment.moved()) return q;
        const double heading = mean_heading(pose, increment);
        const double c = std::cos(heading);
        const double s = std::sin(heading);
        const double along = params_.var_along_m2_per_m * increment.path_m;
        const double across = params_.var_across_m2_per_m * increment.path_m;
        q(0, 0) = along * c * c + across * s * s;
        q(0, 1) = q(1, 0) = (along - across) * c * s;
        q(1, 1) = along * s * s + across * c * c;
        q(2, 2) = heading_variance(increment);
        return q;
    }

  private:
    /// The mean heading is half a turn on from that before the step.
    StepWithNoise motion(const MotionIncrement& increment) const override {
        const Pose& step = increment.pose_start_end;
        const double along = std::sqrt(params_.var_along_m2_per_m * increment.path_m);
        const double across = std::sqrt(params_.var_across_m2_per_m * increment.path_m);
        const double c = std::cos(0.5 * step.theta);
        const double s = std::sin(0.5 * step.theta);
        StepWithNoise motion{lane_of(step), c * along, -s * across, s * along, c * across};
        motion.sigma_theta = std::sqrt(heading_variance(increment));
        return motion;
    }
    static double mean_heading(const Pose& pose, const MotionIncrement& increment) {
        return pose.theta + 0.5 * increment.pose_start_end.theta;
    }
    double heading_variance(const MotionIncrement& increment) const {
        return params_.var_theta_rad2_per_rad * increment.turned_rad +
               params_.var_theta_rad2_per_m * increment.path_m;
    }

    MotionParams params_;
};

}  // namespace

MotionModelEntry robot_proportional() {
    MotionModelEntry entry;
    entry.word = "proportional";
    entry.label = HITOS_TEXT("ParameterChoice", "Proportional");
    entry.purpose = "controls and noise that grows with the motion";
    entry.reads = {"motion.var_along", "motion.var_across", "motion.var_theta_per_rad",
                   "motion.var_theta_per_m"};
    entry.make = [](const MotionParams& p) { return std::make_unique<RobotProportional>(p); };
    return entry;
}

}  // namespace hitos
