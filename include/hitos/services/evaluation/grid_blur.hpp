// SPDX-License-Identifier: GPL-3.0-or-later
// How crisp an occupancy grid is: a measure that needs no reference.
#pragma once

#include <optional>

#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// The area that the grid leaves undecided [m^2], lower is crisper: the Shannon entropy of the
/// cells that were seen, in bits, times the area of a cell,
///   - a * sum of p log2 p + (1 - p) log2 (1 - p),
/// p the probability that a cell is occupied (the entropy of a grid as in Stachniss, Grisetti and
/// Burgard, RSS 2005, over what was seen). Scans laid at wrong poses contradict each other, which
/// leaves cells undecided, or lay the same place down twice, each time seen less often: both add to
/// it. The mean over the cells would miss the second. It compares maps of one tour with grids of
/// the same parameters. Nothing for a grid without a cell that was seen.
std::optional<double> grid_blur_m2(const Grid& grid);

}  // namespace hitos
