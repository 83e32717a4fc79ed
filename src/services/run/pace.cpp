// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/pace.hpp"

#include <algorithm>

namespace hitos {

Pacer::Clock::time_point Pacer::next(std::uint64_t steps, double duration_s,
                                     Clock::time_point now) {
    if (pace_.kind == Pace::Kind::full) return now;
    const double at = pace_.kind == Pace::Kind::recorded ? duration_s : static_cast<double>(steps);
    using Seconds = std::chrono::duration<double>;
    Clock::time_point since = now;
    if (begun_) {
        // No run takes that long, and no clock counts much further.
        constexpr Seconds kForever{1e9};
        const Seconds after = std::clamp(Seconds((at - from_) / pace_.rate), -kForever, kForever);
        const auto due = since_ + std::chrono::duration_cast<Clock::duration>(after);
        const bool gap = pace_.kind == Pace::Kind::recorded && due > now + kLongestGap;
        if (!gap && now <= due + kMostBehind) return due;
        if (gap) since += kLongestGap;
    }
    begun_ = true;
    since_ = since;
    from_ = at;
    return since;
}

}  // namespace hitos
