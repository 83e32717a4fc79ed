// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the robot turns, and drives, as far by the odometry as by the scans; and what turns say
// of where the laser sits and of short delays, which straight ways do not show.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/median.hpp"
#include "hypothesis_search.hpp"
#include "laser_pose.hpp"
#include "remedies.hpp"
#include "turned_step.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
BestFit best_turn_scale(const Fit& fit) {
    constexpr int kSteps = 14;
    constexpr double kStep = 1.05;  // to a half, and to twice
    BestFit best{closely()};
    const auto try_out = [&](double scale) {
        Hypothesis other = closely();
        other.pair_turn_scale = scale;
        best.try_out(fit, other);
    };
    for (int i = -kSteps; i <= kSteps; ++i) try_out(std::pow(kStep, i));
    for (const double off : {-0.025, -0.0125, 0.0125, 0.025}) {
        try_out(best.hypothesis.pair_turn_scale * (1.0 + off));
    }
    return best;
}

BestFit best_short_delay(const Fit& fit) {
    constexpr int kSteps = 24;
    constexpr double kStep = 0.025;  // [s]
    BestFit best{closely()};
    for (int i = -kSteps; i <= kSteps; ++i) {
        Hypothesis other = closely();
        other.delay_s = i * kStep;
        best.try_out(fit, other);
    }
    return best;
}

BestFit best_place(const Fit& fit) {
    constexpr int kSteps = 6;
    constexpr double kStep = 0.25;  // [m]
    constexpr double kFinest = 0.03;
    BestFit coarse;
    for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
            coarse.try_out(fit, {.shift = {i * kStep, j * kStep}});
        }
    }
    BestFit best;
    Hypothesis start = closely();
    start.shift = coarse.hypothesis.shift;
    best.try_out(fit, start);
    return climbed(fit, best, kStep / 2.0, kFinest, [](const Hypothesis& from, double step) {
        std::vector<Hypothesis> others(4, from);
        others[0].shift.x -= step;
        others[1].shift.x += step;
        others[2].shift.y -= step;
        others[3].shift.y += step;
        return others;
    });
}

}  // namespace

TourExamination::Turning TourExamination::turning_pairs() const {
    constexpr double kTurn = 0.15;  // [rad]
    constexpr std::size_t kAsked = 128;
    Turning turning;
    std::vector<double> speeds;
    for (const Pair& pair : pairs_) {
        const std::optional<Pose> step = step_of(pair, {});
        if (!step || std::abs(step->theta) < kTurn) continue;
        turning.pairs.push_back(&pair);
        speeds.push_back(std::abs(step->theta) / (pair.second.time_s - pair.first.time_s));
    }
    turning.rad_per_s = median(std::move(speeds));
    const std::size_t every = turning.pairs.size() / kAsked + 1;
    Pairs some;
    for (std::size_t i = 0; i < turning.pairs.size(); i += every) some.push_back(turning.pairs[i]);
    turning.pairs = std::move(some);
    return turning;
}

