// SPDX-License-Identifier: GPL-3.0-or-later
// Motion models of a robot: one class each [T 7.4.1, 9.2.4].
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>

#include "hitos/base/random_row.hpp"
#include "hitos/base/registry.hpp"
#include "hitos/features/control.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// What the controls between two scans amount to, the same for every particle.
struct MotionIncrement : DrivenWay {
    /// Where registration places the scans before and after; null where the run has none.
    const RegisteredStep* registered = nullptr;
};

/// As driven_way().
MotionIncrement sum_controls(std::span<const Control> controls);
/// The same, with what registration says.
MotionIncrement motion_increment(const SlamInput& input);

/// A motion model with its noise; a const object that gives functions, shared by all threads.
/// Poses are of the robot in the world.
class Robot {
  public:
    virtual ~Robot() = default;

    /// The pose after the increment without noise.
    virtual Pose mean(const Pose& pose, const MotionIncrement& increment) const = 0;

    /// Draws the pose after the increment [T eq 7.18]. The noise is drawn once per call, and not
    /// at all where the model says that the robot did not move.
    virtual Pose sample(const Pose& pose, const MotionIncrement& increment,
                        RandomStream& random) const = 0;

    /// The same for at most NormalRow::kMost poses at once, each with its stream; false, and the
    /// poses as they were, where the model has no faster way.
    virtual bool sample_row(std::span<Pose> /*poses*/, const MotionIncrement& /*increment*/,
                            const RandomRow& /*row*/) const {
        return false;
    }

    /// d(mean)/d(x, y, theta) [P eq 13], as it is where mean() carries the pose on by a
    /// displacement in the robot's own frame; another mean needs another Jacobian.
    virtual Eigen::Matrix3d jacobian(const Pose& pose, const MotionIncrement& increment) const;

    /// Covariance of what sample() adds to mean(), of (x, y, theta) in world axes [m, m, rad]
    /// [P eq 11, 14].
    virtual Eigen::Matrix3d noise_covariance(const Pose& pose,
                                             const MotionIncrement& increment) const = 0;
};

/// A motion model as parameters name it.
struct MotionModelEntry : RegistryEntry {
    bool registered = false;     ///< reads MotionIncrement::registered
    bool reads_odometry = true;  ///< else it only spreads
    std::function<std::unique_ptr<Robot>(const MotionParams&)> make;
};

/// Those that the program knows: "odometry", "no-odometry", "proportional", "increments",
/// "registered" and what was added.
Registry<MotionModelEntry>& motion_models();

/// The robot that `params.model` names. Throws ConfigError for a word that is not known.
std::unique_ptr<Robot> make_robot(const MotionParams& params);

}  // namespace hitos
