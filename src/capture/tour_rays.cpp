// SPDX-License-Identifier: GPL-3.0-or-later
// In which directions a scan's rays go, and when each of them was measured, by the odometry.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hypothesis_search.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

constexpr double kLeastTold = 0.15;  // of the points: scans that lie metres apart fit no better

double middle_of(const Fan& fan) {
    return wrap_angle((fan.min_angle_rad + fan.max_angle_rad) / 2.0);
}

/// The best of what might be taken for a fan that is a little wider or narrower.
double best_rival(const Fit& fit) {
    constexpr int kSteps = 10;
    constexpr double kScale = 0.02;
    constexpr double kDelay = 0.05;  // [s]
    BestFit best;
    for (int i = -kSteps; i <= kSteps; ++i) {
        Hypothesis other = closely();
        other.pair_turn_scale = 1.0 + i * kScale;
        best.try_out(fit, other);
        other = closely();
        other.scale = 1.0 + i * kScale;
        best.try_out(fit, other);
        other = closely();
        other.turn_rad = i * kRadiansPerDegree;
        best.try_out(fit, other);
        other = closely();
        other.delay_s = i * kDelay;
        best.try_out(fit, other);
    }
    return best.agreement;
}

bool beats_rivals(const Fit& fit, const BestFit& best, const BestFit& other) {
    constexpr double kMore = 0.02;
    Hypothesis driven_nowhere = closely();
    driven_nowhere.scale = 0.0;
    driven_nowhere.turn_scale = 0.0;
    return best.agreement >=
           std::max({best_rival(fit), fit(driven_nowhere), other.agreement}) + kMore;
}

/// The best of fans a little wider or narrower.
BestFit best_slight_fan(const Fit& fit, const Fan& fan) {
    constexpr int kSteps = 20;
    constexpr double kStep = 0.01;
    BestFit best{closely()};
    for (int i = -kSteps; i <= kSteps; ++i) {
        Hypothesis other = closely();
        other.fan_scale += i * kStep;
        other.fan_middle_rad = middle_of(fan);
        best.try_out(fit, other);
    }
    return best;
}

constexpr int kOffsetSteps = 10;
constexpr double kOffsetStep = 0.05;  // [m]

/// From there to where a few centimetres tell.
BestFit exact_range_offset(const Fit& fit, const Hypothesis& about) {
    constexpr double kStep = 0.05;  // [m]
    constexpr double kFinest = 0.01;
    BestFit best;
    best.try_out(fit, closely(about));
    return climbed(fit, best, kStep, kFinest, [](const Hypothesis& from, double step) {
        std::array<Hypothesis, 2> others{from, from};
        others[0].range_offset_m -= step;
        others[1].range_offset_m += step;
        return others;
    });
}

/// As source.ray_time says a sweep of so long.
std::string ray_time_of(double sweep_s, const Fan& fan) {
    return fmt::format("{:.3g}", sweep_s / static_cast<double>(std::max(fan.count, 2U) - 1));
}

/// The least that source.ray_time can say: all rays are of one time.
constexpr const char* kOneTime = "1e-9";
constexpr const char* kRayTimeKey = "source.ray_time";

}  // namespace

void TourExamination::tell_fan(const Fit& fit, double told, const BestFit& mounted,
                               std::vector<TourFinding>& found) const {
    constexpr double kAround = 0.03;
    constexpr int kAroundSteps = 15;
    const Hypothesis& other = mounted.hypothesis;
    const double scale =
        other.fan_scale + middle_offset(fit, kAround, kAroundSteps, [&](double off) {
            Hypothesis near = closely(other);
            near.fan_scale += off;
            return near;
        });
    const double angle = std::abs(fan_.max_angle_rad - fan_.min_angle_rad);
    const auto degrees = [](double rad) { return std::lround(rad * kDegreesPerRadian); };
    // The option widens from where the laser looks, and not from the middle ray.
    const double turn_rad = other.turn_rad + other.fan_middle_rad * (1.0 - scale);
    constexpr double kSlight = 0.5 * kRadiansPerDegree;
    Pose pose = fan_.pose_robot_laser;
    pose.theta += turn_rad;
    std::vector<SourceSetting> settings = WholeValues(read_).fan_scale(scale);
    if (std::abs(turn_rad) >= kSlight) settings = settings + laser_at({pose, fan_.upside_down});
    found.push_back(
        {Kind::wrong_fan,
         angle * scale,
         message(
             HITOS_TEXT("Errors",
                        "the scans fit the odometry where their rays go over %1 degrees, not over "
                        "%2 as is told (%3 % of their points, against %4 %): walls are bent"),
             degrees(angle * scale), degrees(angle), percent(mounted.agreement), percent(told)),
         {{say_so(), std::move(settings)}}});
}

