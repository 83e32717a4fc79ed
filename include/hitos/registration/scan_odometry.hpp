// SPDX-License-Identifier: GPL-3.0-or-later
// Odometry where there is none: from one scan to the next, by registration.
#pragma once

#include <memory>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Gives the scans of a tour, and for each an odometry reading at its time that says how the robot
/// moved since the one before: the scans are matched one on the other, from where the robot would
/// be had it gone on as before. What the tour says of odometry is left out. Deterministic; a scan
/// costs what registration without loops does. How fast the scans follow on each other is found
/// out by the first ones of the tour, or of its `beginning`, where the tour comes in live.
std::unique_ptr<TourReader> make_scan_odometry(std::unique_ptr<TourReader> tour,
                                               std::unique_ptr<TourReader> beginning = nullptr);

/// Whether it is such a tour.
bool is_scan_odometry(const TourReader& tour);

}  // namespace hitos