/// Whether the heading turns away all the time: of a gyro that was not set to zero, or wheels that
/// are not of one size. `otherwise`: what else may explain it.
bool TourExamination::doubt_drift(std::initializer_list<Hypothesis> otherwise,
                                  std::vector<TourFinding>& found) const {
    constexpr double kTimes = 1.25;  // better than as it is told: of sound robots up to a fifth
    constexpr double kMore = 0.02;
    constexpr double kLeast = 0.15;
    constexpr int kSteps = 16;
    constexpr double kPerSecond = 0.3 * kRadiansPerDegree;
    constexpr double kPerMetre = 1.0 * kRadiansPerDegree;
    constexpr double kSlight = 2.0;  // steps
    constexpr int kDegrees = 12;
    const Fit fit(*this, some_pairs(pairs_.size()));
    // A laser that is turned a little sees the same at first sight: it moves aside with the way.
    BestFit turned{closely()};
    for (int degrees = -kDegrees; degrees <= kDegrees; ++degrees) {
        Hypothesis other = closely();
        other.turn_rad = degrees * kRadiansPerDegree;
        turned.try_out(fit, other);
    }
    BestFit by_time{closely()};
    BestFit by_way{closely()};
    for (int i = -kSteps; i <= kSteps; ++i) {
        Hypothesis other = closely();
        other.drift_rad_s = i * kPerSecond;
        by_time.try_out(fit, other);
        other = closely();
        other.drift_rad_m = i * kPerMetre;
        by_way.try_out(fit, other);
    }
    const bool timed = by_time.agreement > by_way.agreement;
    const BestFit& best = timed ? by_time : by_way;
    const double rate = timed ? best.hypothesis.drift_rad_s : best.hypothesis.drift_rad_m;
    const double told = fit(closely());
    const auto beaten_by = [&](double rival) { return best.agreement < kTimes * rival + kMore; };
    if (std::abs(rate) < (kSlight - 0.5) * (timed ? kPerSecond : kPerMetre) ||
        best.agreement < kLeast || beaten_by(told) ||
        std::ranges::any_of(
            otherwise, [&](const Hypothesis& other) { return beaten_by(fit(closely(other))); }) ||
        beaten_by(best_turn_scale(fit).agreement) || best.agreement < turned.agreement ||
        sits_elsewhere(best.hypothesis)) {
        return false;
    }
    const std::string degrees = fmt::format("{:.1f}", std::abs(rate) * kDegreesPerRadian);
    const Message side =
        rate < 0.0 ? marked(HITOS_TEXT("Errors", "left")) : marked(HITOS_TEXT("Errors", "right"));
    found.push_back(
        {Kind::unfit_odometry,
         told,
         timed ? message(HITOS_TEXT("Errors",
                                    "by the scans the odometry's heading drifts to the %2 by %1 "
                                    "degrees a second (%3 % of their points fit so, %4 % as it is "
                                    "told), as of a gyro whose zero is off: the path is bent"),
                         degrees, side, percent(best.agreement), percent(told))
               : message(HITOS_TEXT("Errors",
                                    "by the scans the odometry's heading drifts to the %2 by %1 "
                                    "degrees a metre (%3 % of their points fit so, %4 % as it is "
                                    "told), as of wheels that are not of one size: the path is "
                                    "bent"),
                         degrees, side, percent(best.agreement), percent(told)),
         {map_with_registration(), take_it_from_scans()}});
    return true;
}

/// Whether the pairs agree on a scale of turns. Where each turn is off by itself, all of them fit
/// best where they are made smaller, which mends none of them.
bool TourExamination::is_scale_of_each(const Pairs& pairs, double scale) const {
    constexpr int kSteps = 20;
    constexpr double kStep = 1.04;
    constexpr double kSame = 0.1;
    std::vector<double> off;
    for (const Pair* pair : pairs) {
        double best = 0.0;
        double highest = 0.0;
        for (int i = -kSteps; i <= kSteps; ++i) {
            Hypothesis other = closely();
            other.pair_turn_scale = scale * std::pow(kStep, i);
            const double fits = agreement(*pair, other).value_or(0.0);
            if (fits <= highest) continue;
            highest = fits;
            best = std::abs(i) * std::log(kStep);
        }
        if (highest > 0.0) off.push_back(best);
    }
    return !off.empty() && median(std::move(off)) <= kSame;
}

/// Whether a laser that sits elsewhere explains what the scans say better than that does: where the
/// robot turns, it drives another way then.
bool TourExamination::sits_elsewhere(const Hypothesis& instead) const {
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kNear = 0.2;  // [m]
    constexpr double kFar = 1.5;
    constexpr double kBetter = 0.02;
    const Turning turning = turning_pairs();
    if (turning.pairs.size() < kLeastPairs) return false;
    const Fit fit(*this, turning.pairs);
    const BestFit placed = best_place(fit);
    const Point2& shift = placed.hypothesis.shift;
    const Pose& said = fan_.pose_robot_laser;
    if (std::hypot(shift.x, shift.y) < kNear ||
        std::hypot(said.x + shift.x, said.y + shift.y) > kFar) {
        return false;
    }
    const Fit all(*this, some_pairs(pairs_.size()));
    return placed.agreement > fit(closely(instead)) + kBetter &&
           all(placed.hypothesis) >= all(closely(instead));
}

