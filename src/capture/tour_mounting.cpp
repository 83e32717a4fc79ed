// SPDX-License-Identifier: GPL-3.0-or-later
// How the laser sits on the robot, and in which directions its rays go, by the odometry.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/odometry_axes.hpp"
#include "hypothesis_search.hpp"
#include "laser_units.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

constexpr int kSectors = 36;

/// The turn of the laser, as told plus what is found, in the middle of those that fit as well.
double middle_turn(const Fit& fit, const Hypothesis& found) {
    constexpr int kDegrees = 15;
    const auto at = [&](double offset) {
        Hypothesis near = closely(found);
        near.turn_rad = found.turn_rad + offset;
        return near;
    };
    return wrap_angle(found.turn_rad +
                      middle_offset(fit, kDegrees * kRadiansPerDegree, kDegrees, at));
}

/// With the rays over another angle than is told, about the same middle or, as most are, about
/// where the laser looks.
BestFit best_fan(const Fit& fit, const Fan& fan) {
    constexpr int kFewest = 6;
    constexpr int kMost = 36;
    constexpr double kStep = 10.0 * kRadiansPerDegree;
    constexpr double kFinest = 0.5 * kRadiansPerDegree;
    constexpr double kTheSame = 0.04;  // of the told angle
    BestFit best;
    const double told = fan.max_angle_rad - fan.min_angle_rad;
    if (fan.count < 2 || told == 0.0 || std::abs(told) > 2.0 * kPi + kStep) return best;
    const double middle = wrap_angle(fan.min_angle_rad + told / 2.0);
    const auto try_out = [&](double angle, double turn_rad) {
        const double scale = angle / std::abs(told);
        if (std::abs(scale - 1.0) < kTheSame) return;
        best.try_out(fit, {.turn_rad = turn_rad, .fan_scale = scale, .fan_middle_rad = middle});
    };
    for (int i = kFewest; i <= kMost; ++i) {
        try_out(i * kStep, 0.0);
        if (std::abs(middle) > kFinest) try_out(i * kStep, -middle);
    }
    if (best.agreement == 0.0) return best;
    BestFit near;
    near.try_out(fit, closely(best.hypothesis));
    near = climbed(fit, near, kStep / 2.0, kFinest, [told](const Hypothesis& from, double step) {
        std::array<Hypothesis, 2> others{from, from};
        others[0].fan_scale -= step / std::abs(told);
        others[1].fan_scale += step / std::abs(told);
        return others;
    });
    if (std::abs(near.hypothesis.fan_scale - 1.0) < kTheSame) return {};
    best.hypothesis.fan_scale = near.hypothesis.fan_scale;
    best.agreement = fit(best.hypothesis);
    return best;
}

}  // namespace

BestFit best_mounting(const Fit& fit, const Fan& fan) {
    constexpr double kFanClearly = 0.02;  // better than one that is turned: two numbers are more
    BestFit best;
    for (int i = 0; i < kSectors; ++i) {
        const double turn_rad = wrap_angle(2.0 * kPi * i / kSectors);
        best.try_out(fit, {.turn_rad = turn_rad});
        best.try_out(fit, {.turn_rad = turn_rad, .mirrored = true});
    }
    const BestFit other = best_fan(fit, fan);
    if (other.agreement < best.agreement + kFanClearly) return best;
    // Seen by such a fan, all turns are too long or too short: so may be those of the odometry.
    const Hypothesis turns{.pair_turn_scale = 1.0 / other.hypothesis.fan_scale};
    return fit(closely(other.hypothesis)) > fit(closely(turns)) + kFanClearly ? other : best;
}

/// Whether the laser fits better turned or mirrored, or with rays over another angle.
void TourExamination::doubt_mounting(const Fit& fit, double told, const BestFit& mounted,
                                     std::vector<TourFinding>& found) const {
    if (mounted.agreement < std::max(kLeastFit, told + kClearly) ||
        !beats_standing(mounted.agreement)) {
        return;
    }
    tell_mounting(fit, told, mounted, found);
}

