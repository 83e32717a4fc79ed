// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the scans fit the odometry: as the tour says, or in another way.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hitos/base/median.hpp"
#include "hypothesis_search.hpp"
#include "laser_units.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

}  // namespace

void TourExamination::doubt_fit(std::vector<TourFinding>& found) const {
    if (path_.size() < 2 || pairs_.empty() || (way_m_ == 0.0 && turned_rad_ == 0.0)) return;
    const double apart =
        path_.front().time_s > last_scan_s_
            ? path_.front().time_s - last_scan_s_
            : (first_scan_s_ > path_.back().time_s ? path_.back().time_s - first_scan_s_ : 0.0);
    // What is asked costs a fraction of a second: enough pairs for a mean, not all of them.
    constexpr std::size_t kAsked = 128;
    const Pairs pairs = some_pairs(kAsked);
    const Fit fit(*this, pairs);
    BestFit late = best_delay(fit, apart != 0.0 ? path_.front().time_s - first_scan_s_ : 0.0);
    // Clocks that are minutes apart, and the tour longer: either both begin together, or both end.
    constexpr double kFarOff = 30.0;  // [s]: nearer is looked for already
    constexpr double kFarSurer = 0.1;
    for (const double middle :
         {path_.front().time_s - first_scan_s_, path_.back().time_s - last_scan_s_}) {
        if (apart != 0.0 || std::abs(middle) < kFarOff) continue;
        const BestFit far = best_delay(fit, middle);
        if (far.agreement > late.agreement + kFarSurer) late = far;
    }
    const double delay_s = late.hypothesis.delay_s;
    if (apart != 0.0) {
        Message when =
            message(HITOS_TEXT("Errors",
                               "scans are stamped from %1 to %2 s and the odometry from %3 to %4 "
                               "s: they share no time, so that the robot stands still in the map"),
                    fmt::format("{:.3f}", first_scan_s_), fmt::format("{:.3f}", last_scan_s_),
                    fmt::format("{:.3f}", path_.front().time_s),
                    fmt::format("{:.3f}", path_.back().time_s));
        const bool fits = late.agreement > kLeastFit;
        found.push_back(
            {Kind::clocks_apart,
             fits ? delay_s : apart,
             std::move(when),
             {fits ? Remedy{message(HITOS_TEXT("Errors",
                                               "the scans fit the odometry where %1 are added to "
                                               "their times"),
                                    seconds_words(delay_s)),
                            WholeValues(read_).later_by(delay_s)}
                   : Remedy{marked(HITOS_TEXT(
                         "Errors", "set the clocks of both computers alike, and record again"))}},
             fits ? std::optional(delay_s) : std::nullopt});
        return;
    }
    const double told = fit({});
    const BestFit mounted = best_mounting(fit, fan_);
    constexpr double kOffsetStep = 0.1;  // [m]
    constexpr int kOffsetSteps = 20;
    const BestFit longer = best_range_offset(fit, {}, kOffsetStep, kOffsetSteps);
    const double otherwise = std::max({told, late.agreement, mounted.agreement, longer.agreement});
    const std::optional<SetClock> set = set_clock(pairs, otherwise);
    constexpr double kTableStep = 0.25;  // [s]
    constexpr int kTableSteps = 60;
    constexpr double kOverLeaps = 0.07;  // stamps that leap say by how much, unless the robot stood
    const double least =
        set ? set->agreement + kOverLeaps : std::max(kLeastFit, otherwise + kClearly);
    std::optional<TourFinding> clock = changing_clock(pairs, {}, kTableStep, kTableSteps, least);
    if (!clock && set) {
        found.push_back(set->finding);
        return;
    }
    // Where the robot mostly drives straight on, as in corridors, turns alone tell the time.
    constexpr std::size_t kEnough = 32;
    constexpr double kFarBetter = 0.2;
    const Turning turning = turning_pairs();
    if (!clock && turning.pairs.size() >= kEnough) {
        double simply = kLeastFit;
        for (const Hypothesis& other : {Hypothesis{}, late.hypothesis, mounted.hypothesis}) {
            simply = std::max(simply, agreement(turning.pairs, other).value_or(0.0));
        }
        clock = changing_clock(turning.pairs, {}, kTableStep, kTableSteps, simply + kFarBetter);
    }
    if (clock) {
        found.push_back(*std::move(clock));
        return;
    }
    if (doubt_turns(fit, told, otherwise, found)) return;
    const std::size_t before = found.size();
    constexpr double kOverMounting = 0.03;  // which may look like it
    if (longer.agreement >=
            std::max({kLeastFit, told + kClearly,
                      std::max(late.agreement, mounted.agreement) + kOverMounting}) &&
        std::abs(longer.hypothesis.range_offset_m) < kOffsetStep * (kOffsetSteps - 0.5) &&
        beats_standing(longer.agreement)) {
        if (!doubt_dead(found)) tell_range_offset(fit, longer, found);
        return;
    }
    if (doubt_cut_fan(fit, mounted.hypothesis, found) ||
        doubt_drift({mounted.hypothesis, late.hypothesis}, found)) {
        return;
    }
    if (mounted.agreement > late.agreement) doubt_mounting(fit, told, mounted, found);
    if (found.size() > before) return;
    if (late.agreement >= kLeastFit && beats_standing(late.agreement) &&
        late.agreement >= told + kClearly && std::abs(delay_s) >= kShortestDelay &&
        fits_throughout(pairs, late.hypothesis)) {
        if (std::optional<TourFinding> slow = turning_clock(
                turning, agreement(turning.pairs, closely(late.hypothesis)).value_or(0.0))) {
            found.push_back(*std::move(slow));
            return;
        }
        found.push_back(
            {Kind::scan_delay,
             delay_s,
             message(HITOS_TEXT("Errors",
                                "the scans fit the odometry of %1 from theirs (%2 % of their "
                                "points, against %3 % as they are stamped): their clocks differ, "
                                "and the map is wrong by what the robot drove meanwhile"),
                     seconds_words(delay_s), percent(late.agreement), percent(told)),
             {{added_to_times(), WholeValues(read_).later_by(delay_s)}},
             delay_s});
        return;
    }
    if (doubt_dead(found) || doubt_slight_fan(fit, found) ||
        doubt_range_offset(fit, longer, found) || doubt_ray_times(found)) {
        return;
    }
    doubt_scale(found);
    if (found.size() > before || doubt_slight_turn(fit, found)) return;
    doubt_turning(found);
}

