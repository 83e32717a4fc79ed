// SPDX-License-Identifier: GPL-3.0-or-later
// Other tours that a recorded one might as well have been.
#pragma once

#include <cstdint>
#include <memory>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Perturbed copy 1, 2, … of what `reader`, which must stand at its beginning, gives. Its first
/// 3 `copy` scans are left out with the odometry before; N(0, 10 mm) is added to every range; each
/// odometry step from scan to scan is scaled by 1 + 0.03 N(0, 1), and one that moved is turned by
/// 0.003 rad N(0, 1) more. A copy is the same one every time. Truth, of the frame of a first scan
/// that is left out, is not known of it.
std::unique_ptr<TourReader> make_perturbed_reader(std::unique_ptr<TourReader> reader,
                                                  std::uint64_t copy);

}  // namespace hitos
