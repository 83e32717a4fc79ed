// SPDX-License-Identifier: GPL-3.0-or-later
// Readings that a limit leaves out although they are walls.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hitos {

/// Of readings in the order of their rays those beyond a limit that go on from one ray to the next
/// as walls do: neither alike, as codes for "no return" are, nor scattered.
struct WallsBeyond {
    std::size_t count = 0;
    double farthest_m = 0.0;

    /// So many of a laser's readings are left out by its own limit alone where that is wrong.
    static constexpr double kMost = 0.05;

    void note(const auto& ranges_m, double limit_m) {
        constexpr double kAlike = 1e-3;
        constexpr double kStep = 0.1;   // [m] from ray to ray,
        constexpr double kPart = 0.03;  // and of the range: what a wall does that is looked along
        double last_m = 0.0;
        for (const auto one : ranges_m) {
            const auto range_m = static_cast<double>(one);
            const double step_m = std::abs(range_m - last_m);
            const bool beyond = range_m >= limit_m && last_m >= limit_m && std::isfinite(range_m);
            last_m = range_m;
            if (!beyond || !(step_m > kAlike) || step_m > kStep + kPart * range_m) continue;
            ++count;
            farthest_m = std::max(farthest_m, range_m);
        }
    }
};

}  // namespace hitos
