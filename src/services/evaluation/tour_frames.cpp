// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/tour_frames.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

/// The later tour that the scan is of; none of the first one.
const SecondTour* tour_of(const std::vector<SecondTour>& later_tours, std::size_t scan) {
    const SecondTour* tour = nullptr;
    for (const SecondTour& one : later_tours)
        if (one.begin <= scan) tour = &one;
    return tour;
}

template <class Known>
Trajectory poses_that(const Trajectory& path, const Known& known) {
    Trajectory out;
    for (std::size_t scan = 0; scan < path.size(); ++scan)
        if (known(scan)) out.push_back(path[scan]);
    return out;
}

/// The root mean square of two sets of so many.
double pooled(double a, int of_a, double b, int of_b) {
    return std::sqrt((a * a * of_a + b * b * of_b) / (of_a + of_b));
}

}  // namespace

bool lies_beside(const std::vector<SecondTour>& later_tours, std::size_t scan) {
    const SecondTour* tour = tour_of(later_tours, scan);
    if (tour == nullptr) return false;
    if (!tour->found || scan < tour->laid_from) return true;
    // Whether it was found in one that lies there itself.
    return tour->beside < tour->begin && lies_beside(later_tours, tour->beside);
}

Trajectory in_one_frame(const Trajectory& path, const std::vector<SecondTour>& later_tours) {
    return poses_that(path, [&](std::size_t scan) { return !lies_beside(later_tours, scan); });
}

Trajectory known_while_driving(const Trajectory& online,
                               const std::vector<SecondTour>& later_tours) {
    return poses_that(online, [&](std::size_t scan) {
        const SecondTour* tour = tour_of(later_tours, scan);
        return tour == nullptr || (!lies_beside(later_tours, scan) && *tour->found <= scan);
    });
}

std::optional<TrajectoryError> tour_by_tour_error(const Trajectory& path,
                                                  const std::vector<SecondTour>& later_tours,
                                                  const Trajectory& reference, double tolerance_s) {
    std::optional<TrajectoryError> all;
    for (std::size_t from = 0; from < path.size();) {
        std::size_t end = path.size();
        for (const SecondTour& tour : later_tours)
            if (tour.begin > from) end = std::min<std::size_t>(end, tour.begin);
        const auto one = trajectory_error({path.begin() + static_cast<std::ptrdiff_t>(from),
                                           path.begin() + static_cast<std::ptrdiff_t>(end)},
                                          reference, tolerance_s);
        from = end;
        if (!one) continue;
        if (!all) {
            all = one;
            continue;
        }
        all->mean_m =
            (all->mean_m * all->poses + one->mean_m * one->poses) / (all->poses + one->poses);
        all->maximum_m = std::max(all->maximum_m, one->maximum_m);
        if (all->heading_rmse_rad && one->heading_rmse_rad) {
            all->heading_rmse_rad =
                pooled(*all->heading_rmse_rad, all->poses, *one->heading_rmse_rad, one->poses);
        }
        all->rmse_m = pooled(all->rmse_m, all->poses, one->rmse_m, one->poses);
        all->poses += one->poses;
    }
    return all;
}

}  // namespace hitos
