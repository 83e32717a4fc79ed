// SPDX-License-Identifier: GPL-3.0-or-later
// How crisp the map is that a path makes of a tour, without any truth.
#pragma once

#include <cstdint>
#include <optional>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// Compares paths of one tour; lower is crisper.
struct PathCrispness {
    std::uint64_t scans = 0;
    /// Cells of 5 cm that scan points fall into, over the points; 0 without any point. The same as
    /// RunQuality::cells_per_point.
    double cells_per_point = 0.0;
    /// Entropy of the grid as grid_blur_m2() has it; nothing where no cell was seen.
    std::optional<double> grid_blur_m2;
    /// The same not weighed by the cells' area [bit].
    std::optional<double> grid_entropy_bits;
};

/// Reads the tour anew; its scans and the poses belong together in their order. A path that ends
/// before the tour takes its first scans alone. Throws FormatError where the tour ends first or a
/// scan and its pose are of different times, and what reading the tour throws.
PathCrispness path_crispness(const TourReader& tour, const Trajectory& path,
                             const GridParams& params);

}  // namespace hitos