void TourExamination::tell_mounting(const Fit& fit, double told, const BestFit& mounted,
                                    std::vector<TourFinding>& found) const {
    const Hypothesis& other = mounted.hypothesis;
    const long fits = percent(mounted.agreement);
    const auto degrees = [](double rad) { return std::lround(rad * kDegreesPerRadian); };
    if (other.fan_scale != 1.0) {
        tell_fan(fit, told, mounted, found);
        return;
    }
    // What is told of one that is turned alone.
    constexpr double kLeast = 4.5 * kRadiansPerDegree;
    double turn_rad = middle_turn(fit, other);
    if (other.mirrored && std::abs(turn_rad) < kLeast) turn_rad = 0.0;
    Pose pose = fan_.pose_robot_laser;
    // A heading that points elsewhere turns the laser about the robot's middle.
    const Pose about = compose({0.0, 0.0, turn_rad}, pose);
    Hypothesis near = closely(other);
    near.turn_rad = turn_rad;
    const double in_place = fit(near);
    near.shift = {about.x - pose.x, about.y - pose.y};
    const bool heading = !other.mirrored && fit(near) > in_place;
    if (heading) pose = about;
    pose.theta =
        static_cast<double>(degrees(fan_.pose_robot_laser.theta + turn_rad)) * kRadiansPerDegree;
    std::vector<SourceSetting> place = laser_at({pose, fan_.upside_down != other.mirrored});
    if (other.mirrored) {
        found.push_back(
            {Kind::mirrored_laser,
             1.0,
             message(HITOS_TEXT("Errors",
                                "the scans turn against the odometry (%1 % of their points fit "
                                "mirrored, %2 % as they are): one of the two is mirrored, and "
                                "where it is the laser, so is the map"),
                     fits, percent(told)),
             {{marked(HITOS_TEXT(
                   "Errors", "if the laser is upside down, or its rays go the other way round")),
               std::move(place)},
              {marked(HITOS_TEXT("Errors", "if it is the odometry that counts turns to the right")),
               WholeValues(read_).odometry_turns(-1.0)},
              {marked(HITOS_TEXT("Errors",
                                 "with the wrong one of both the map is right but mirrored"))}}});
        return;
    }
    found.push_back(
        {Kind::turned_laser,
         turn_rad,
         message(HITOS_TEXT("Errors",
                            "the scans move %1 degrees off where the odometry drives (%2 % of "
                            "their points fit turned so, %3 % as they are): the map's path and "
                            "walls do not fit each other"),
                 degrees(turn_rad), fits, percent(told)),
         {{heading ? marked(HITOS_TEXT("Errors",
                                       "the odometry's heading points elsewhere than the robot; "
                                       "let the laser turn with it"))
                   : marked(HITOS_TEXT("Errors",
                                       "the laser is mounted otherwise than the recording says")),
           std::move(place)}}});
}

/// Whether the laser is turned by less than sectors tell apart.
bool TourExamination::doubt_slight_turn(const Fit& fit, std::vector<TourFinding>& found) const {
    constexpr int kMost = 15;
    constexpr int kLeast = 4;
    BestFit best{closely()};
    for (int degrees = -kMost; degrees <= kMost; ++degrees) {
        Hypothesis turned = closely();
        turned.turn_rad = degrees * kRadiansPerDegree;
        best.try_out(fit, turned);
    }
    if (std::abs(best.hypothesis.turn_rad) < (kLeast - 0.5) * kRadiansPerDegree) return false;
    Hypothesis driven_nowhere = closely();
    driven_nowhere.scale = 0.0;
    const double told = fit(closely());
    // Where scans lie far from each other few of their points lie close, by the right turn too.
    constexpr double kLeastFar = 0.15;
    constexpr double kTimes = 1.25;
    constexpr double kMore = 0.02;
    const double other = std::max(told, fit(driven_nowhere));
    const bool stands_out = best.agreement >= std::max(kLeastFar, kTimes * other + kMore);
    if (!stands_out && best.agreement < std::max(kLeastFit, other + kClearly)) return false;
    tell_mounting(fit, told, best, found);
    return true;
}

