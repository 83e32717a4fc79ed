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
    if (!std::isfinite(range_m)) return;
    const long place = std::lround(std::min(range_m, kFarthest) * kPerMetre);
    if (!by_millimetre_.empty()) {
        const long greatest = by_millimetre_.rbegin()->first;
        if (place < greatest - kJustBelow) return;
        if (place > greatest)
            by_millimetre_.erase(by_millimetre_.begin(),
                                 by_millimetre_.lower_bound(place - kJustBelow));
    }
    Counted& counted = by_millimetre_.try_emplace(place, Counted{range_m, range_m}).first->second;
    counted.range_m = std::max(counted.range_m, range_m);
    counted.least_m = std::min(counted.least_m, range_m);
    ++counted.times;
    if (counted.rays.size() < kDistinctRays) counted.rays.insert(ray);
}

std::optional<GreatestRanges::Code> GreatestRanges::code() const {
    constexpr std::size_t kRepetitions = 10;
    constexpr std::size_t kTimesMoreThanAnother = 3;
    constexpr long kOne = 3;  // millimetres: points of a log are rounded in x and y
    if (by_millimetre_.empty()) return std::nullopt;
    const long last = by_millimetre_.rbegin()->first;
    Code code{.least_m = by_millimetre_.rbegin()->second.least_m};
    std::set<std::size_t> rays;
    const auto first = by_millimetre_.lower_bound(last - kOne + 1);
    for (auto at = first; at != by_millimetre_.end(); ++at) {
        code.range_m = std::max(code.range_m, at->second.range_m);
        code.least_m = std::min(code.least_m, at->second.least_m);
        code.times += at->second.times;
        rays.insert(at->second.rays.begin(), at->second.rays.end());
    }
    if (code.times < kRepetitions || rays.size() < kDistinctRays) return std::nullopt;
    for (auto at = by_millimetre_.begin(); at != first; ++at) {
        std::size_t times = 0;
        for (auto near = at; near != first && near->first < at->first + kOne; ++near)
            times += near->second.times;
        if (kTimesMoreThanAnother * times >= code.times) return std::nullopt;
    }
    return code;
}

}  // namespace hitos
