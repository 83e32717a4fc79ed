// SPDX-License-Identifier: GPL-3.0-or-later
// Which poses of two trajectories, or of a trajectory and a list of times, are of one moment.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Pairs (estimate, reference) of poses, by their indices, with stamps within the tolerance [s]:
/// nearest stamps first, every pose once. In the order of the estimate; stamps that are not finite
/// have no partner.
std::vector<std::pair<std::size_t, std::size_t>> pairs_by_stamp(const Trajectory& estimate,
                                                                const Trajectory& reference,
                                                                double tolerance_s);

/// A pose of an estimate, by its index, and where a reference has the robot at its stamp.
struct Matched {
    std::size_t estimate = 0;
    Pose reference;
};

/// What a reference tells of the poses of an estimate, in their order. Between two of its poses
/// that are no further apart than the greater of twice the tolerance and kLongestGap it is
/// interpolated; elsewhere pairs_by_stamp() decides.
std::vector<Matched> matched_by_stamp(const Trajectory& estimate, const Trajectory& reference,
                                      double tolerance_s);

/// The reference's pose at a time, interpolated likewise, else nearest_pose(). The trajectory is in
/// the order of its stamps.
std::optional<Pose> pose_at(const Trajectory& by_stamp, double time_s, double tolerance_s);

/// The pose whose stamp is nearest to the time, within the tolerance [s]; of two that are as near
/// the later one; null where there is none. The trajectory is in the order of its stamps.
const StampedPose* nearest_pose(const Trajectory& by_stamp, double time_s, double tolerance_s);

}  // namespace hitos