/// Whether the rays go over an angle that differs by less than best_mounting() tells apart: then
/// walls are bent in one place, and turns too long or too short.
bool TourExamination::doubt_slight_fan(const Fit& fit, std::vector<TourFinding>& found) const {
    constexpr double kLeast = 0.015;
    constexpr double kTimes = 1.04;  // better than as it is told: half as much is seen where
    constexpr double kMore = 0.01;   // nothing is wrong
    if (fan_.count < 2) return false;
    const BestFit best = best_slight_fan(fit, fan_);
    const double told = fit(closely());
    if (std::abs(best.hypothesis.fan_scale - 1.0) < kLeast ||
        best.agreement < std::max(kLeastTold, kTimes * told + kMore)) {
        return false;
    }
    const BestFit longer = best_range_offset(fit, closely(), kOffsetStep, kOffsetSteps);
    if (!beats_rivals(fit, best, longer)) return false;
    tell_fan(fit, told, best, found);
    return true;
}

/// Whether rays are missing at one end of the fan, whose others are taken to go over all of it:
/// then the laser seems turned, and walls are bent too.
bool TourExamination::doubt_cut_fan(const Fit& fit, const Hypothesis& otherwise,
                                    std::vector<TourFinding>& found) const {
    constexpr int kMost = 30;  // of a hundred rays
    constexpr double kTimes = 1.04;
    constexpr double kMore = 0.02;
    if (fan_.count < 2) return false;
    BestFit best{closely()};
    for (int lost = 2; lost <= kMost; ++lost) {
        for (const double end : {-0.5, 0.5}) {
            Hypothesis other = closely();
            other.fan_scale = 1.0 - lost / 100.0;
            other.fan_middle_rad = middle_of(fan_);
            other.turn_rad = end * (fan_.max_angle_rad - fan_.min_angle_rad) * lost / 100.0;
            best.try_out(fit, other);
        }
    }
    const double told = fit(closely());
    const auto beaten_by = [&](double rival) { return best.agreement < kTimes * rival + kMore; };
    if (best.agreement < kLeastTold || beaten_by(told) || beaten_by(fit(closely(otherwise))) ||
        beaten_by(best_slight_fan(fit, fan_).agreement)) {
        return false;
    }
    const BestFit longer = best_range_offset(fit, closely(), kOffsetStep, kOffsetSteps);
    if (!beats_rivals(fit, best, longer)) return false;
    tell_fan(fit, told, best, found);
    return true;
}

BestFit best_range_offset(const Fit& fit, const Hypothesis& as, double step_m, int steps) {
    BestFit best{as};
    for (int i = -steps; i <= steps; ++i) {
        Hypothesis other = as;
        other.range_offset_m = i * step_m;
        best.try_out(fit, other);
    }
    return best;
}

/// Whether all ranges are too long or too short by the same: then walls are bent, and in a corner
/// none meets the other.
bool TourExamination::doubt_range_offset(const Fit& fit, const BestFit& longer,
                                         std::vector<TourFinding>& found) const {
    constexpr double kLeast = 0.075;
    const BestFit near = best_range_offset(fit, closely(), kOffsetStep, kOffsetSteps);
    const BestFit far = exact_range_offset(fit, longer.hypothesis);
    const BestFit& best = far.agreement > near.agreement ? far : near;
    if (std::abs(best.hypothesis.range_offset_m) < kLeast ||
        best.agreement < std::max(kLeastFit, fit(closely()) + kClearly)) {
        return false;
    }
    if (!beats_rivals(fit, best, best_slight_fan(fit, fan_))) return false;
    tell_range_offset(fit, best, found);
    return true;
}

