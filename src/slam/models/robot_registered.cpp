// The path of registration, from which particles deviate boundedly.

#include <cmath>
#include <utility>

#include "gaussian.hpp"
#include "hitos/base/error.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "robots.hpp"

namespace hitos {
namespace {

/// A matcher's errors do not add up while it sees what it saw before, so noise that does harms.
/// With Fp, Fc the registered poses before and after the step and delta = Fp^-1 * pose the
/// deviation before, the pose afterwards is
///     Fc * (rho delta + sqrt(1 - rho^2) N(0, S)),   rho = exp(-path / memory),
/// a first-order Gauss-Markov process along the path: its spread is S however long the way. S is
/// `share` of the step's covariance, in the axes of Fc, and the diagonal of the squared sigmas.
class RobotRegistered final : public Robot {
  public:
    explicit RobotRegistered(MotionParams params) : params_(std::move(params)) {}

    Pose mean(const Pose& pose, const MotionIncrement& increment) const override {
        const RegisteredStep& step = registered(increment);
        if (step.before == step.pose) return pose;
        const double rho = remembered(step);
        const Pose delta = between(step.before, pose);
        return compose(step.pose, {rho * delta.x, rho * delta.y, rho * delta.theta});
    }

    Pose sample(const Pose& pose, const MotionIncrement& increment,
                RandomStream& random) const override {
        const Pose after = mean(pose, increment);
        const RegisteredStep& step = registered(increment);
        if (!step.moved()) return after;
        const Eigen::Vector3d noise =
            turn_of(step.pose.theta) * (root_of(deviation(step)) * normal_triple(random));
        return shifted(after, noise);
    }

    /// rho R, with R the turn of the registered step, which leaves the heading's own alone.
    Eigen::Matrix3d jacobian(const Pose& /*pose*/,
                             const MotionIncrement& increment) const override {
        const RegisteredStep& step = registered(increment);
        return remembered(step) * turn_of(step.pose.theta - step.before.theta);
    }

    Eigen::Matrix3d noise_covariance(const Pose& /*pose*/,
                                     const MotionIncrement& increment) const override {
        const RegisteredStep& step = registered(increment);
        if (!step.moved()) return Eigen::Matrix3d::Zero();
        const Eigen::Matrix3d r = turn_of(step.pose.theta);
        return r * deviation(step) * r.transpose();
    }

  private:
    static const RegisteredStep& registered(const MotionIncrement& increment) {
        if (increment.registered != nullptr) return *increment.registered;
        throw ConfigError(
            "motion.model",
            message(HITOS_TEXT(
                "Errors",
                "\"registered\" needs registration, and this run has none; choose another motion "
                "model, or give every step what registration says of it")));
    }
    double remembered(const RegisteredStep& step) const {
        return std::exp(-step.path_m / params_.registered_memory_m);
    }
    /// (1 - rho^2) S in the axes of the pose after the step.
    Eigen::Matrix3d deviation(const RegisteredStep& step) const {
        const Eigen::Vector3d sigma(params_.registered_sigma_m, params_.registered_sigma_m,
                                    params_.registered_heading_rad);
        const Eigen::Matrix3d back = turn_of(step.before.theta - step.pose.theta);
        Eigen::Matrix3d s = params_.registered_share * back * step.covariance * back.transpose();
        s.diagonal() += sigma.cwiseAbs2();
        // 1 - rho^2, without the rounding of a short way.
        return -std::expm1(-2.0 * step.path_m / params_.registered_memory_m) * s;
    }

    MotionParams params_;
};

}  // namespace

MotionModelEntry robot_registered() {
    MotionModelEntry entry;
    entry.word = "registered";
    entry.label = HITOS_TEXT("ParameterChoice", "Registered path");
    entry.purpose = "the path of registration and noise that stays near it";
    entry.reads = {"motion.registered_memory", "motion.registered_share", "motion.registered_sigma",
                   "motion.registered_heading"};
    entry.registered = true;
    entry.make = [](const MotionParams& p) { return std::make_unique<RobotRegistered>(p); };
    return entry;
}

}  // namespace hitos
