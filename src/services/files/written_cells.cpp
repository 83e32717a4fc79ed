// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_cells.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "hitos/base/error.hpp"

namespace hitos {

void check_written_cells(const Grid& grid) {
    constexpr std::int64_t kFew = 16'000'000;  // 200 m by 200 m at 5 cm
    constexpr std::int64_t kEmptiest = 100;    // cells for each near something seen
    const std::int64_t cells = std::int64_t{grid.columns()} * grid.rows();
    const std::int64_t seen = grid.seen_cells();
    if (cells <= kFew || cells / kEmptiest <= seen) return;
    const double percent = 100.0 * static_cast<double>(seen) / static_cast<double>(cells);
    throw Error(message(
        HITOS_TEXT("Errors",
                   "the grid would have %1 x %2 cells, %3 m by %4 m, and %5 % of them are near "
                   "anything that was seen; of more than %6 cells one in %7 has to be. Is an "
                   "anchor, a place that is fixed or a reading far off? Else choose coarser cells "
                   "(grid.resolution)"),
        grid.columns(), grid.rows(), fmt::format("{:.0f}", grid.columns() * grid.resolution_m()),
        fmt::format("{:.0f}", grid.rows() * grid.resolution_m()), fmt::format("{:.2g}", percent),
        kFew, kEmptiest));
}

}  // namespace hitos