void TourExamination::tell_range_offset(const Fit& fit, const BestFit& longer,
                                        std::vector<TourFinding>& found) const {
    constexpr double kAround = 0.05;
    constexpr int kAroundSteps = 10;
    const BestFit best = exact_range_offset(fit, longer.hypothesis);
    const double offset_m =
        best.hypothesis.range_offset_m + middle_offset(fit, kAround, kAroundSteps, [&](double off) {
            Hypothesis other = best.hypothesis;
            other.range_offset_m += off;
            return other;
        });
    found.push_back(
        {Kind::laser_units,
         offset_m,
         message(HITOS_TEXT("Errors",
                            "the scans fit the odometry where %1 m are added to every reading (%2 "
                            "% of their points closely, against %3 %): walls are bent"),
                 fmt::format("{:.2f}", offset_m), percent(best.agreement), percent(fit(closely()))),
         {{say_so(), WholeValues(read_).range_offset(offset_m)}}});
}

/// Rays without a reading between those that have some.
void TourExamination::doubt_lost_rays(std::vector<TourFinding>& found) const {
    constexpr double kNever = 0.01;
    constexpr std::size_t kLeastScans = 20;
    constexpr std::size_t kOneIn = 8;  // of the rays such a gap
    if (scans_ < kLeastScans) return;
    std::size_t lost = 0;
    std::size_t gaps = 0;
    bool open = false;  // behind a ray that sees
    bool gap = false;
    for (const std::uint32_t count : seen_rays_) {
        const bool sees = static_cast<double>(count) > kNever * static_cast<double>(scans_);
        if (!sees) ++lost;
        if (sees && open && gap) ++gaps;
        gap = !sees;
        open = open || sees;
    }
    if (gaps * kOneIn < seen_rays_.size() || seen_rays_.size() < kLeastScans) return;
    found.push_back(
        {Kind::blind_laser,
         static_cast<double>(lost) / static_cast<double>(seen_rays_.size()),
         message(HITOS_TEXT("Errors",
                            "%1 of %2 rays never have a reading, each between others that have: "
                            "no two points are neighbours, and walls fall to pieces"),
                 lost, seen_rays_.size()),
         {{marked(HITOS_TEXT("Errors",
                             "let the driver tell those rays only that it measures, with the step "
                             "between these (angle_increment)"))}}});
}

/// What a driver says where it saw nothing.
std::optional<GreatestRanges::Code> TourExamination::code_taken_for_walls() const {
    constexpr double kLeastShare = 0.002;
    constexpr double kShortest = 1.0;  // [m]
    constexpr double kAlike = 0.7;
    constexpr double kBeyond = 0.5;
    std::optional<GreatestRanges::Code> code = greatest_.code();
    if (!code) code = greatest_.codes_of_rays();
    if (!code || share_of_points(*code) < kLeastShare) return std::nullopt;
    // No laser's reach is so short, nor so unlike from ray to ray: it is the robot, or the ground;
    // and what lies beyond would be left out with it.
    if (code->least_m < kShortest || code->least_m < kAlike * code->range_m ||
        static_cast<double>(greatest_.beyond(code->range_m)) >
            kBeyond * static_cast<double>(code->times)) {
        return std::nullopt;
    }
    return code;
}

double TourExamination::share_of_points(const GreatestRanges::Code& code) const {
    return static_cast<double>(code.times) / static_cast<double>(sampled_);
}