/// Of what fits turns clearly better than what the tour says, the best.
void TourExamination::doubt_turning(std::vector<TourFinding>& found) const {
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kTimes = 1.2;  // better than as it is told
    constexpr double kMore = 0.03;
    constexpr double kLeast = 0.15;
    const Turning turning = turning_pairs();
    if (turning.pairs.size() < kLeastPairs) return;
    const Fit fit(*this, turning.pairs);
    const double told = fit(closely());
    if (kTimes * told + kMore > 1.0) return;
    const BestFit turned = best_turn_scale(fit);
    const BestFit late = best_short_delay(fit);
    const BestFit placed = best_place(fit);
    const double best = std::max({turned.agreement, late.agreement, placed.agreement});
    if (std::optional<TourFinding> clock = turning_clock(turning, std::max(best, told))) {
        found.push_back(*std::move(clock));
        return;
    }
    if (best < kLeast || best < kTimes * told + kMore) return;
    if (late.agreement == best) {
        constexpr double kShortest = 0.08;  // [s]: a sweep takes as long
        constexpr double kFar = 0.12;       // what it moves in the map [m]
        constexpr double kSure = 0.5;       // scans that lie a metre apart fit less, at any time
        const double delay_s = late.hypothesis.delay_s;
        const double moved_m =
            std::abs(delay_s) * turning.rad_per_s * static_cast<double>(median(medians_));
        if (best < kSure || std::abs(delay_s) < kShortest || moved_m < kFar) return;
        found.push_back(
            {Kind::scan_delay,
             delay_s,
             message(HITOS_TEXT("Errors",
                                "where the robot turns, the scans fit the odometry of %1 s from "
                                "theirs (%2 % of their points closely, against %3 % as they are "
                                "stamped): walls move by %4 m in its turns"),
                     fmt::format("{:.2f}", delay_s), percent(best), percent(told),
                     fmt::format("{:.2f}", moved_m)),
             {{added_to_times(), WholeValues(read_).later_by(delay_s)}},
             delay_s});
        return;
    }
    if (placed.agreement == best) {
        constexpr double kNear = 0.2;  // [m]
        const Point2 shift = placed.hypothesis.shift;
        const double off_m = std::hypot(shift.x, shift.y);
        // Where it would sit farther off than a robot is large it is another thing, as readings
        // that are no metres.
        constexpr double kFar = 1.5;
        const Pose& said = fan_.pose_robot_laser;
        if (off_m < kNear || std::hypot(said.x + shift.x, said.y + shift.y) > kFar) return;
        constexpr double kDecimetre = 0.1;
        constexpr double kLeastShown = 0.12;
        constexpr double kStandsOut = 0.03;
        if (way_shown(kDecimetre, 1.0, kLeastShown) >
            std::max(0.0, way_shown(1.0, 1.0, kLeastShown)) + kStandsOut) {
            found.push_back(
                {Kind::laser_units,
                 static_cast<double>(median(medians_)),
                 message(HITOS_TEXT("Errors",
                                    "half of the readings are beyond %1 m, and by the odometry "
                                    "they are %2; the map is that many times too large"),
                         fmt::format("{:.0f}", median(medians_)),
                         marked(HITOS_TEXT("Errors", "decimetres"))),
                 {{marked(HITOS_TEXT("Errors", "read them as such")),
                   WholeValues(read_).range_scale(kDecimetre)}}});
            return;
        }
        Pose laser = fan_.pose_robot_laser;
        laser.x += shift.x;
        laser.y += shift.y;
        found.push_back(
            {Kind::misplaced_laser,
             off_m,
             message(
                 HITOS_TEXT(
                     "Errors",
                     "where the robot turns, the scans fit a laser that sits %1 m from where it is "
                     "said to (%2 % of their points closely, against %3 %): walls are bent there"),
                 fmt::format("{:.2f}", off_m), percent(best), percent(told)),
             {{marked(HITOS_TEXT("Errors", "say where it sits")),
               laser_at({laser, fan_.upside_down})}}});
        return;
    }
    constexpr double kNearlyOne = 0.07;
    constexpr double kAround = 0.08;
    constexpr int kSteps = 16;
    double scale = turned.hypothesis.pair_turn_scale;
    if (std::abs(scale - 1.0) < kNearlyOne) return;
    if (!is_scale_of_each(turning.pairs, scale)) return;
    scale *= 1.0 + middle_offset(fit, kAround, kSteps, [&](double off) {
                 Hypothesis other = turned.hypothesis;
                 other.pair_turn_scale *= 1.0 + off;
                 return other;
             });
    found.push_back(
        {Kind::odometry_turns,
         scale,
         message(
             HITOS_TEXT(
                 "Errors",
                 "by the scans the robot turns %1 times as far as by the odometry (%2 % of their "
                 "points fit closely so, %3 % as it is told): walls fan out where it turns"),
             fmt::format("{:.2f}", scale), percent(best), percent(told)),
         {{say_so(), WholeValues(read_).odometry_turns(scale)}, map_with_registration()}});
}

}  // namespace hitos