/// Whether that is so from the tour's begin to its end, and closely too: by chance, where few scans
/// are asked and hundreds of times, some part of them fits another time. Only those that both put
/// into the odometry are asked.
bool TourExamination::fits_throughout(const Pairs& pairs, const Hypothesis& other) const {
    constexpr std::size_t kLeast = 10;
    constexpr double kBetter = 0.02;
    constexpr double kFarBetter = 0.2;
    constexpr double kCloser = 1.1;
    const Pairs both = of_odometry(of_odometry(pairs, other), {});
    if (both.size() < 2 * kLeast) {  // what shares little time says little
        const Fit fit(*this, pairs);
        return fit(other) >= fit({}) + kFarBetter;
    }
    const Fit all(*this, both);
    if (all(other) < all({}) + kClearly || all(closely(other)) < kCloser * all(closely())) {
        return false;
    }
    const auto half = both.begin() + static_cast<std::ptrdiff_t>(both.size() / 2);
    for (const Pairs& part : {Pairs(both.begin(), half), Pairs(half, both.end())}) {
        const Fit fit(*this, part);
        if (fit(other) < fit({}) + kBetter) return false;
    }
    return true;
}

/// Whether so many points fit that the odometry says more than that the robot stands: by chance,
/// and of slow robots, many do.
bool TourExamination::beats_standing(double share) const {
    constexpr double kMore = 0.1;
    const std::optional<double> standing = agreement({.scale = 0.0, .turn_scale = 0.0});
    return !standing || share >= *standing + kMore;
}

/// Whether nothing explains that the scans do not fit.
void TourExamination::doubt_whole(std::vector<TourFinding>& found) const {
    constexpr double kLooksAlike = 0.8;  // from everywhere, as in a corridor
    if (has_few_rays()) return;
    const double told = agreement(Hypothesis{}).value_or(1.0);
    if (told > kLooksAlike || beats_standing(told)) return;
    if (doubt_turning_rate(found)) return;
    found.push_back(
        {Kind::unfit_odometry,
         told,
         message(HITOS_TEXT("Errors",
                            "the scans do not lie where the odometry puts them (%1 % of their "
                            "points do), and no other time, mounting or scale explains it"),
                 percent(told)),
         {take_it_from_scans()}});
}

/// Whether it often turns as fast as none of its kind does: of rates in degrees whole turns are
/// gone, which no scan brings back.
bool TourExamination::doubt_turning_rate(std::vector<TourFinding>& found) const {
    constexpr double kNoRobot = 5.0;  // [rad/s]
    constexpr std::size_t kLeast = 20;
    constexpr std::size_t kOneIn = 50;
    std::vector<double> rates;
    for (std::size_t i = 1; i < path_.size(); ++i) {
        const double seconds = path_[i].time_s - path_[i - 1].time_s;
        const double rate = std::abs(headings_[i] - headings_[i - 1]) / seconds;
        if (seconds > 0.0 && rate > kNoRobot) rates.push_back(rate);
    }
    if (rates.size() < std::max(kLeast, path_.size() / kOneIn)) return false;
    const double share = static_cast<double>(rates.size()) / static_cast<double>(path_.size());
    const double rate = median(std::move(rates));
    found.push_back(
        {Kind::odometry_units,
         rate,
         message(HITOS_TEXT("Errors",
                            "by %1 % of the odometry readings the robot turns at some %2 "
                            "degrees/s, which none of its kind does, and the scans do not lie "
                            "where that puts them"),
                 percent(share), std::lround(rate * kDegreesPerRadian)),
         {{message(HITOS_TEXT("Errors", "if its turns are %1"),
                   marked(HITOS_TEXT("Errors", "degrees"))),
           WholeValues(read_).odometry_turns(kRadiansPerDegree)},
          take_it_from_scans()}});
    return true;
}

