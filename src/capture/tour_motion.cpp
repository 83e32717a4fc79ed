// SPDX-License-Identifier: GPL-3.0-or-later
// How the robot moved from scan to scan, by the scans, where the odometry says otherwise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hitos/base/median.hpp"
#include "hypothesis_search.hpp"
#include "remedies.hpp"
#include "turned_step.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

/// How far a robot drives along an arc.
double way_along(const Pose& step) {
    return step.x * std::cos(step.theta / 2.0) + step.y * std::sin(step.theta / 2.0);
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

/// Between rays that lie far apart a wall's distance is not known better.
TourExamination::Hypothesis TourExamination::near_walls() const {
    constexpr double kPerRange = 0.01;
    return {.near_m = 0.04, .near_per_range = std::max(kPerRange, std::abs(fan_.step_rad()) / 2.0)};
}

std::vector<TourExamination::Motion> TourExamination::motions() const {
    constexpr std::size_t kAsked = 128;
    const Hypothesis near = near_walls();
    std::vector<Motion> all;
    for (const Pair* pair : some_pairs(kAsked)) {
        const std::optional<Pose> told = step_of(*pair, {});
        if (!told) continue;
        all.push_back({*told, nearest_arc(
                                  [&](const Pose& other) {
                                      return agreement(*pair, other, near, {}).value_or(0.0);
                                  },
                                  *told)});
    }
    return all;
}

/// How far the robot drove by the scans where the odometry hardly moved and they do not lie on each
/// other at all; 0 where it stood, or nothing tells.
double TourExamination::slipped_m(const Pair& pair) const {
    constexpr double kStands = 0.05;  // [m]
    constexpr double kTurns = 0.5;    // [rad]: then other walls are seen
    constexpr double kOfFan = 0.2;
    constexpr double kTimes = 2.0;
    constexpr double kNothing = 0.1;
    constexpr double kFits = 0.3;
    constexpr double kLeast = 0.5;  // [m]
    constexpr double kStep = 0.1;
    constexpr int kSteps = 60;
    const std::optional<Pose> told = step_of(pair, {});
    const double most_rad = std::min(kTurns, kOfFan * pair.first.span_rad);
    if (!told || std::hypot(told->x, told->y) > kStands || std::abs(told->theta) > most_rad)
        return 0.0;
    const Hypothesis near = near_walls();
    const auto fit = [&](double way_m) {
        const double direction = told->theta / 2.0;
        const Pose step{way_m * std::cos(direction), way_m * std::sin(direction), told->theta};
        return agreement(pair, step, near, {}).value_or(0.0);
    };
    const std::optional<double> stood = agreement(pair, *told, near, {});
    if (!stood || *stood > kNothing) return 0.0;
    double best = kFits;
    double way_m = 0.0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        const double fits = fit(i * kStep);
        if (fits <= best) continue;
        best = fits;
        way_m = i * kStep;
    }
    // Wheels slip at a speed at which they drive; far off it is another wall that fits.
    const double most_m =
        kTimes * static_cast<double>(median(speeds_)) * (pair.second.time_s - pair.first.time_s) +
        kLeast;
    return std::abs(way_m) < kLeast || std::abs(way_m) > most_m ? 0.0 : way_m;
}

/// Wheels that slip for a while, or a robot that is pushed: the scans move on, and the odometry
/// turns at most.
void TourExamination::doubt_slip(std::vector<TourFinding>& found) const {
    constexpr double kLeastWay = 1.0;
    double way_m = 0.0;
    const Pair* first = nullptr;
    const Pair* last = nullptr;
    for (const Pair& pair : pairs_) {
        const double slipped = slipped_m(pair);
        if (slipped == 0.0) continue;
        if (first == nullptr) first = &pair;
        last = &pair;
        way_m += std::abs(slipped);
    }
    if (way_m < kLeastWay) return;
    found.push_back(
        {Kind::still_odometry,
         last->second.time_s - first->first.time_s,
         message(HITOS_TEXT("Errors",
                            "between second %1 and %2 of the tour the scans move by %3 m or more "
                            "while the odometry at most turns, as where wheels slip or the robot "
                            "is pushed: the map is pushed together there"),
                 std::lround(first->first.time_s - first_scan_s_),
                 std::lround(last->second.time_s - first_scan_s_), fmt::format("{:.1f}", way_m)),
         {map_with_registration(), take_it_from_scans()}});
}

