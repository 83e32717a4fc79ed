// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a tour's readings and positions are metres, by each other.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hitos/base/median.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "hypothesis_search.hpp"
#include "laser_units.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

/// As kWayShown, where no laser is as the readings say: slow robots show little.
constexpr double kWayShownOfNone = 0.03;

}  // namespace

/// Metres that are read as if they were less.
void TourExamination::doubt_small_unit(double typical, std::vector<TourFinding>& found) const {
    constexpr double kNear = 0.05;  // nearer than any laser of this kind sees half of its readings
    if (typical >= kNear) return;
    double times = 0.0;
    double shown = std::max(0.0, way_shown(1.0)) + kWayShownOfNone;
    for (const LengthUnit& unit : kLengthUnits) {
        const double found_so = way_shown(1.0 / unit.metres);
        if (found_so <= shown) continue;
        shown = found_so;
        times = 1.0 / unit.metres;
    }
    if (times == 0.0) return;
    found.push_back(
        {Kind::laser_units,
         typical,
         message(HITOS_TEXT("Errors",
                            "half of the readings are nearer than %1 m, and by the odometry they "
                            "are %2 times as long; the map is that many times too small"),
                 fmt::format("{:.2g}", typical), fmt::format("{:.4g}", times)),
         {{marked(HITOS_TEXT("Errors", "read them as such")),
           WholeValues(read_).range_scale(times)}}});
}

/// Ranges that are no metres.
void TourExamination::doubt_units(std::vector<TourFinding>& found) const {
    constexpr double kFar = 30.0;
    constexpr double kHardly = 100.0;  // of what a laser sees
    constexpr double kFarthest = 200.0;
    if (medians_.empty()) return;
    const auto typical = static_cast<double>(median(medians_));
    doubt_small_unit(typical, found);
    if (typical < kFar) return;
    const LengthUnit* unit = nullptr;
    double shown =
        std::max(0.0, way_shown(1.0)) + (typical > kHardly ? kWayShownOfNone : kWayShown);
    const auto try_units = [&](double fan_scale) {
        for (const LengthUnit& other : kLengthUnits) {
            const double found_so = way_shown(other.metres, fan_scale);
            if (found_so <= shown) continue;
            shown = found_so;
            unit = &other;
        }
    };
    try_units(1.0);
    // Where scans lie far from each other few of their points lie close, by the right unit too.
    if (unit == nullptr) {
        constexpr double kLeastFar = 0.12;
        constexpr double kStandsOut = 0.03;
        double most = std::max(0.0, way_shown(1.0, 1.0, kLeastFar)) + kStandsOut;
        for (const LengthUnit& other : kLengthUnits) {
            const double found_so = way_shown(other.metres, 1.0, kLeastFar);
            if (found_so <= most) continue;
            most = found_so;
            unit = &other;
        }
    }
    // Of another fan besides, which is told once the readings are metres.
    constexpr int kFans = 10;
    constexpr double kFanStep = 0.05;
    if (unit == nullptr) {
        for (int i = -kFans; i <= kFans; ++i) try_units(1.0 + i * kFanStep);
    }
    if (unit != nullptr) {
        found.push_back(
            {Kind::laser_units,
             typical,
             message(HITOS_TEXT("Errors",
                                "half of the readings are beyond %1 m, and by the odometry they "
                                "are %2; the map is that many times too large"),
                     fmt::format("{:.0f}", typical), marked(unit->name)),
             {{marked(HITOS_TEXT("Errors", "read them as such")),
               WholeValues(read_).range_scale(unit->metres)}}});
    } else if (typical > kFarthest) {
        found.push_back({Kind::laser_units, typical,
                         message(HITOS_TEXT("Errors",
                                            "half of the readings are beyond %1 m, which no such "
                                            "laser sees; the map is that many times too large"),
                                 fmt::format("{:.0f}", typical)),
                         millimetres_or_centimetres(read_)});
    }
}

const LengthUnit* TourExamination::way_unit() const {
    constexpr double kNoRobot = 20.0;
    constexpr double kMillimetres = 120.0;  // hardly a robot drives slower than 0.12 m/s all along
    const auto speed = static_cast<double>(median(speeds_));
    if (!(speed > kNoRobot)) return nullptr;
    return speed > kMillimetres ? &kMillimetre : &kCentimetre;
}

/// Whether all of it is too fast.
void TourExamination::doubt_speed(std::vector<TourFinding>& found) const {
    const LengthUnit* unit = way_unit();
    if (unit == nullptr) return;
    const auto speed = static_cast<double>(median(speeds_));
    Message what = message(HITOS_TEXT("Errors",
                                      "by the odometry the robot mostly drives at %1 m/s, which "
                                      "none of its kind does"),
                           fmt::format("{:.0f}", speed));
    const double metres = agreement(Hypothesis{}).value_or(0.0);
    // Where readings are as large as that both are of one unit, and fit each other.
    constexpr double kFar = 30.0;
    const auto typical = medians_.empty() ? 0.0 : static_cast<double>(median(medians_));
    if (typical > kFar && metres + kClearly > agreement({.scale = unit->metres}).value_or(0.0)) {
        std::erase_if(found, [](const auto& of) { return of.kind == Kind::laser_units; });
        found.push_back({Kind::odometry_units,
                         speed,
                         message(HITOS_TEXT("Errors",
                                            "by the odometry the robot mostly drives at %1 m/s, "
                                            "which none of its kind does, and half of the readings "
                                            "are beyond %2 m: both are no metres"),
                                 fmt::format("{:.0f}", speed), fmt::format("{:.0f}", typical)),
                         {{message(HITOS_TEXT("Errors", "if they are %1"), marked(unit->name)),
                           WholeValues(read_).odometry_scale(unit->metres) +
                               WholeValues(read_).range_scale(unit->metres)}}});
        return;
    }
    // What the scans fit as it is told are metres, and no other time is as long.
    if (metres > kLeastFit &&
        metres > agreement({.scale = unit->metres}).value_or(0.0) + kClearly) {
        found.push_back({Kind::coarse_stamps,
                         speed,
                         std::move(what),
                         {{marked(HITOS_TEXT("Errors",
                                             "its positions fit the scans, so that its times are "
                                             "no seconds: record them in seconds"))}}});
        return;
    }
    found.push_back({Kind::odometry_units,
                     speed,
                     std::move(what),
                     {{message(HITOS_TEXT("Errors", "if its positions are %1"), marked(unit->name)),
                       WholeValues(read_).odometry_scale(unit->metres)}}});
}

}  // namespace hitos
