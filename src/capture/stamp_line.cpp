// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/stamp_line.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hitos {
namespace {

constexpr StampJudge::Verdict kWait{};
constexpr StampJudge::Verdict kGoesOn{1, false};

}  // namespace

StampJudge::Verdict StampJudge::judge(const std::deque<double>& times_s, bool ended) const {
    if (!last_s_) return judge_first(times_s, ended);
    const double leap_s = times_s.front() - *last_s_;
    if (leap_s > slack_s()) return judge_ahead(times_s, ended);
    if (leap_s < -slack_s()) return judge_back(times_s, ended);
    return kGoesOn;
}

StampJudge::Verdict StampJudge::judge_first(const std::deque<double>& times_s, bool ended) const {
    if (times_s.size() == 1) return ended ? kGoesOn : kWait;
    const bool back = !follows(times_s[0], times_s[1]);
    const bool far = times_s[1] > times_s[0] + kNoPause;
    if (!back && !far) return kGoesOn;
    if (times_s.size() == 2) return ended ? kGoesOn : kWait;
    // Of three the two that are of one line are right.
    const bool of_the_others =
        follows(times_s[1], times_s[2]) && (far || !follows(times_s[0], times_s[2]));
    return {1, of_the_others};
}

/// Broken where the line goes on behind it as if it had not been.
StampJudge::Verdict StampJudge::judge_ahead(const std::deque<double>& times_s, bool ended) const {
    const double first_s = times_s.front();
    const bool far = first_s > *last_s_ + kNoPause;
    const std::size_t wanted = far ? kRun : 2;
    std::size_t of_its_line = 1;
    for (std::size_t i = 1; i < times_s.size(); ++i) {
        if (follows(first_s, times_s[i])) {
            if (++of_its_line == wanted) return kGoesOn;
        } else if (follows(*last_s_, times_s[i])) {
            return {i, true};
        }
    }
    if (times_s.size() > kRun) return kGoesOn;
    return ended ? Verdict{1, far} : kWait;
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
