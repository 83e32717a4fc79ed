// SPDX-License-Identifier: GPL-3.0-or-later
#include "tour_clocks.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

/// The column with the highest sum; of those that are about as high the one nearest to `middle`, as
/// on straight ways many are.
std::size_t highest(const std::vector<double>& sums, double count, std::size_t middle) {
    constexpr double kAsWell = 0.003;
    const double least = std::ranges::max(sums) - kAsWell * count;
    const auto away = [middle](std::size_t i) { return i > middle ? i - middle : middle - i; };
    std::size_t best = sums.size();
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (sums[i] >= least && (best == sums.size() || away(i) < away(best))) best = i;
    }
    return best;
}

}  // namespace

void DelayTable::add(double time_s, const std::vector<double>& agreements) {
    times_s_.push_back(time_s);
    agreements_.insert(agreements_.end(), agreements.begin(), agreements.end());
}

DelayTable::Clock DelayTable::drifting(double most_s) const {
    Clock best;
    if (pairs() < 2 || !(times_s_.back() > times_s_.front())) return best;
    const auto last = static_cast<double>(columns() - 1);
    for (std::size_t begin = 0; begin < columns(); ++begin) {
        for (std::size_t end = 0; end < columns(); ++end) {
            const double gained_s = delay_s(end) - delay_s(begin);
            if (std::abs(gained_s) > most_s) continue;
            double sum = 0.0;
            for (std::size_t pair = 0; pair < pairs(); ++pair) {
                const double share =
                    (times_s_[pair] - times_s_.front()) / (times_s_.back() - times_s_.front());
                const double column =
                    std::lerp(static_cast<double>(begin), static_cast<double>(end), share);
                const auto before = static_cast<std::size_t>(std::min(column, last - 1.0));
                sum += std::lerp(at(pair, before), at(pair, before + 1),
                                 column - static_cast<double>(before));
            }
            const double agreement = sum / static_cast<double>(pairs());
            if (agreement > best.agreement) {
                best = {.delay_s = delay_s(begin), .gained_s = gained_s, .agreement = agreement};
            }
        }
    }
    return best;
}

DelayTable::Clock DelayTable::set(double clearly) const {
    constexpr std::size_t kLeastShare = 8;
    constexpr std::size_t kLeastPairs = 8;
    Clock best;
    std::vector<double> before(columns(), 0.0);
    std::vector<double> after(columns(), 0.0);
    for (std::size_t pair = 0; pair < pairs(); ++pair) {
        for (std::size_t i = 0; i < columns(); ++i) after[i] += at(pair, i);
    }
    const std::size_t least = std::max(kLeastPairs, pairs() / kLeastShare);
    for (std::size_t first = 1; first + least <= pairs(); ++first) {
        for (std::size_t i = 0; i < columns(); ++i) {
            before[i] += at(first - 1, i);
            after[i] -= at(first - 1, i);
        }
        if (first < least) continue;
        const auto count = static_cast<double>(first);
        const auto rest = static_cast<double>(pairs() - first);
        const auto middle = static_cast<std::size_t>(steps_);
        const std::size_t one = highest(before, count, middle);
        const std::size_t other = highest(after, rest, middle);
        const double agreement = (before[one] + after[other]) / static_cast<double>(pairs());
        if (agreement <= best.agreement || before[one] - before[other] < clearly * count ||
            after[other] - after[one] < clearly * rest) {
            continue;
        }
        best = {.delay_s = delay_s(one),
                .set_by_s = delay_s(other) - delay_s(one),
                .set_at_s = (times_s_[first - 1] + times_s_[first]) / 2.0,
                .agreement = agreement};
    }
    return best;
}

}  // namespace hitos