/// A gyro or an encoder that is dead: the robot turns, or drives, by the scans alone.
bool TourExamination::doubt_dead(std::vector<TourFinding>& found) const {
    constexpr std::size_t kLeastPairs = 5;
    constexpr double kDiffers = 0.1;  // a pair [m], [rad]
    constexpr double kLittle = 0.15;  // of what the scans say
    constexpr double kNone = 0.05;    // of the way: more is one of its scale
    constexpr double kLeastTurn = kPi / 2.0;
    constexpr double kLeastWay = 2.0;
    struct Sum {
        double odometry = 0.0;
        double scans = 0.0;
        std::size_t differ = 0;
        void note(double told, double seen) {
            odometry += std::abs(told);
            scans += std::abs(seen);
            if (std::abs(seen - told) > kDiffers) ++differ;
        }
        bool dead(double least, double little) const {
            return differ >= kLeastPairs && scans > least && odometry < little * scans;
        }
    };
    constexpr double kSlight = 0.1;  // a pair, by the odometry: more is not dead
    double turned_rad = 0.0;
    double driven_m = 0.0;
    for (const Pair& pair : pairs_) {
        const Pose step = step_of(pair, {}).value_or(Pose{});
        turned_rad += std::abs(step.theta);
        driven_m += std::abs(way_along(step));
    }
    const double slight = kSlight * static_cast<double>(pairs_.size());
    if (turned_rad > slight && driven_m > slight) return false;
    Sum turn;
    Sum way;
    const std::vector<Motion> all = motions();
    for (const auto& [told, seen] : all) {
        turn.note(told.theta, seen.theta);
        way.note(way_along(told), way_along(seen));
    }
    const Remedy remedy = take_it_from_scans();
    if (turn.dead(kLeastTurn, kLittle)) {
        found.push_back(
            {Kind::still_odometry,
             0.0,
             message(
                 HITOS_TEXT(
                     "Errors",
                     "in %1 pairs of scans the robot turns %2 degrees by the scans and %3 by the "
                     "odometry, as where a gyro or an encoder is dead; the map is bent straight"),
                 all.size(), std::lround(turn.scans * kDegreesPerRadian),
                 std::lround(turn.odometry * kDegreesPerRadian)),
             {remedy}});
    } else if (way.dead(kLeastWay, kNone)) {
        found.push_back(
            {Kind::still_odometry,
             0.0,
             message(HITOS_TEXT(
                         "Errors",
                         "in %1 pairs of scans the robot drives %2 m by the scans and %3 m by the "
                         "odometry, as where an encoder is dead; the map is pushed together"),
                     all.size(), fmt::format("{:.1f}", way.scans),
                     fmt::format("{:.1f}", way.odometry)),
             {remedy}});
    } else {
        return false;
    }
    return true;
}

/// Odometry that is wrong from scan to scan, now this way and now that: of stamps that waver, or
/// poses that are rounded.
void TourExamination::doubt_motion(std::vector<TourFinding>& found) const {
    constexpr double kSlow = 0.4;  // [s] from reading to reading: between them nobody knows
    const double odometry_s = path_.size() < 2
                                  ? 0.0
                                  : (path_.back().time_s - path_.front().time_s) /
                                        static_cast<double>((path_.size() - 1) * path_stride_);
    if (has_few_rays() || odometry_s > kSlow) return;
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kMost = 0.17;    // of what is driven; of sound robots up to a tenth
    constexpr double kDiffers = 0.1;  // a pair, a radian counted as a metre [m]
    double off = 0.0;
    double seen_m = 0.0;
    std::size_t differ = 0;
    const std::vector<Motion> all = motions();
    for (const auto& [told, seen] : all) {
        const double one =
            std::abs(seen.theta - told.theta) + std::abs(way_along(seen) - way_along(told));
        off += one;
        seen_m += std::abs(seen.theta) + std::abs(way_along(seen));
        if (one > kDiffers) ++differ;
    }
    if (differ < kLeastPairs || off < kMost * seen_m) return;
    found.push_back(
        {Kind::unfit_odometry,
         off / seen_m,
         message(
             HITOS_TEXT(
                 "Errors",
                 "from scan to scan the odometry is off by %1 % of what the robot drives and turns "
                 "by the scans, now this way and now that (by more than a hand's breadth in %2 of "
                 "%3 pairs), as where stamps waver or poses are rounded: walls are blurred"),
             percent(off / seen_m), differ, all.size()),
         {map_with_registration()}});
}

}  // namespace hitos
