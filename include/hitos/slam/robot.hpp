// Motion model of a differential robot [T 7.4.1].
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "hitos/base/random_stream.hpp"
#include "hitos/features/control.hpp"
#include "hitos/slam/params.hpp"

namespace hitos {

/// What the controls between two scans amount to, the same for every particle.
struct MotionIncrement {
    Pose pose_start_end;      ///< displacement in the robot frame at the start
    double path_m = 0.0;      ///< length of the path driven
    double turned_rad = 0.0;  ///< sum of absolute turns
    bool moved() const { return path_m > 0.0 || turned_rad > 0.0; }
};

/// Sums the controls by [T eq 7.17] (its straight-line limit included).
MotionIncrement sum_controls(std::span<const Control> controls);

/// The motion model with its noise; a const value.
class Robot {
  public:
    explicit Robot(const MotionParams& params);

    /// Draws the pose after the increment [T eq 7.18]. The noise is drawn once per call, and not
    /// at all where the robot did not move (but always with `no_odometry`, whose controls mean
    /// nothing). `odometry` noise is added in world axes, `proportional` noise along and across
    /// the mean heading of the step.
    Pose sample(const Pose& pose_world_robot, const MotionIncrement& increment,
                RandomStream& random) const;

    /// The pose after the increment without noise.
    Pose mean(const Pose& pose_world_robot, const MotionIncrement& increment) const;

    /// d(mean)/d(x, y, theta) [P eq 13].
    Eigen::Matrix3d jacobian(const Pose& pose_world_robot, const MotionIncrement& increment) const;

    /// Covariance of what sample() adds to mean(), of (x, y, theta) in world axes [m, m, rad]
    /// [P eq 11, 14].
    Eigen::Matrix3d noise_covariance(const Pose& pose_world_robot,
                                     const MotionIncrement& increment) const;

  private:
    bool moves(const MotionIncrement& increment) const;

    MotionParams params_;
};

}  // namespace hitos