void TourExamination::doubt_place(std::vector<TourFinding>& found) const {
    constexpr double kFarthest = 5.0;  // [m]
    constexpr double kBetter = 0.03;
    const Pose& said = fan_.pose_robot_laser;
    const double off_m = std::hypot(said.x, said.y);
    if (!(off_m > kFarthest)) return;
    constexpr std::size_t kAsked = 128;
    const Fit fit(*this, some_pairs(kAsked));
    const auto placed = [&](double scale) {
        Hypothesis other = closely();
        other.shift = {(scale - 1.0) * said.x, (scale - 1.0) * said.y};
        return other;
    };
    const double told = fit(closely());
    double times = 1.0;
    double best = told + kBetter;
    for (const double scale : {0.001, 0.01, 0.0}) {
        const double fits = fit(placed(scale));
        if (fits <= best) continue;
        best = fits;
        times = scale;
    }
    if (times == 1.0 && told >= kLeastFit) return;  // a large one
    Remedy remedy{marked(HITOS_TEXT("Errors", "say where it sits: --laser-pose"))};
    if (times != 1.0) {
        const Pose meant{times * said.x, times * said.y, said.theta};
        remedy = {marked(HITOS_TEXT("Errors", "so the scans fit the odometry better")),
                  laser_at({meant, fan_.upside_down})};
    }
    found.push_back({Kind::misplaced_laser,
                     off_m,
                     message(HITOS_TEXT("Errors",
                                        "the laser is said to sit %1 m from the robot's middle, "
                                        "farther than a robot is large: walls go round in circles "
                                        "where it turns"),
                             fmt::format("{:.4g}", off_m)),
                     {std::move(remedy)}});
}

/// Whether it is headings or positions that count the other way: by how the scans turn.
void TourExamination::settle_axes(TourFinding& told) const {
    constexpr std::size_t kAsked = 128;
    const Fit fit(*this, some_pairs(kAsked));
    const LengthUnit* unit = way_unit();
    BestFit headings;
    BestFit positions;  // as the other, all of it mirrored: told of a mirrored laser's scans
    for (int i = 0; i < kSectors; ++i) {
        Hypothesis other{.turn_rad = wrap_angle(2.0 * kPi * i / kSectors),
                         .scale = unit == nullptr ? 1.0 : unit->metres,
                         .turn_scale = -1.0};
        headings.try_out(fit, other);
        other.mirrored = true;
        positions.try_out(fit, other);
    }
    if (std::max(headings.agreement, positions.agreement) < kLeastFit) return;
    if (headings.agreement > positions.agreement + kClearly) {
        told.remedies = {reversed_headings(told.value, read_)};
    } else if (positions.agreement > headings.agreement + kClearly) {
        told.remedies = {reversed_positions(told.value, read_)};
    }
}

/// Whether headings are in degrees, or were scaled as if they had been.
bool TourExamination::doubt_turns(const Fit& fit, double told, double otherwise,
                                  std::vector<TourFinding>& found) const {
    constexpr double kMuchBetter = 0.2;
    constexpr double kBetterThanNone = 0.1;
    if (told + kMuchBetter > 1.0) return false;
    const auto best_of = [&](double scale) {
        BestFit best;  // where the first heading points is not known then
        for (int i = 0; i < kSectors; ++i) {
            best.try_out(fit,
                         {.turn_rad = wrap_angle(2.0 * kPi * i / kSectors), .turn_scale = scale});
        }
        return best;
    };
    const BestFit less = best_of(kRadiansPerDegree);
    const BestFit more = best_of(kDegreesPerRadian);
    const BestFit& best = less.agreement > more.agreement ? less : more;
    // Who never turned, and drove now ahead and now aside, fits by chance too.
    if (best.agreement < told + kMuchBetter || best.agreement <= otherwise ||
        !beats_standing(best.agreement) ||
        best.agreement < best_of(0.0).agreement + kBetterThanNone) {
        return false;
    }
    const double scale = best.hypothesis.turn_scale;
    std::vector<Remedy> remedies{take_it_from_scans()};
    const OdometryAxes axes(read_.odometry_axes);
    if (scale < 1.0) {
        remedies.insert(remedies.begin(), headings_in_degrees(read_));
    } else if (axes.in_degrees()) {  // as somebody said, and they are not
        remedies.insert(remedies.begin(),
                        {say_so(), set(kOdometryAxesKey, axes.in_radians().text())});
    }
    found.push_back(
        {Kind::odometry_units, scale,
         message(HITOS_TEXT("Errors",
                            "by the scans the robot turns %1 times as far as by the odometry (%2 % "
                            "of their points fit so, %3 % as it is told): headings are %4"),
                 fmt::format("{:.3g}", scale), percent(best.agreement), percent(told),
                 scale < 1.0
                     ? marked(HITOS_TEXT("Errors", "in degrees"))
                     : marked(HITOS_TEXT("Errors", "taken for degrees and turned into radians"))),
         std::move(remedies)});
    return true;
}

}  // namespace hitos
