// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/greatest_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

constexpr std::size_t kDistinctRays = 5;
constexpr std::size_t kRepetitions = 10;
constexpr std::size_t kTimesMoreThanAnother = 3;

long decimetre(double range_m) {
    constexpr double kPerMetre = 10.0;
    constexpr double kFarthest = 1e3;  // of what else is there
    return static_cast<long>(std::clamp(range_m, 0.0, kFarthest) * kPerMetre);
}

}  // namespace

void GreatestRanges::note(double range_m, std::size_t ray) {
    constexpr double kPerMetre = 1000.0;
    constexpr long kJustBelow = 500;
    constexpr double kFarthest = 1e9;
    constexpr std::size_t kMostRays = 10'000;
    constexpr double kAlike = 1e-3;
    constexpr double kBelow = 0.5;
    if (!std::isfinite(range_m)) return;
    if (ray < kMostRays) {
        if (ray >= by_ray_.size()) by_ray_.resize(ray + 1);
        OfRay& own = by_ray_[ray];
        if (range_m > own.greatest_m + kAlike) {
            own = {range_m, 1, range_m < own.greatest_m + kBelow ? own.times + own.below : 0};
        } else if (range_m > own.greatest_m - kAlike) {
            ++own.times;
        } else if (range_m > own.greatest_m - kBelow) {
            ++own.below;
        }
    }
    ++by_decimetre_[decimetre(range_m)];
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

std::optional<GreatestRanges::Code> GreatestRanges::codes_of_rays() const {
    constexpr std::size_t kOneIn = 4;
    Code code;
    std::size_t rays = 0;
    for (const OfRay& own : by_ray_) {
        if (own.times < kRepetitions || own.times < kTimesMoreThanAnother * own.below) continue;
        code.least_m = rays++ == 0 ? own.greatest_m : std::min(code.least_m, own.greatest_m);
        code.range_m = std::max(code.range_m, own.greatest_m);
        code.times += own.times;
    }
    if (rays < kDistinctRays || rays * kOneIn < by_ray_.size()) return std::nullopt;
    return code;
}

std::size_t GreatestRanges::beyond(double range_m) const {
    std::size_t count = 0;
    for (auto at = by_decimetre_.upper_bound(decimetre(range_m)); at != by_decimetre_.end(); ++at)
        count += at->second;
    return count;
}

std::optional<GreatestRanges::Code> GreatestRanges::code() const {
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
