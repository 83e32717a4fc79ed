// Whether the robot turns, and drives, as far by the odometry as by the scans; and what turns say
// of where the laser sits and of short delays, which straight ways do not show.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hitos/base/median.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "turned_step.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using Hypothesis = TourExamination::Hypothesis;
using Fit = std::function<double(const Hypothesis&)>;

/// Over the turn of a pair, what is looked for here is a few centimetres.
constexpr Hypothesis kClosely{.near_m = 0.02, .near_per_range = 0.005};

/// How far a robot drives along an arc.
double way_along(const Pose& step) {
    return step.x * std::cos(step.theta / 2.0) + step.y * std::sin(step.theta / 2.0);
}

/// The best of some hypotheses.
struct BestTurn {
    Hypothesis hypothesis = kClosely;
    double agreement = 0.0;

    void try_out(const Fit& fit, const Hypothesis& other) {
        const double found = fit(other);
        if (found <= agreement) return;
        hypothesis = other;
        agreement = found;
    }
};

BestTurn best_turn_scale(const Fit& fit) {
    constexpr double kGreatest = 2.0;
    constexpr double kStep = 1.05;
    BestTurn best;
    const auto try_out = [&](double scale) {
        Hypothesis other = kClosely;
        other.pair_turn_scale = scale;
        best.try_out(fit, other);
    };
    for (double scale = kGreatest; scale > 1.0 / kGreatest; scale /= kStep) try_out(scale);
    for (const double off : {-0.025, -0.0125, 0.0125, 0.025}) {
        try_out(best.hypothesis.pair_turn_scale * (1.0 + off));
    }
    return best;
}

BestTurn best_short_delay(const Fit& fit) {
    constexpr int kSteps = 24;
    constexpr double kStep = 0.025;  // [s]
    BestTurn best;
    for (int i = -kSteps; i <= kSteps; ++i) {
        Hypothesis other = kClosely;
        other.delay_s = i * kStep;
        best.try_out(fit, other);
    }
    return best;
}

BestTurn best_place(const Fit& fit) {
    constexpr int kSteps = 6;
    constexpr double kStep = 0.25;  // [m]
    constexpr double kFinest = 0.03;
    BestTurn coarse;
    for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
            coarse.try_out(fit, {.shift = {i * kStep, j * kStep}});
        }
    }
    BestTurn best;
    Hypothesis start = kClosely;
    start.shift = coarse.hypothesis.shift;
    best.try_out(fit, start);
    for (double step = kStep / 2.0; step > kFinest; step /= 2.0) {
        for (bool better = true; better;) {
            const BestTurn from = best;
            for (const Point2& to :
                 {Point2{step, 0}, Point2{-step, 0}, Point2{0, step}, Point2{0, -step}}) {
                Hypothesis other = from.hypothesis;
                other.shift = {other.shift.x + to.x, other.shift.y + to.y};
                best.try_out(fit, other);
            }
            better = best.agreement > from.agreement;
        }
    }
    return best;
}

/// How the robot moved between two scans: the odometry's step, with the turn and the way with which
/// they fit best where that is clearly better.
Pose nearest_arc(const std::function<double(const Pose&)>& fit, const Pose& step) {
    constexpr double kClear = 0.1;
    constexpr double kTimes = 1.25;
    constexpr double kWell = 0.85;
    const double told = fit(step);
    if (told > kWell) return step;
    Pose best = step;
    double highest = told;
    const auto try_out = [&](const Pose& other) {
        const double found = fit(other);
        if (found <= highest) return;
        highest = found;
        best = other;
    };
    const auto turn = [&](int steps, double each) {
        const Pose from = best;
        for (int i = -steps; i <= steps; ++i) try_out(with_turn(from, from.theta + i * each));
    };
    const auto drive = [&](int steps, double each) {
        const Pose from = best;
        const double direction = from.theta / 2.0;
        for (int i = -steps; i <= steps; ++i) {
            try_out({from.x + i * each * std::cos(direction),
                     from.y + i * each * std::sin(direction), from.theta});
        }
    };
    turn(32, 0.05);
    drive(15, 0.1);
    turn(6, 0.05);
    drive(3, 0.03);
    turn(2, 0.02);
    return highest > kTimes * told + kClear ? best : step;
}

}  // namespace

