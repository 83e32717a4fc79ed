// SPDX-License-Identifier: GPL-3.0-or-later
// The motion between two scans with which they lie on each other best.
#pragma once

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Climbs from `best` to where `agreement` of a step is highest.
template <class Agreement>
Pose nearest_fit(const Agreement& agreement, Pose best) {
    double highest = agreement(best);
    constexpr double kCoarsest = 0.2;  // [m], [rad / 2]
    constexpr double kFinest = 0.02;
    double step = kCoarsest;
    while (step > kFinest) {
        const Pose from = best;
        for (const double to : {-step, step}) {
            for (const Pose& way : {Pose{to, 0, 0}, Pose{0, to, 0}, Pose{0, 0, to / 2.0}}) {
                const Pose next{from.x + way.x, from.y + way.y, from.theta + way.theta};
                const double found = agreement(next);
                if (found <= highest) continue;
                highest = found;
                best = next;
            }
        }
        if (best == from) step /= 2.0;
    }
    return best;
}

}  // namespace hitos
