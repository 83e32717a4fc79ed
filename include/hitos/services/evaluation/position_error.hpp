// SPDX-License-Identifier: GPL-3.0-or-later
// How far a robot is from where it believes to be, scan by scan.
#pragma once

#include <optional>

#include "hitos/base/geometry.hpp"
#include "hitos/services/evaluation/measures.hpp"

namespace hitos {

/// The distance of poses, in the order of their stamps, to those of a reference at these stamps, as
/// trajectory_error() finds them. The first pair brings the reference into the run's frame; so the
/// error needs nothing that lies ahead, unlike trajectory_error().
class PositionError {
  public:
    explicit PositionError(Trajectory reference, double tolerance_s = kSameStamp);

    /// In metres; nothing where the reference has no pose at this stamp.
    std::optional<double> at(const StampedPose& estimate);
    /// The reference's pose at this stamp in the run's frame, likewise.
    std::optional<Pose> reference_at(const StampedPose& estimate);
    /// Forgets the first pair.
    void begin_anew() { pose_world_reference_.reset(); }

  private:
    Trajectory reference_;  // by stamps
    double tolerance_s_;
    std::optional<Pose> pose_world_reference_;
};

}  // namespace hitos