struct TourExamination::Turning {
    std::vector<const Pair*> pairs;
    double rad_per_s = 0.0;  ///< how fast half of them turn, or faster
};

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
    std::vector<const Pair*> some;
    for (std::size_t i = 0; i < turning.pairs.size(); i += every) some.push_back(turning.pairs[i]);
    turning.pairs = std::move(some);
    return turning;
}

/// Of what fits turns clearly better than what the tour says, the best.
bool TourExamination::doubt_turning(std::vector<TourFinding>& found) const {
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kTimes = 1.2;  // better than as it is told
    constexpr double kMore = 0.03;
    constexpr double kFits = 0.15;
    const Turning turning = turning_pairs();
    if (turning.pairs.size() < kLeastPairs) return false;
    const Fit fit = [&](const Hypothesis& hypothesis) {
        double sum = 0.0;
        std::size_t count = 0;
        for (const Pair* pair : turning.pairs) {
            const std::optional<double> one = agreement(*pair, hypothesis);
            if (!one) continue;
            sum += *one;
            ++count;
        }
        return count < kLeastPairs ? 0.0 : sum / static_cast<double>(count);
    };
    const double told = fit(kClosely);
    const BestTurn turned = best_turn_scale(fit);
    const BestTurn late = best_short_delay(fit);
    const BestTurn placed = best_place(fit);
    const double best = std::max({turned.agreement, late.agreement, placed.agreement});
    if (best < kFits || best < kTimes * told + kMore) return false;
    const auto percent = [](double share) { return std::lround(100.0 * share); };
    if (late.agreement == best) {
        constexpr double kShortest = 0.08;  // [s]: a sweep takes as long
        constexpr double kFar = 0.12;       // what it moves in the map [m]
        constexpr double kSure = 0.5;       // scans that lie a metre apart fit less, at any time
        const double delay_s = late.hypothesis.delay_s;
        const double moved_m =
            std::abs(delay_s) * turning.rad_per_s * static_cast<double>(median(medians_));
        if (best < kSure || std::abs(delay_s) < kShortest || moved_m < kFar) return false;
        found.push_back(
            {Kind::scan_delay, delay_s,
             message(HITOS_TEXT("Errors",
                                "where the robot turns, the scans fit the odometry of %1 s from "
                                "theirs (%2 % of their points closely, against %3 % as they are "
                                "stamped): walls move by %4 m in its turns"),
                     fmt::format("{:.2f}", delay_s), percent(best), percent(told),
                     fmt::format("{:.2f}", moved_m)),
             message(HITOS_TEXT("Errors", "add that to their times: --scan-delay %1"),
                     fmt::format("{:.2f}", delay_s)),
             delay_s});
        return true;
    }
    if (placed.agreement == best) {
        constexpr double kNear = 0.2;  // [m]
        const Point2 shift = placed.hypothesis.shift;
        const double off_m = std::hypot(shift.x, shift.y);
        if (off_m < kNear) return false;
        const Pose& laser = pairs_.front().first.pose_robot_laser;
        found.push_back(
            {Kind::misplaced_laser, off_m,
             message(HITOS_TEXT("Errors",
                                "where the robot turns, the scans fit a laser that sits %1 m from "
                                "where it is said to (%2 % of their points closely, against %3 %): "
                                "walls are bent there"),
                     fmt::format("{:.2f}", off_m), percent(best), percent(told)),
             message(HITOS_TEXT("Errors", "say where it sits: --laser-pose %1"),
                     fmt::format("{:.2f},{:.2f},{:.3g}", laser.x + shift.x, laser.y + shift.y,
                                 laser.theta * kDegreesPerRadian))});
        return true;
    }
    constexpr double kNearlyOne = 0.07;
    const double scale = turned.hypothesis.pair_turn_scale;
    if (std::abs(scale - 1.0) < kNearlyOne) return false;
    found.push_back(
        {Kind::odometry_turns, scale,
         message(HITOS_TEXT("Errors",
                            "by the scans the robot turns %1 times as far as by the odometry (%2 % "
                            "of their points fit closely so, %3 % as it is told): walls fan out "
                            "where it turns"),
                 fmt::format("{:.2f}", scale), percent(best), percent(told)),
         marked(HITOS_TEXT("Errors",
                           "take how it moved from the scans: --set source.odometry=scans; "
                           "or map it with registration: --preset recorded"))});
    return true;
}

