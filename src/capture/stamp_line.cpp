// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/stamp_line.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hitos {
namespace {

constexpr StampJudge::Verdict kWait{};
constexpr StampJudge::Verdict kGoesOn{1, false};
constexpr double kFarOfPace = 20.0;  // where stamps are not of seconds

}  // namespace

StampJudge::Verdict StampJudge::judge(const std::deque<double>& times_s, bool ended) const {
    if (!last_s_) return judge_first(times_s, ended);
    const double leap_s = times_s.front() - *last_s_;
    if (leap_s > slack_s()) return judge_ahead(times_s, ended);
    if (leap_s < -slack_s()) return judge_back(times_s, ended);
    return kGoesOn;
}

/// A driver's first messages may be of another clock than all behind them.
StampJudge::Verdict StampJudge::judge_first(const std::deque<double>& times_s, bool ended) const {
    const std::size_t known = std::min(times_s.size(), kRun + 1);
    if (known <= kRun && !ended) return kWait;
    const auto goes_on = [&](double time_s, double next_s) {
        return follows(time_s, next_s) && next_s <= time_s + kNoPause;
    };
    std::size_t run = 1;
    while (run < known && goes_on(times_s[run - 1], times_s[run])) ++run;
    // Of two lines that of the fewer is broken, unless it goes on behind the other.
    std::size_t others = 0;
    for (std::size_t i = run; i < known; ++i) {
        if (goes_on(times_s[0], times_s[i])) return kGoesOn;
        if (goes_on(times_s[run], times_s[i])) ++others;
    }
    return others > run ? Verdict{run, true} : kGoesOn;
}

/// Broken where the line goes on behind it as if it had not been.
StampJudge::Verdict StampJudge::judge_ahead(const std::deque<double>& times_s, bool ended) const {
    const double first_s = times_s.front();
    const std::size_t wanted = first_s > *last_s_ + kShortPause ? kRun : 2;
    std::size_t of_its_line = 1;
    for (std::size_t i = 1; i < times_s.size(); ++i) {
        if (follows(first_s, times_s[i])) {
            if (++of_its_line == wanted) return kGoesOn;
        } else if (follows(*last_s_, times_s[i])) {
            return {i, true};
        }
    }
    if (times_s.size() > kRun) return kGoesOn;
    if (!ended) return kWait;
    return {1, first_s > *last_s_ + std::max(kNoPause, kFarOfPace * slack_s())};
}

/// Broken where the line it left goes on soon, by a leap and not in its own time.
StampJudge::Verdict StampJudge::judge_back(const std::deque<double>& times_s, bool ended) const {
    const double back_s = *last_s_ - times_s.front();
    for (std::size_t i = 1; i < times_s.size(); ++i) {
        const bool leaps = times_s[i] - times_s[i - 1] > back_s / 2.0;
        if (leaps && follows(*last_s_, times_s[i])) return {i, true};
    }
    if (times_s.size() >= kRun) return kGoesOn;
    return ended ? Verdict{times_s.size(), true} : kWait;
}

void StampJudge::went_on(double time_s) {
    if (last_s_) {
        if (time_s < *last_s_ - slack_s()) ++returns_;
        steps_s_ = {steps_s_[1], time_s - *last_s_};
    }
    last_s_ = time_s;
}

double StampJudge::slack_s() const {
    return std::max(StampReturns::kOutOfOrder, 2.0 * std::min(steps_s_[0], steps_s_[1]));
}

void StampReturns::note(double time_s, std::uint64_t of_line) {
    if (stamps == 0) first_s = time_s;
    if (stamps > 0 && time_s < last_s) ++backwards;
    if (stamps > 0 && time_s - last_s > kLongest) ++leaps;
    if (stamps > 0 && time_s - last_s > farthest_s) {
        farthest_s = time_s - last_s;
        farthest_at_s = last_s;
        farthest_line = of_line;
    }
    // Of the stamp before this one, where this one does not go ahead again.
    const double back_s = ++stamps > 2 ? before_s - last_s : 0.0;
    if (back_s > kOutOfOrder && before_s - time_s > kOutOfOrder) {
        ++count;
        if (back_s > most_s) {
            most_s = back_s;
            at_s = before_s;
            line = last_line;
        }
    }
    before_s = last_s;
    last_s = time_s;
    last_line = of_line;
}

Message StampJudge::problem(double time_s, std::optional<double> next_s) const {
    const auto shown = [](double of_s) { return fmt::format("{:.13g}", of_s); };
    if (last_s_ && next_s) {
        return message(HITOS_TEXT("Errors",
                                  "its time, %1 s, is out of line: that before it is of %2 s and "
                                  "that behind it of %3 s"),
                       shown(time_s), shown(*last_s_), shown(*next_s));
    }
    return message(
        HITOS_TEXT("Errors", "its time, %1 s, is out of line with its neighbour's, %2 s"),
        shown(time_s), shown(next_s ? *next_s : last_s_.value_or(time_s)));
}

}  // namespace hitos
