// SPDX-License-Identifier: GPL-3.0-or-later
// When the scans were taken, by the odometry.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "hitos/capture/scan_clock.hpp"
#include "hypothesis_search.hpp"
#include "remedies.hpp"
#include "tour_clocks.hpp"

namespace hitos {

namespace {

using Kind = TourFinding::Kind;

/// From a clock of the table's to where the scans fit best: its begin, its end, and both.
BestFit refined(const Fit& fit, const Hypothesis& start, double Hypothesis::*change, double unit,
                double step_s) {
    constexpr double kParts = 10.0;
    BestFit best;
    best.try_out(fit, start);
    return climbed(fit, best, step_s, step_s / kParts, [&](const Hypothesis& from, double step) {
        std::vector<Hypothesis> others;
        for (const double off : {-step, step}) {
            Hypothesis other = from;
            other.delay_s += off;
            others.push_back(other);
            other.*change -= off * unit;
            others.push_back(other);
            other.delay_s -= off;
            others.push_back(other);
        }
        return others;
    });
}

std::vector<Remedy> add_to_times(const ReadOptions& read, std::vector<ScanClock::Point> points) {
    return {{marked(HITOS_TEXT("Errors",
                               "add that to their times, and set the clocks of both computers "
                               "alike before recording")),
             WholeValues(read).clock(ScanClock(std::move(points)))}};
}

/// Where a table says that a clock is set, the scan before it keeps its time.
double to_later_hundredth(double seconds) {
    constexpr double kHundredth = 0.01;
    return std::ceil(seconds / kHundredth) * kHundredth;
}

/// `points`: two of each time at which the clock was set.
TourFinding told_table(std::vector<ScanClock::Point> points, double fits, double told,
                       const ReadOptions& read) {
    const ScanClock::Point before = points[0];
    const ScanClock::Point after = points[1];
    Message what =
        points.size() == 2
            ? message(HITOS_TEXT("Errors",
                                 "the scans' clock was set during the tour: they fit the odometry "
                                 "where %1 are added up to second %2 and %3 from there on (%4 % of "
                                 "their points, against %5 % as they are stamped)"),
                      seconds_words(before.added_s), std::lround(before.at_s),
                      seconds_words(after.added_s), percent(fits), percent(told))
            : message(HITOS_TEXT("Errors",
                                 "the scans' clock was set %1 times during the tour, first by %2 "
                                 "at second %3: with that taken back %4 % of their points fit the "
                                 "odometry meanwhile, against %5 % as they are stamped"),
                      points.size() / 2, seconds_words(before.added_s - after.added_s),
                      std::lround(before.at_s), percent(fits), percent(told));
    return {Kind::clock_set, after.added_s - before.added_s, std::move(what),
            add_to_times(read, std::move(points))};
}

}  // namespace

std::string seconds_words(double seconds) {
    constexpr double kNone = 0.005;  // else "-0.00"
    return fmt::format("{:.{}f} s", std::abs(seconds) < kNone ? 0.0 : seconds,
                       std::abs(seconds) < 10.0 ? 2 : 1);
}

BestFit best_delay(const Fit& fit, double middle) {
    constexpr int kSteps = 120;
    constexpr double kStep = 0.5;
    constexpr double kFinest = 0.02;
    constexpr double kNarrow = 0.1;
    constexpr double kAsWell = 0.01;
    std::vector<BestFit> tried;
    double least = 0.0;
    const auto try_out = [&](double away) {
        const Hypothesis late{.delay_s = middle + away};
        tried.push_back({late, fit(late, least)});
        least = std::max(least, tried.back().agreement - kAsWell);
    };
    // Of a robot that turns fast, what is nearest is narrower than a step.
    for (int i = -4; i <= 4; ++i) try_out(i * kNarrow);
    for (int i = -kSteps; i <= kSteps; ++i) try_out(i * kStep);
    const BestFit highest = *std::ranges::max_element(tried, {}, &BestFit::agreement);
    BestFit best = highest;
    for (const BestFit& one : tried) {
        if (one.agreement >= highest.agreement - kAsWell &&
            std::abs(one.hypothesis.delay_s - middle) <
                std::abs(best.hypothesis.delay_s - middle)) {
            best = one;
        }
    }
    return climbed(fit, best, kStep, kFinest, [](const Hypothesis& from, double step) {
        return std::array<Hypothesis, 2>{
            {{.delay_s = from.delay_s - step}, {.delay_s = from.delay_s + step}}};
    });
}

std::optional<TourFinding> TourExamination::changing_clock(const Pairs& pairs,
                                                           const Hypothesis& asked, double step_s,
                                                           int steps, double least) const {
    constexpr double kMostGained = 10.0;  // [s] over the tour
    constexpr double kSideClearly = 0.1;
    constexpr double kPromising =
        0.05;  // below what is wanted: between the table's steps lies more
    const double seconds = last_scan_s_ - first_scan_s_;
    if (least > 1.0 || pairs.empty() || !(seconds > 0.0)) return std::nullopt;
    DelayTable table(step_s, steps);
    std::vector<double> fits(table.columns());
    constexpr std::size_t kTabled = 64;  // to begin from
    const std::size_t every = (pairs.size() + kTabled - 1) / kTabled;
    for (std::size_t place = 0; place < pairs.size(); place += every) {
        for (std::size_t i = 0; i < fits.size(); ++i) {
            Hypothesis other = asked;
            other.delay_s = table.delay_s(i);
            fits[i] = agreement(*pairs[place], other).value_or(0.0);
        }
        table.add(pairs[place]->second.time_s, fits);
    }
    const Fit fit(*this, pairs);
    const auto from = [&](const DelayTable::Clock& clock, double Hypothesis::*change, double unit) {
        if (clock.agreement + kPromising < least) return BestFit{};
        Hypothesis start = asked;
        start.gained = clock.gained_s / table.seconds();
        start.delay_s = clock.delay_s - start.gained * (table.begin_s() - first_scan_s_);
        start.set_by_s = clock.set_by_s;
        start.set_at_s = clock.set_at_s;
        return refined(fit, start, change, unit, step_s);
    };
    BestFit drifting = from(table.drifting(kMostGained), &Hypothesis::gained, 1.0 / seconds);
    BestFit set = from(table.set(kSideClearly), &Hypothesis::set_by_s, 1.0);
    if (!may_be_set(set.hypothesis)) set.agreement = 0.0;
    const double gained_s = drifting.hypothesis.gained * seconds;
    if (std::abs(gained_s) < kShortestDelay) drifting.agreement = 0.0;
    if (std::abs(set.hypothesis.set_by_s) < kShortestDelay) set.agreement = 0.0;
    const BestFit& best = set.agreement > drifting.agreement ? set : drifting;
    // Of one that was set either side speaks for itself.
    if (best.agreement < least - (&best == &set ? kPromising : 0.0)) return std::nullopt;
    if (&best == &set) {
        // In the midst of a turn one time is as good as another: all pairs tell it better.
        const Pairs all = some_pairs(2 * pairs.size());
        const double agreed = set.agreement;
        const BestFit by_all =
            refined({*this, all}, set.hypothesis, &Hypothesis::set_by_s, 1.0, step_s);
        if (std::abs(by_all.hypothesis.set_by_s) >= kShortestDelay)
            set = {by_all.hypothesis, agreed};
        // Where each pair is on the side that it fits better; the middle of where that is so.
        Hypothesis later = set.hypothesis;
        later.set_at_s = first_scan_s_;
        Hypothesis sooner = set.hypothesis;
        sooner.set_by_s = 0.0;
        constexpr double kAsWell = 0.05;
        double sum = 0.0;
        double highest = 0.0;
        double begin_s = set.hypothesis.set_at_s;
        double end_s = begin_s;
        for (const Pair* pair : all) {
            sum += agreement(*pair, sooner).value_or(0.0) - agreement(*pair, later).value_or(0.0);
            if (sum > highest + kAsWell) begin_s = pair->second.time_s;
            if (sum > highest - kAsWell) end_s = pair->second.time_s;
            highest = std::max(highest, sum);
        }
        set.hypothesis.set_at_s = (begin_s + end_s) / 2.0;
        return told_set(set.hypothesis, set.agreement, agreement(pairs, asked).value_or(0.0));
    }
    const double end_s = best.hypothesis.delay_s + gained_s;
    return TourFinding{
        Kind::clock_speed, best.hypothesis.gained,
        message(HITOS_TEXT("Errors",
                           "the scans' clock does not run as fast as the odometry's: they fit it "
                           "where %1 are added at the beginning and %2 at the end (%3 % of their "
                           "points, against %4 % as they are stamped)"),
                seconds_words(best.hypothesis.delay_s), seconds_words(end_s),
                percent(best.agreement), percent(agreement(pairs, asked).value_or(0.0))),
        add_to_times(read_, {{0.0, best.hypothesis.delay_s}, {std::round(seconds), end_s}})};
}

bool TourExamination::may_be_set(const Hypothesis& set) const {
    constexpr double kNear = 0.35;   // [s]: of a turn nobody knows better
    constexpr double kAround = 0.1;  // of the tour
    const double around_s =
        std::max(10.0, kAround * (last_scan_s_ - first_scan_s_));  // where it was set
    const auto near = [&](double at_s) { return std::abs(at_s - set.set_at_s) <= around_s; };
    // What the next stamp is off the one before it.
    const double by_s = period_s() - set.set_by_s;
    const bool noted = by_s < -kNear || by_s > kLeastLeap + kNear || period_s() < kLeastLeap;
    if (!noted || stamp_leaps_.size() == kMostLeaps) return true;
    if (std::ranges::any_of(stamp_leaps_, [&](const StampLeap& leap) {
            return near(leap.after_s) && std::abs(leap.by_s - by_s) <= kNear;
        })) {
        return true;
    }
    // Of the odometry's clock: time passes in which it has no reading.
    for (std::size_t i = 1; i < path_.size(); ++i) {
        const double gap_s = path_[i].time_s - path_[i - 1].time_s;
        if (near(path_[i].time_s + set.delay_s) && std::abs(gap_s - set.set_by_s) <= kNear &&
            gap_s > kLeastLeap) {
            return true;
        }
    }
    return false;
}

BestFit TourExamination::best_leaps(const Pairs& pairs, unsigned begin, unsigned offered) const {
    const Fit fit(*this, pairs);
    BestFit best;
    best.try_out(fit, {.undone_leaps = begin});
    unsigned before = 0;
    do {
        before = best.hypothesis.undone_leaps;
        for (std::size_t i = 0; i < stamp_leaps_.size(); ++i) {
            const unsigned leap = 1U << i;
            if ((offered & leap) != 0) best.try_out(fit, {.undone_leaps = before ^ leap});
        }
    } while (best.hypothesis.undone_leaps != before);
    return best;
}

/// A clock that was set where the stamps leap: that leap itself says by how much. One that was set
/// and set back fits with both leaps undone and with neither, but not with one.
std::optional<TourExamination::SetClock> TourExamination::set_clock(const Pairs& pairs,
                                                                    double otherwise) const {
    constexpr double kBetter = 0.02;  // than what has a number of its own to fit by
    constexpr double kMuchBetter = 0.1;
    constexpr std::size_t kLeastPairs = 10;
    unsigned offered = 0;
    for (std::size_t i = 0; i < stamp_leaps_.size(); ++i) {
        if (std::abs(period_s() - stamp_leaps_[i].by_s) >= kShortestDelay) offered |= 1U << i;
    }
    if (offered == 0) return std::nullopt;
    const double told = agreement(pairs, Hypothesis{}).value_or(0.0);
    BestFit best = best_leaps(pairs, 0, offered);
    const BestFit fewer = best_leaps(pairs, offered, offered);
    if (fewer.agreement > best.agreement) best = fewer;
    const unsigned undone = best.hypothesis.undone_leaps;
    if (undone == 0 || best.agreement < kLeastFit || !beats_standing(best.agreement))
        return std::nullopt;
    if (best.agreement >= std::max(told + kClearly, otherwise + kBetter))
        return SetClock{told_leaps(undone, best.agreement, told), best.agreement};
    // What is soon set back weighs little among all of them, and much by itself.
    Pairs meanwhile;
    for (const Pair& pair : pairs_) {
        if (std::abs(undone_s(undone, pair.first.time_s)) >= kShortestDelay)
            meanwhile.push_back(&pair);
    }
    if (meanwhile.size() < kLeastPairs) return std::nullopt;
    // Beyond the odometry's times nothing else says where they were taken.
    const std::optional<double> as_stamped = agreement(meanwhile, Hypothesis{});
    if (as_stamped && best.agreement <= otherwise) return std::nullopt;
    const double fits = agreement(meanwhile, best.hypothesis).value_or(0.0);
    const double told_meanwhile = as_stamped.value_or(0.0);
    if (fits < std::max(kLeastFit, told_meanwhile + kMuchBetter)) return std::nullopt;
    return SetClock{told_leaps(undone, fits, told_meanwhile), best.agreement};
}

TourFinding TourExamination::told_leaps(unsigned undone, double fits, double told) const {
    std::vector<ScanClock::Point> points;
    double added_s = 0.0;
    for (std::size_t i = 0; i < stamp_leaps_.size(); ++i) {
        if (((undone >> i) & 1U) == 0) continue;
        const double at_s = to_later_hundredth(stamp_leaps_[i].elapsed_s);
        points.push_back({at_s, added_s});
        added_s += period_s() - stamp_leaps_[i].by_s;
        points.push_back({at_s, added_s});
    }
    return told_table(points, fits, told, read_);
}
TourFinding TourExamination::told_set(const Hypothesis& set, double fits, double told) const {
    constexpr double kNear = 0.3;  // [s]
    // The stamps leap where it was set.
    double at_s = set.set_at_s - first_scan_s_;
    double nearest = last_scan_s_ - first_scan_s_;
    for (const StampLeap& leap : stamp_leaps_) {
        const double away = std::abs(leap.after_s - set.set_at_s);
        if (std::abs(leap.by_s + set.set_by_s) > kNear || away > nearest) continue;
        nearest = away;
        at_s = leap.elapsed_s;
    }
    at_s = to_later_hundredth(at_s);
    return told_table({{at_s, set.delay_s}, {at_s, set.delay_s + set.set_by_s}}, fits, told, read_);
}

std::optional<TourFinding> TourExamination::turning_clock(const Turning& turning,
                                                          double otherwise) const {
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kStep = 0.025;  // [s]
    constexpr int kSteps = 48;
    constexpr double kSure = 0.5;  // scans that lie a metre apart fit less, at any time
    constexpr double kTimes = 1.12;
    constexpr double kMore = 0.02;
    if (turning.pairs.size() < kLeastPairs) return std::nullopt;
    return changing_clock(turning.pairs, closely(), kStep, kSteps,
                          std::max(kSure, kTimes * otherwise + kMore));
}

}  // namespace hitos
