// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the scans are of one laser that moves through one place, whatever the odometry says.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "hitos/base/median.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "hypothesis_search.hpp"
#include "remedies.hpp"
#include "scan_climb.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

constexpr std::size_t kLeastRays = 20;

/// Whether rays of one number go the same way, as they do not where of two lasers one's is missing.
bool same_rays(const Fan& a, const Fan& b) {
    const double near = 0.5 * a.step_rad();
    return a.count == b.count && std::abs(a.min_angle_rad - b.min_angle_rad) <= near &&
           std::abs(a.max_angle_rad - b.max_angle_rad) <= near;
}

/// The share of the rays known in both that end at about the same distance; nothing of few.
std::optional<double> alike(const RangesByRay& of_a, const RangesByRay& of_b) {
    constexpr float kNear = 0.1F;
    constexpr float kPerRange = 0.02F;
    if (!same_rays(of_a.fan, of_b.fan)) return {};
    const std::vector<float>& a = of_a.ranges;
    const std::vector<float>& b = of_b.ranges;
    std::size_t both = 0;
    std::size_t same = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (a[i] <= 0.0F || b[i] <= 0.0F) continue;
        ++both;
        if (std::abs(a[i] - b[i]) < kNear + kPerRange * a[i]) ++same;
    }
    if (both < kLeastRays) return {};
    return static_cast<double>(same) / static_cast<double>(both);
}

}  // namespace

/// One that is unlike those before and behind it, which are alike, shows another place.
void TourExamination::note_neighbours(const Scan& scan) {
    constexpr double kAlike = 0.6;
    constexpr double kUnlike = 0.4;  // of what those beside it have
    constexpr std::uint32_t kMostRays = 10'000;
    RangesByRay known{scan.fan, {}};
    std::vector<float>& ranges = known.ranges;
    if (scan.rays.size() == scan.points.size() && scan.fan.count <= kMostRays) {
        ranges.resize(scan.fan.count, 0.0F);
        const Point2 laser{scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y};
        for (std::size_t i = 0; i < scan.points.size(); ++i) {
            if (scan.rays[i] < ranges.size())
                ranges[scan.rays[i]] = static_cast<float>(distance(laser, scan.points[i]));
        }
    }
    const std::optional<double> to_last = alike(last_ranges_, known);
    const std::optional<double> past_last = alike(ranges_before_, known);
    if (past_last >= kAlike && to_last && last_alike_) {
        ++steady_scans_;
        if (std::max(*to_last, *last_alike_) <= kUnlike * *past_last) ++foreign_scans_;
    }
    ranges_before_ = std::exchange(last_ranges_, std::move(known));
    last_alike_ = to_last;
}

/// Scans of another laser, or of another place, in between: nothing that is found by pairs holds.
void TourExamination::doubt_foreign_scans(std::vector<TourFinding>& found) const {
    constexpr std::uint64_t kLeast = 10;
    constexpr double kShare = 0.03;  // of stamps that waver, so that scans change places, 0.02
    if (foreign_scans_ < kLeast ||
        static_cast<double>(foreign_scans_) < kShare * static_cast<double>(steady_scans_)) {
        return;
    }
    found.push_back(
        {Kind::foreign_scans,
         static_cast<double>(foreign_scans_) / static_cast<double>(steady_scans_),
         message(HITOS_TEXT("Errors",
                            "%1 scans show another place than those before and behind them, which "
                            "are alike (%2 are): two lasers, or two robots, under one name; the "
                            "map is of both"),
                 foreign_scans_, steady_scans_),
         {{marked(HITOS_TEXT("Errors", "record each laser under a name of its own"))}}});
}

/// Ranges in steps so coarse that no scan lies on another by them.
void TourExamination::doubt_coarse_readings(std::vector<TourFinding>& found) const {
    constexpr std::array kSteps{1.0, 0.5, 0.25, 0.2};  // [m]: a tenth leaves a map what it is
    constexpr double kAll = 0.99;
    constexpr double kOn = 0.005;  // of a step
    constexpr std::size_t kLeast = 1000;
    for (const double of_readings : kSteps) {
        const double step = of_readings * read_.range_scale;
        std::size_t asked = 0;
        std::size_t on = 0;
        for (const Pair& pair : pairs_) {
            for (const float distance : pair.first.distances) {
                const double steps = (static_cast<double>(distance) - read_.range_offset_m) / step;
                ++asked;
                if (std::abs(steps - std::round(steps)) < kOn) ++on;
            }
        }
        if (asked < kLeast || static_cast<double>(on) < kAll * static_cast<double>(asked)) continue;
        found.push_back(
            {Kind::laser_units,
             static_cast<double>(median(medians_)),
             message(HITOS_TEXT("Errors",
                                "the readings go in steps of %1 m, and walls are no better known "
                                "than that; no scan lies on another by them"),
                     fmt::format("{:g}", step)),
             {{marked(HITOS_TEXT("Errors", "record them with the digits that the laser gives"))}}});
        return;
    }
}

