// Which poses of two trajectories, or of a trajectory and a list of times, are of one moment.
#pragma once

#include <cstddef>
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

/// The pose whose stamp is nearest to the time, within the tolerance [s]; of two that are as near
/// the later one; null where there is none. The trajectory is in the order of its stamps.
const StampedPose* nearest_pose(const Trajectory& by_stamp, double time_s, double tolerance_s);

}  // namespace hitos
