// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of a path of several tours, one behind the other: what of it lies in one frame.
#pragma once

#include <optional>
#include <vector>

#include "hitos/registration/registration.hpp"
#include "hitos/services/evaluation/measures.hpp"

namespace hitos {

/// Whether the scan lies beside the map, wherever that left room: it is of a later tour that was
/// not found, or only in one that was not, or from before a break in it.
bool lies_beside(const std::vector<SecondTour>& later_tours, std::size_t scan);

/// The path's poses, one a scan, without those that lie beside the map: only among the others a
/// distance is one.
Trajectory in_one_frame(const Trajectory& path, const std::vector<SecondTour>& later_tours);

/// The same of the path as it was told scan by scan: until a later tour is found nobody knows where
/// the robot is in the frame of the first.
Trajectory known_while_driving(const Trajectory& online,
                               const std::vector<SecondTour>& later_tours);

/// trajectory_error() of a path that tells nothing of how the tours lie to each other, as odometry:
/// each is laid on the reference by itself, and the poses of all count alike. The motion is that of
/// the first tour of which the reference tells.
std::optional<TrajectoryError> tour_by_tour_error(const Trajectory& path,
                                                  const std::vector<SecondTour>& later_tours,
                                                  const Trajectory& reference,
                                                  double tolerance_s = kSameStamp);

}  // namespace hitos