/// At it the map would have an arc of walls that goes with the robot.
std::optional<TourFinding> TourExamination::taken_for_walls() const {
    constexpr double kParts = 100.0;  // of a metre
    const std::optional<GreatestRanges::Code> code = code_taken_for_walls();
    if (!code) return std::nullopt;
    const double share = share_of_points(*code);
    const bool of_rays = !greatest_.code();
    return TourFinding{
        Kind::no_return,
        code->range_m,
        of_rays
            ? message(HITOS_TEXT("Errors",
                                 "%1 % of the readings are the greatest of their ray, %2 to %3 "
                                 "m, which it has over and over, as where a driver says that "
                                 "nothing was seen: they are taken for walls, which go with "
                                 "the robot"),
                      fmt::format("{:.1f}", 100.0 * share), fmt::format("{:.4g}", code->least_m),
                      fmt::format("{:.4g}", code->range_m))
            : message(HITOS_TEXT(
                          "Errors",
                          "%1 % of the readings are %2 m, the greatest of all and three times as "
                          "many as of any distance near it, as where a driver says that nothing "
                          "was seen: they are taken for walls, which go with the robot"),
                      fmt::format("{:.1f}", 100.0 * share), fmt::format("{:.4g}", code->range_m)),
        {{marked(HITOS_TEXT("Errors", "leave them out")),
          set("source.max_range",
              fmt::format("{:.6g}", (std::ceil(code->least_m * kParts) - 1.0) / kParts))}}};
}

/// Whether rays were moved by times that are said and are not theirs.
bool TourExamination::doubt_ray_times(std::vector<TourFinding>& found) const {
    constexpr double kShortest = 0.01;  // [s]
    constexpr double kMore = 0.04;
    constexpr std::size_t kLeastPairs = 10;
    const double sweep_s = static_cast<double>(last_ray_s_) - static_cast<double>(first_ray_s_);
    const Turning turning = turning_pairs();
    if (std::abs(sweep_s) < kShortest || turning.pairs.size() < kLeastPairs) return false;
    const Fit fit(*this, turning.pairs);
    const double told = fit(closely());
    Hypothesis unmoved = closely();
    unmoved.first_ray_s = -static_cast<double>(first_ray_s_);
    unmoved.last_ray_s = -static_cast<double>(last_ray_s_);
    const double fits = fit(unmoved);
    if (fits < std::max(kLeastTold, told + kMore)) return false;
    found.push_back(
        {Kind::ray_times,
         std::abs(sweep_s),
         message(HITOS_TEXT("Errors",
                            "a scan's rays are taken to need %1 s, and where the robot turns they "
                            "fit as if measured at one time (%2 % of their points closely, against "
                            "%3 %): walls are bent there"),
                 fmt::format("{:.3g}", std::abs(sweep_s)), percent(fits), percent(told)),
         {{say_so(), set(kRayTimeKey, kOneTime)}}});
    return true;
}

/// Of a sweep that is said to take too long, which was not believed: how long it takes by the
/// scans.
void TourExamination::tell_ray_times(TourFinding& told) const {
    constexpr double kMore = 0.02;
    constexpr std::size_t kLeastPairs = 10;
    const Turning turning = turning_pairs();
    if (scans_ < 2 || fan_.count < 2 || turning.pairs.size() < kLeastPairs) return;
    const double span = std::abs(fan_.max_angle_rad - fan_.min_angle_rad);
    const double period_s = (last_scan_s_ - first_scan_s_) / static_cast<double>(scans_ - 1);
    const double sweep_s = period_s * span / (2.0 * kPi);  // of a turn from scan to scan
    const auto fit = [&](double last_ray_s) {
        Hypothesis other = closely();
        other.last_ray_s = last_ray_s;
        return agreement(turning.pairs, other).value_or(0.0);
    };
    const double at_once = fit(0.0);
    const double forward = fit(sweep_s);
    const double backward = fit(-sweep_s);
    const double other = std::max(forward, backward);
    if (at_once > other + kMore) {
        told.remedies = {{marked(HITOS_TEXT("Errors", "so they are by the odometry; say so")),
                          set(kRayTimeKey, kOneTime)}};
    } else if (other > at_once + kMore) {
        told.remedies = {
            {marked(HITOS_TEXT("Errors", "by the odometry they take a turn from scan to scan")),
             set(kRayTimeKey, ray_time_of(forward > backward ? sweep_s : -sweep_s, fan_))}};
    }
}

}  // namespace hitos