/// A gyro or an encoder that is dead: the robot turns, or drives, by the scans alone.
bool TourExamination::doubt_dead(std::vector<TourFinding>& found) const {
    constexpr std::size_t kAsked = 256;
    constexpr std::size_t kLeastPairs = 5;
    constexpr double kSlight = 0.1;   // a pair, by the odometry [m], [rad]: more is not dead
    constexpr double kLittle = 0.15;  // of what the scans say
    constexpr double kNone = 0.05;    // of the way: more is one of its scale
    constexpr double kLeastTurn = kPi / 2.0;
    constexpr double kLeastWay = 2.0;
    constexpr Hypothesis kNear{.near_m = 0.04, .near_per_range = 0.01};
    struct Sum {
        double odometry = 0.0;
        double scans = 0.0;
        std::size_t differ = 0;
        void note(double told, double seen) {
            odometry += std::abs(told);
            scans += std::abs(seen);
            if (std::abs(seen - told) > kSlight) ++differ;
        }
        bool dead(double least, double little) const {
            return differ >= kLeastPairs && scans > least && odometry < little * scans;
        }
    };
    Sum turn;
    Sum way;
    std::size_t count = 0;
    const std::size_t every = std::max<std::size_t>(pairs_.size() / kAsked, 1);
    for (std::size_t i = 0; i < pairs_.size(); i += every) {
        const std::optional<Pose> step = step_of(pairs_[i], {});
        if (!step) continue;
        ++count;
        turn.odometry += std::abs(step->theta);
        way.odometry += std::abs(way_along(*step));
    }
    const double slight = kSlight * static_cast<double>(count);
    if (turn.odometry > slight && way.odometry > slight) return false;
    turn = way = {};
    for (std::size_t i = 0; i < pairs_.size(); i += every) {
        const std::optional<Pose> step = step_of(pairs_[i], {});
        if (!step) continue;
        const Pose seen = nearest_arc(
            [&](const Pose& other) { return agreement(pairs_[i], other, kNear).value_or(0.0); },
            *step);
        turn.note(step->theta, seen.theta);
        way.note(way_along(*step), way_along(seen));
    }
    const bool turns = turn.dead(kLeastTurn, kLittle);
    const bool drives = way.dead(kLeastWay, kNone);
    if (!turns && !drives) return false;
    const Message remedy = marked(
        HITOS_TEXT("Errors", "take how it moved from the scans: --set source.odometry=scans"));
    found.push_back(
        {Kind::still_odometry, 0.0,
         turns ? message(HITOS_TEXT("Errors",
                                    "in %1 pairs of scans the robot turns %2 degrees by the scans "
                                    "and %3 by the odometry, as where a gyro or an encoder is "
                                    "dead; the map is bent straight"),
                         count, std::lround(turn.scans * kDegreesPerRadian),
                         std::lround(turn.odometry * kDegreesPerRadian))
               : message(HITOS_TEXT("Errors",
                                    "in %1 pairs of scans the robot drives %2 m by the scans and "
                                    "%3 m by the odometry, as where an encoder is dead; the map is "
                                    "pushed together"),
                         count, fmt::format("{:.1f}", way.scans),
                         fmt::format("{:.1f}", way.odometry)),
         remedy});
    return true;
}

}  // namespace hitos
