// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/path_crispness.hpp"

#include <cmath>
#include <memory>

#include "hitos/base/error.hpp"
#include "hitos/services/evaluation/grid_blur.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "map_crispness.hpp"

namespace hitos {

PathCrispness path_crispness(const TourReader& tour, const Trajectory& path,
                             const GridParams& params) {
    MapCrispness cells;
    Grid grid(params);
    PathCrispness crispness;
    const std::unique_ptr<TourReader> reader = tour.reopen();
    for (const StampedPose& stamped : path) {
        const std::optional<Scan> scan = reader->next_scan();
        if (!scan) {
            throw FormatError(tour.name(), 0,
                              HITOS_TEXT("Errors",
                                         "the tour has %1 scans, the path %2 poses; expected the "
                                         "tour that the path was made of"),
                              crispness.scans, path.size());
        }
        if (!(std::abs(scan->stamp_s() - stamped.time_s) <= kSameStamp)) {
            throw FormatError(tour.name(), 0,
                              HITOS_TEXT("Errors",
                                         "scan %1 has the stamp %2 s, its pose %3 s; expected the "
                                         "tour that the path was made of"),
                              crispness.scans + 1, scan->stamp_s(), stamped.time_s);
        }
        cells.add(*scan, stamped.pose);
        grid.add(*scan, stamped.pose);
        ++crispness.scans;
    }
    crispness.cells_per_point = cells.cells_per_point();
    crispness.grid_blur_m2 = grid_blur_m2(grid);
    if (crispness.grid_blur_m2) {
        crispness.grid_entropy_bits =
            *crispness.grid_blur_m2 / (grid.resolution_m() * grid.resolution_m());
    }
    return crispness;
}

}  // namespace hitos
