// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to doubt about the stamps of a tour's two sequences.
#pragma once

#include <vector>

#include "hitos/capture/stamp_line.hpp"
#include "hitos/capture/tour_finding.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Whether a clock goes back, or leaps ahead farther than any tour lasts.
void doubt_returns(const StampReturns& of_scans, const StampReturns& of_odometry,
                   const ReadReport& report, std::vector<TourFinding>& found);
/// Whether more are left out than a driver's first messages.
void doubt_broken_stamps(const BrokenStamps& of_scans, const BrokenStamps& of_odometry,
                         std::vector<TourFinding>& found);

}  // namespace hitos