TourExamination::ScansAlone TourExamination::scans_alone() const {
    constexpr std::size_t kAsked = 24;
    constexpr double kLeastWay = 0.2;  // by the odometry, a radian counted as a metre [m]: less is
    constexpr double kMostWay = 1.5;   // of one that stands, after more they may see other walls
    constexpr double kReached = 0.05;
    constexpr double kStandsOut = 0.1;
    constexpr double kAside = 0.3;  // [m]
    ScansAlone alone;
    std::size_t pairs = 0;
    std::size_t telling = 0;
    for (const Pair* pair : some_pairs(kAsked)) {
        const auto fit = [&](const Pose& step) {
            return agreement(*pair, step, Hypothesis{}, {}).value_or(0.0);
        };
        const std::optional<Pose> told = step_of(*pair, {});
        double best = told ? fit(nearest_fit(fit, *told)) : 0.0;
        for (const double turn : {0.0, -0.3, 0.3, -0.6, 0.6, -0.9, 0.9}) {
            for (const double way : {0.0, 0.5, -0.5})
                best = std::max(best, fit(nearest_fit(fit, {way, 0.0, turn})));
        }
        const double way = told ? std::hypot(told->x, told->y) + std::abs(told->theta) : 0.0;
        if (way >= kLeastWay && way <= kMostWay) alone.fits.push_back(best);
        // As one that knows nothing of the motion finds it, and no other one.
        const Pose found = nearest_fit(fit, {});
        double aside = 0.0;
        for (int i = 0; i < 8; ++i) {
            const double direction = kPi / 4.0 * i;
            aside = std::max(aside, fit({found.x + kAside * std::cos(direction),
                                         found.y + kAside * std::sin(direction), found.theta}));
        }
        ++pairs;
        const double reached = fit(found);
        if (reached >= best - kReached && reached >= aside + kStandsOut) ++telling;
    }
    std::ranges::sort(alone.fits);
    alone.telling = pairs == 0 ? 0.0 : static_cast<double>(telling) / static_cast<double>(pairs);
    return alone;
}

/// What is held against the odometry holds where the scans are sound, and what is to be taken from
/// them they have to show.
void TourExamination::settle_scans(std::vector<TourFinding>& found) const {
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kLieOnEachOther = 0.65;  // of recorded tours three quarters of all pairs: 0.72
    constexpr double kTell = 0.5;  // of recorded tours 0.1 to 0.4 and 0.9; what was below got lost
    const auto from_scans = [](const Remedy& remedy) {
        return remedy.settings == take_it_from_scans().settings;
    };
    const auto advised = [&](const TourFinding& finding) {
        return std::ranges::any_of(finding.remedies, from_scans);
    };
    // By the scans; what the odometry's own poses and stamps say stands.
    const auto blames = [&](const TourFinding& finding) {
        switch (finding.kind) {
            case Kind::odometry_scale:
            case Kind::odometry_turns:
                return true;
            case Kind::unfit_odometry:
                return advised(finding) ||
                       std::ranges::any_of(finding.remedies, &Remedy::registration);
            case Kind::still_odometry:
                return advised(finding);
            default:
                return false;
        }
    };
    const auto asked = [&](const TourFinding& finding) {
        return blames(finding) || advised(finding);
    };
    if (std::ranges::none_of(found, asked) || pairs_.empty() || has_few_rays()) return;
    const ScansAlone alone = scans_alone();
    if (alone.fits.size() >= kLeastPairs && alone.fits[alone.fits.size() / 4] < kLieOnEachOther) {
        const double fits = alone.fits[alone.fits.size() / 4];
        const bool told = std::ranges::count(found, Kind::foreign_scans, &TourFinding::kind) > 0;
        if (std::erase_if(found, blames) > 0 && !told) {
            found.push_back(
                {Kind::foreign_scans,
                 fits,
                 message(HITOS_TEXT("Errors",
                                    "a quarter of the scans do not lie on the ones before by any "
                                    "motion (at best %1 % of their points do): rays in another "
                                    "order than is said, readings that are none, or scans of "
                                    "another laser among them; the odometry cannot be judged by "
                                    "them"),
                         percent(fits)),
                 {{marked(HITOS_TEXT("Errors", "look at what wrote the scans"))}}});
        }
    } else if (alone.telling >= kTell) {
        return;
    }
    for (TourFinding& finding : found) {
        if (finding.kind == Kind::still_odometry) continue;  // then there is nothing better
        if (std::erase_if(finding.remedies, from_scans) == 0 || !finding.remedies.empty()) continue;
        finding.remedies.push_back(
            {marked(HITOS_TEXT("Errors",
                               "mend what tells it, and record again: the scans alone do not show "
                               "enough of how it moved"))});
    }
}

}  // namespace hitos
