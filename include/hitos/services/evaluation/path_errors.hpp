// SPDX-License-Identifier: GPL-3.0-or-later
// How far a path is from where a reference has the robot, pose by pose.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hitos/services/evaluation/measures.hpp"

namespace hitos {

/// Of a pose of an estimate at whose stamp the reference tells where the robot was.
struct PathError {
    std::size_t pose = 0;  ///< of the estimate, by its place
    double time_s = 0.0;   ///< its stamp
    double way_m = 0.0;    ///< along the estimate from its first pose, by straight lines
    double error_m = 0.0;  ///< distance to the reference
};

/// What lays the first pose of the estimate that has one of the reference at its stamp on that one;
/// nothing where none has.
std::optional<Pose> first_alignment(const Trajectory& estimate, const Trajectory& reference,
                                    double tolerance_s = kSameStamp);

/// In the order of the estimate, paired as trajectory_error() pairs them; empty where no stamps
/// agree. `pose_reference_estimate` takes the estimate into the reference's frame: with that of
/// trajectory_error() (Horn 1987; Umeyama 1991) the root of the mean square is its `rmse_m`.
/// Without one first_alignment() does, so that nothing that lies ahead counts, as in PositionError.
std::vector<PathError> path_errors(const Trajectory& estimate, const Trajectory& reference,
                                   std::optional<Pose> pose_reference_estimate = {},
                                   double tolerance_s = kSameStamp);

}  // namespace hitos