/// Whether the way between two scans is longer or shorter by the scans than by the odometry.
void TourExamination::doubt_scale(std::vector<TourFinding>& found) const {
    constexpr double kLeast = 0.1;
    constexpr double kStep = 0.05;
    constexpr int kSteps = 10;
    constexpr double kMore = 0.02;  // than where it did not drive at all
    constexpr double kLeastFar = 0.12;
    constexpr double kTimes = 1.12;
    constexpr double kTimesNowhere = 1.3;
    constexpr double kAround = 0.15;
    constexpr int kAroundSteps = 30;
    constexpr int kFarSteps = 51;  // to a twelfth, and to twelve times; beyond are units alone
    if (has_few_rays()) return;
    // Over the way of a pair a tenth is a few centimetres.
    const Hypothesis asked = closely();
    const Fit fit(*this, some_pairs(pairs_.size()));
    BestFit best;
    const auto try_out = [&](double scale) {
        Hypothesis hypothesis = asked;
        hypothesis.scale = scale;
        best.try_out(fit, hypothesis);
    };
    for (int i = -kSteps; i <= kSteps; ++i) try_out(1.0 + i * kStep);
    if (std::abs(best.hypothesis.scale - 1.0) > (kSteps - 1.5) * kStep) {
        for (int i = -kFarSteps; i <= kFarSteps; ++i) try_out(std::pow(1.0 + kStep, i));
    }
    for (const LengthUnit& unit : kLengthUnits) {
        try_out(unit.metres);
        try_out(1.0 / unit.metres);
    }
    const double told = fit(asked);
    Hypothesis driven_nowhere = asked;
    driven_nowhere.scale = 0.0;
    const double nowhere = fit(driven_nowhere);
    if (std::abs(best.hypothesis.scale - 1.0) < kLeast - kStep / 2.0 ||
        best.agreement < nowhere + kMore) {
        return;
    }
    // Where scans lie far from each other few of their points lie close, by the right scale too:
    // then it stands out among the others.
    const bool stands_out = best.agreement > std::max(kLeastFar, kTimes * told) &&
                            best.agreement > kTimesNowhere * nowhere;
    if (!stands_out && best.agreement < std::max(kLeastFit, told + kClearly)) return;
    if (sits_elsewhere(best.hypothesis)) return;
    const double scale =
        best.hypothesis.scale * (1.0 + middle_offset(fit, kAround, kAroundSteps, [&](double off) {
                                     Hypothesis other = best.hypothesis;
                                     other.scale *= 1.0 + off;
                                     return other;
                                 }));
    std::vector<Remedy> remedies{
        {say_so(), WholeValues(read_).odometry_scale(scale)},
        {marked(HITOS_TEXT("Errors", "or, where the laser's readings are no metres")),
         WholeValues(read_).range_scale(1.0 / scale)}};
    // Of the laser's, if that would be a unit, and not of the odometry's.
    for (const LengthUnit& unit : kLengthUnits) {
        constexpr double kNear = 0.02;
        if (std::abs(scale * unit.metres - 1.0) > kNear) continue;
        remedies = {
            {message(HITOS_TEXT("Errors", "if the laser's readings are %1"), marked(unit.name)),
             WholeValues(read_).range_scale(unit.metres)},
            {marked(HITOS_TEXT("Errors", "or, where it is the odometry")),
             WholeValues(read_).odometry_scale(scale)}};
    }
    // What somebody has set already is the first to be wrong.
    if (read_.range_scale != 1.0 && read_.odometry_scale == 1.0)
        remedies = {{say_so(), WholeValues(read_).range_scale(1.0 / scale)},
                    {marked(HITOS_TEXT("Errors", "or, where it is the odometry")),
                     WholeValues(read_).odometry_scale(scale)}};
    found.push_back(
        {Kind::odometry_scale, scale,
         message(HITOS_TEXT("Errors",
                            "by the scans the robot drives %1 times as far as by the odometry (%2 "
                            "% of their points fit so, %3 % as it is told)"),
                 fmt::format("{:.3g}", scale), percent(best.agreement), percent(told)),
         std::move(remedies)});
}

/// Whether scans fit the odometry better as they are stamped, or by another time that was found,
/// than as they were received.
bool TourExamination::prefers_stamps(const TourFinding& receipts,
                                     const std::vector<TourFinding>& own) const {
    const std::optional<double> received =
        agreement({.delay_s = receipts.later_s.value_or(receipts.value)});
    if (!received) return true;
    double best = agreement(Hypothesis{}).value_or(0.0);
    for (const TourFinding& finding : own) {
        if (!finding.later_s) continue;
        best = std::max(best, agreement({.delay_s = *finding.later_s}).value_or(0.0));
    }
    return best > *received;
}

}  // namespace hitos
