// SPDX-License-Identifier: GPL-3.0-or-later
// Odometry where there is none: from one scan to the next, by registration.
#pragma once

#include <memory>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Gives the scans of a tour, and for each an odometry reading at its time that says how the robot
/// moved since the one before: the scans are matched one on the other, from where the robot would
/// be had it gone on as before. What the tour says of odometry is left out. Deterministic; a scan
/// costs what registration without loops does.
std::unique_ptr<TourReader> make_scan_odometry(std::unique_ptr<TourReader> tour);

}  // namespace hitos
