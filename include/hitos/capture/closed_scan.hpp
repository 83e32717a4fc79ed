// SPDX-License-Identifier: GPL-3.0-or-later
// Scans of lasers that turn all round.
#pragma once

#include "hitos/capture/scan.hpp"

namespace hitos {

/// A scan for those who take its points one after the other. Where the fan is open it is `scan`
/// itself. Where it is closed the first ray means nothing: `room` gets the same points, always
/// counter-clockwise, from where the surroundings have an end of their own: behind missing rays
/// (the widest of such gaps), else at the point that stands out most from its neighbours, which is
/// a corner or the end of a wall before another one. The rays are numbered, and the fan's angles
/// counted, from there. So neither the first ray nor the direction of the sweep changes what is
/// made of a scan.
const Scan& cut_open(const Scan& scan, Scan& room);

/// Whether the last point of the scan is the neighbour of its first and nothing is missing between.
bool goes_all_round(const Scan& scan);

}  // namespace hitos
