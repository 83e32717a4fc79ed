// SPDX-License-Identifier: GPL-3.0-or-later
// The time of a path of one tour or of several, one behind the other.
#pragma once

#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Of each pose the time since the first one [s], without what passed between two tours.
std::vector<double> tour_seconds(std::span<const StampedPose> path);

/// Of the last pose; 0 where there is none.
double tour_duration_s(std::span<const StampedPose> path);

}  // namespace hitos
