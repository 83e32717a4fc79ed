// SPDX-License-Identifier: GPL-3.0-or-later
// The path of registration, from which particles deviate boundedly.

#include <cmath>
#include <utility>

#include "gaussian.hpp"
#include "hitos/base/error.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "motion_noise.hpp"
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
        if (!step.moved() && step.before == step.pose) return pose;
        const double rho = remembered(step);
        const Pose delta = between(step.before, pose);
        return compose(step.pose, {rho * delta.x, rho * delta.y, rho * delta.theta});
    }

    Pose sample(const Pose& pose, const MotionIncrement& increment,
                RandomStream& random) const override {
        const RegisteredStep& step = registered(increment);
        return step.moved() ? moved(deviating(step), pose, random) : mean(pose, increment);
    }
    bool sample_row(std::span<Pose> poses, const MotionIncrement& increment,
                    const RandomRow& row) const override {
        const RegisteredStep& step = registered(increment);
        if (!step.moved()) return false;
        move_row(deviating(step), poses, row);
        return true;
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
    /// mean() and noise of three independent standard normal draws n: a pose off the path before by
    /// d is off it by T d + L n afterwards, in the world's axes, with L the lower triangle of the
    /// noise's covariance, turned, and the headings' difference times rho.
    struct Deviating {
        LanePose before;
        LanePose after;
        double cosine;  // of the turn, times rho
        double sine;
        double rho;
        double l00, l01, l02;
        double l10, l11, l12;
        double l20, l21, l22;

        HITOS_INLINE LanePose moved(const LanePose& pose, double n0, double n1, double n2) const {
            const double dx = pose.x - before.x;
            const double dy = pose.y - before.y;
            const double turn = elementary::wrap(pose.theta - before.theta);
            return {after.x + (cosine * dx - sine * dy) + (l00 * n0 + l01 * n1 + l02 * n2),
                    after.y + (sine * dx + cosine * dy) + (l10 * n0 + l11 * n1 + l12 * n2),
                    elementary::wrap(after.theta + rho * turn + (l20 * n0 + l21 * n1 + l22 * n2))};
        }
    };
    Deviating deviating(const RegisteredStep& step) const {
        const double rho = remembered(step);
        const double turn = step.pose.theta - step.before.theta;
        const Eigen::Matrix3d l = turn_of(step.pose.theta) * root_of(deviation(step));
        return {lane_of(step.before),
                lane_of(step.pose),
                rho * std::cos(turn),
                rho * std::sin(turn),
                rho,
                l(0, 0),
                l(0, 1),
                l(0, 2),
                l(1, 0),
                l(1, 1),
                l(1, 2),
                l(2, 0),
                l(2, 1),
                l(2, 2)};
    }
    static const RegisteredStep& registered(const MotionIncrement& increment) {
        if (increment.registered != nullptr) return *increment.registered;
        throw ConfigError(
            "motion.model",
            HITOS_TEXT("Errors",
                       "\"registered\" needs registration, and this run has none; choose another "
                       "motion model, or give every step what registration says of it"));
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
