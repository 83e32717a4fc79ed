// SPDX-License-Identifier: GPL-3.0-or-later
// What the motion models have in common that carry a pose on by the odometry's step.
#pragma once

#include "hitos/slam/robot.hpp"
#include "motion_noise.hpp"

namespace hitos {

/// mean() is the pose and the step; the noise is drawn once per step, and not at all at rest.
class RobotOfSteps : public Robot {
  public:
    Pose mean(const Pose& pose, const MotionIncrement& increment) const final {
        return compose(pose, increment.pose_start_end);
    }
    Pose sample(const Pose& pose, const MotionIncrement& increment,
                RandomStream& random) const final {
        return increment.moved() ? moved(motion(increment), pose, random) : mean(pose, increment);
    }
    bool sample_row(std::span<Pose> poses, const MotionIncrement& increment,
                    const RandomRow& row) const final {
        if (!increment.moved()) return false;
        move_row(motion(increment), poses, row);
        return true;
    }

  private:
    virtual StepWithNoise motion(const MotionIncrement& increment) const = 0;
};

}  // namespace hitos
