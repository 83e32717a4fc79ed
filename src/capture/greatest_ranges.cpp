// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/greatest_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

constexpr std::size_t kDistinctRays = 5;

}  // namespace

void GreatestRanges::note(double range_m, std::size_t ray) {
    constexpr double kPerMetre = 1000.0;
    constexpr long kJustBelow = 500;
    constexpr double kFarthest = 1e9;
    const long place = std::lround(std::min(range_m, kFarthest) * kPerMetre);
    if (!by_millimetre_.empty()) {
        const long greatest = by_millimetre_.rbegin()->first;
        if (place < greatest - kJustBelow) return;
        if (place > greatest)
            by_millimetre_.erase(by_millimetre_.begin(),
                                 by_millimetre_.lower_bound(place - kJustBelow));
    }
    Counted& counted = by_millimetre_[place];
    counted.range_m = std::max(counted.range_m, range_m);
    ++counted.times;
    if (counted.rays.size() < kDistinctRays) counted.rays.insert(ray);
}

std::optional<GreatestRanges::Code> GreatestRanges::code() const {
    constexpr std::size_t kRepetitions = 10;
    constexpr std::size_t kTimesMoreThanAnother = 3;
    if (by_millimetre_.empty()) return std::nullopt;
    const Counted& greatest = by_millimetre_.rbegin()->second;
    const auto hardly = [&](const auto& one) {
        return &one.second == &greatest ||
               kTimesMoreThanAnother * one.second.times < greatest.times;
    };
    if (greatest.times < kRepetitions || greatest.rays.size() < kDistinctRays ||
        !std::ranges::all_of(by_millimetre_, hardly)) {
        return std::nullopt;
    }
    return Code{greatest.range_m, greatest.times};
}

}  // namespace hitos
