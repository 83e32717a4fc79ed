// SPDX-License-Identifier: GPL-3.0-or-later
// What TourExamination finds to doubt in what it has noted.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "hitos/capture/tour_examination.hpp"
#include "hypothesis_search.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;

// Of rays that end at one distance.
constexpr std::uint64_t kLeastTurns = 10;
constexpr double kAlways = 0.9;

constexpr std::array<std::string_view, 34> kWords{
    "clocks-apart",      "scan-delay",     "late-stamps",     "ray-times",      "parts-of-a-turn",
    "clock-speed",       "clock-set",      "clock-back",      "broken-stamps",  "coarse-stamps",
    "assumed-mounting",  "two-publishers", "mirrored-laser",  "turned-laser",   "wrong-fan",
    "misplaced-laser",   "no-odometry",    "unread-odometry", "still-odometry", "leaping-odometry",
    "sideways-odometry", "odometry-scale", "odometry-turns",  "odometry-units", "laser-units",
    "beyond-a-turn",     "blind-laser",    "foreign-scans",   "no-return",      "self-hits",
    "stuck-rays",        "frozen-laser",   "unfit-odometry",  "unsure-drawing"};

}  // namespace

std::string_view word_of(Kind kind) {
    return kWords.at(static_cast<std::size_t>(kind));
}

void TourExamination::doubt_readings(std::vector<TourFinding>& found) const {
    if (scans_ == 0) return;
    const double empty = static_cast<double>(empty_scans_) / static_cast<double>(scans_);
    constexpr double kMostEmpty = 0.9;
    if (empty > kMostEmpty) {
        found.push_back(
            {Kind::blind_laser,
             empty,
             message(
                 HITOS_TEXT(
                     "Errors",
                     "%1 of %2 scans have no reading that can be used, so there is nothing to map"),
                 empty_scans_, scans_),
             {{fan_.count == 0
                   ? marked(HITOS_TEXT(
                         "Errors", "its scans are points and hold none; look at what wrote them"))
                   : marked(HITOS_TEXT(
                         "Errors",
                         "look whether the range limits of the recording are swapped or tiny, or "
                         "its readings not in metres; source.max_range sets the greatest "
                         "range"))}}});
    }
    doubt_units(found);
    const double turn = std::abs(fan_.max_angle_rad - fan_.min_angle_rad);
    const double rays = static_cast<double>(fan_.count) - 1.0;
    constexpr double kRounding = 0.9 * kRadiansPerDegree;
    constexpr double kSteps = 0.75;  // a closed fan has half of one
    if (fan_.count > 1 &&
        turn > 2.0 * kPi + std::max(kRounding, kSteps * std::abs(fan_.step_rad()))) {
        found.push_back(
            {Kind::beyond_a_turn,
             turn,
             message(HITOS_TEXT("Errors",
                                "the rays of a scan go over %1 degrees, more than a whole turn; "
                                "they lie upon each other in the map"),
                     fmt::format("{:.0f}", turn * kDegreesPerRadian)),
             {{marked(HITOS_TEXT("Errors",
                                 "all of them are taken; let the driver say the step between rays "
                                 "that the laser makes (angle_increment); if it turns all round")),
               WholeValues(read_).fan_scale(2.0 * kPi * rays / ((rays + 1.0) * turn))}}});
    }
}

void TourExamination::doubt_odometry(std::vector<TourFinding>& found) const {
    if (readings_ == 0) {
        if (scans_ < 2) return;
        found.push_back(
            {Kind::no_odometry,
             static_cast<double>(scans_),
             marked(HITOS_TEXT("Errors",
                               "there is no odometry, so that all scans are put on one place")),
             {{marked(HITOS_TEXT("Errors",
                                 "record it too: of ROS the topic of the odometry, or /tf together "
                                 "with /tf_static"))}}});
        return;
    }
    if (leaps_ > 0 && std::ranges::count(found, Kind::odometry_units, &TourFinding::kind) == 0) {
        found.push_back(
            {Kind::leaping_odometry,
             longest_step_m_,
             message(HITOS_TEXT("Errors",
                                "the odometry leaps, by up to %1 m (line %2) and %3 in all, as "
                                "where a driver begins anew; the map falls in pieces there"),
                     fmt::format("{:.1f}", longest_step_m_), longest_step_line_, leaps_),
             {map_with_registration()}});
    }
    if (way_m_ > 0.0 || turned_rad_ > 0.0) return;
    const std::optional<double> still = agreement({});
    constexpr double kStandsStill = 0.8;
    if (!still || *still > kStandsStill) return;
    found.push_back(
        {Kind::still_odometry,
         0.0,
         marked(HITOS_TEXT("Errors",
                           "the scans change and the odometry says that the robot never moved; all "
                           "scans are put on one place")),
         {take_it_from_scans()}});
}

/// Times that do not tell one scan from the next.
void TourExamination::doubt_stamps(std::vector<TourFinding>& found) const {
    constexpr double kMostOfOneTime = 0.2;
    const auto scans = static_cast<double>(scans_ + scans_of_one_time_);
    if (static_cast<double>(scans_of_one_time_) > kMostOfOneTime * scans) {
        found.push_back(
            {Kind::coarse_stamps,
             static_cast<double>(scans_of_one_time_) / scans,
             message(
                 HITOS_TEXT("Errors",
                            "%1 of %2 scans have the time of the one before: their stamps have too "
                            "few digits, and how the robot moved between them is not known"),
                 scans_of_one_time_, scans_ + scans_of_one_time_),
             {{marked(
                 HITOS_TEXT("Errors", "record times with milliseconds, as numbers of 64 bits"))}}});
        return;
    }
    const auto readings = static_cast<double>(readings_);
    if (static_cast<double>(of_no_time_) > kMostOfOneTime * readings &&
        way_in_no_time_m_ > kMostOfOneTime * way_m_) {
        found.push_back(
            {Kind::coarse_stamps,
             static_cast<double>(of_no_time_) / readings,
             message(HITOS_TEXT(
                         "Errors",
                         "%1 of %2 odometry readings are stamped no later than the one before: too "
                         "coarsely, or by two clocks; how fast the robot moved is not known"),
                     of_no_time_, readings_),
             {{marked(HITOS_TEXT("Errors", "record times of one clock with milliseconds"))},
              take_it_from_scans()}});
    }
}

/// Rays that end on the robot.
void TourExamination::doubt_self_hits(std::vector<TourFinding>& found) const {
    std::uint64_t own = 0;
    float farthest = 0.0F;
    for (const Direction& direction : directions_) {
        if (direction.near <= kAlways * static_cast<double>(turns_)) continue;
        ++own;
        farthest = std::max(farthest, direction.near_m);
    }
    // Of most of them it is another thing.
    if (turns_ < kLeastTurns || own == 0 || 2 * own >= fan_.count) return;
    constexpr double kBeyond = 0.05;
    const double least = std::ceil((static_cast<double>(farthest) + kBeyond) * 20.0) / 20.0;
    found.push_back(
        {Kind::self_hits,
         static_cast<double>(own),
         message(HITOS_TEXT("Errors",
                            "%1 rays always end at the same distance, however the robot turns: "
                            "on the robot itself; they draw its path as walls"),
                 own),
         {{marked(HITOS_TEXT("Errors", "leave out what is so near")),
           set("source.min_range", fmt::format("{:.2f}", least))}}});
}

/// Rays that read one number wherever the laser looks, which is none that says that they saw
/// nothing.
void TourExamination::doubt_stuck_rays(std::vector<TourFinding>& found) const {
    constexpr std::uint64_t kFew = 3;  // of some lasers one or two at the fan's ends are always so
    const std::optional<GreatestRanges::Code> unseen = code_taken_for_walls();
    std::uint64_t stuck = 0;
    float nearest = 0.0F;
    for (const Direction& direction : directions_) {
        if (direction.stuck <= kAlways * static_cast<double>(turns_)) continue;
        constexpr double kRounding = 1e-3;
        if (unseen && static_cast<double>(direction.far_m) > unseen->least_m - kRounding) continue;
        nearest = stuck == 0 ? direction.far_m : std::min(nearest, direction.far_m);
        ++stuck;
    }
    if (turns_ < kLeastTurns || stuck < kFew || 2 * stuck >= fan_.count) return;
    found.push_back(
        {Kind::stuck_rays,
         static_cast<double>(stuck),
         message(
             HITOS_TEXT("Errors",
                        "%1 rays read the same distance all the time, %2 m and more, however the "
                        "robot turns: they are stuck, and draw walls that are not there"),
             stuck, fmt::format("{:.2f}", nearest)),
         {{marked(HITOS_TEXT("Errors",
                             "leave these rays out of the log, or record it with a laser that is "
                             "whole"))}}});
}

/// A robot that drives sideways.
void TourExamination::doubt_heading(std::vector<TourFinding>& found) const {
    constexpr double kLeastWay = 3.0;
    constexpr double kOneDirection = 0.9;
    constexpr double kOff = 20.0 * kRadiansPerDegree;
    double off_rad = std::atan2(across_m_, along_m_) / 2.0;
    if (way_m_ > kLeastWay && std::hypot(along_m_, across_m_) > kOneDirection * way_m_ &&
        std::abs(off_rad) > kOff) {
        // Which end is ahead, the scans say.
        for (const TourFinding& turned : found) {
            if (turned.kind == Kind::turned_laser && std::cos(turned.value - off_rad) < 0.0) {
                off_rad = wrap_angle(off_rad + kPi);
            }
        }
        const double whole = std::round(off_rad * kDegreesPerRadian) * kRadiansPerDegree;
        const Pose turned = compose({0.0, 0.0, whole}, fan_.pose_robot_laser);
        found.push_back(
            {Kind::sideways_odometry,
             off_rad,
             message(
                 HITOS_TEXT("Errors",
                            "by the odometry the robot always drives %1 degrees off where it "
                            "looks, which no robot on wheels does: its headings are off by that"),
                 std::lround(off_rad * kDegreesPerRadian)),
             {{marked(HITOS_TEXT("Errors", "turn its headings back")),
               WholeValues(read_).axes(OdometryAxes(
                   fmt::format("x,y,theta{:+}", std::lround(off_rad * kDegreesPerRadian))))},
              {marked(HITOS_TEXT("Errors", "or, where the scans are to be turned with it")),
               laser_at({turned, fan_.upside_down})}}});
    }
}

std::vector<TourFinding> TourExamination::findings(std::vector<TourFinding> told) const {
    if (!next_.empty()) return next_.front().findings(std::move(told));
    const auto holds = [](const std::vector<TourFinding>& all, Kind kind) {
        return std::ranges::count(all, kind, &TourFinding::kind) > 0;
    };
    std::vector<TourFinding> own;
    doubt_readings(own);
    doubt_stamps(own);
    doubt_speed(own);
    doubt_place(own);
    if (own.empty()) doubt_foreign_scans(own);
    if (own.empty()) doubt_coarse_readings(own);
    const bool sees = !holds(told, Kind::laser_units) && !holds(told, Kind::blind_laser);
    // Axes and units that the reader doubts explain what else does not fit.
    const bool of_axes = holds(told, Kind::sideways_odometry) || holds(told, Kind::odometry_units);
    std::vector<TourFinding> hung;
    doubt_same_scans(hung);
    constexpr double kAll = 0.9;  // then no clock explains it
    const bool hangs = !hung.empty() && hung.front().value > kAll;
    const bool asked = own.empty() && sees && !of_axes && !hangs;
    if (asked) doubt_fit(own);
    // By another clock the robot may have stood where scans seem to hang.
    const auto of_clocks = [](const TourFinding& finding) {
        return finding.kind == Kind::scan_delay || finding.kind == Kind::clock_set ||
               finding.kind == Kind::clocks_apart || finding.kind == Kind::clock_speed;
    };
    if (!asked || std::ranges::none_of(own, of_clocks)) {
        if (asked && !hung.empty()) own.clear();
        std::ranges::move(hung, std::back_inserter(own));
    }
    doubt_odometry(own);
    if (own.empty() && sees) doubt_stills(own);
    doubt_lost_rays(own);
    if (!holds(own, Kind::laser_units) && !hangs) {
        doubt_self_hits(own);
        doubt_stuck_rays(own);
    }
    if (!of_axes) doubt_heading(own);
    for (TourFinding& finding : told) {
        if (finding.kind == Kind::sideways_odometry) settle_axes(finding);
    }
    if (holds(own, Kind::clock_set))  // of the scans alone, and with a remedy
        std::erase_if(told, [](const auto& finding) { return finding.kind == Kind::clock_back; });
    if (holds(told, Kind::clock_back)) {
        // Where a log is two, what odometry and scans say of each other is of neither.
        const auto of_both = [](const TourFinding& finding) {
            return finding.kind == Kind::coarse_stamps || finding.kind == Kind::leaping_odometry;
        };
        std::erase_if(own, of_both);
        std::erase_if(told, of_both);
    }
    if (own.empty() && told.empty()) doubt_slip(own);
    if (own.empty() && told.empty()) doubt_whole(own);
    if (own.empty() && told.empty()) doubt_motion(own);
    std::erase_if(told, [&](const TourFinding& finding) {
        return finding.kind == Kind::late_stamps && prefers_stamps(finding, own);
    });
    for (TourFinding& finding : told) {
        if (finding.kind == Kind::ray_times) tell_ray_times(finding);
    }
    if (holds(told, Kind::late_stamps)) {
        std::erase_if(own, [](const TourFinding& finding) {
            return finding.kind == Kind::scan_delay || finding.kind == Kind::clocks_apart;
        });
    }
    // A heading that is off turns the scans too.
    const auto sideways = [by = own](double turn_rad) {
        constexpr double kSame = 0.2;  // [rad]
        return std::ranges::any_of(by, [turn_rad](const TourFinding& finding) {
            return finding.kind == Kind::sideways_odometry &&
                   std::abs(wrap_angle(finding.value - turn_rad)) < kSame;
        });
    };
    std::erase_if(own, [&](const TourFinding& finding) {
        return holds(told, finding.kind) ||
               (finding.kind == Kind::turned_laser && sideways(finding.value)) ||
               (finding.kind == Kind::blind_laser && holds(told, Kind::laser_units));
    });
    // What the reader told of leaps does not hold for these.
    if (own.empty()) doubt_pauses(own);
    const bool metres = !holds(own, Kind::laser_units) && !holds(told, Kind::laser_units);
    if (std::optional<TourFinding> unseen = metres ? taken_for_walls() : std::nullopt) {
        // What goes with the robot says nothing of how far it drives; of clocks it hides nothing.
        std::erase_if(own, [](const TourFinding& finding) {
            return finding.kind == Kind::unfit_odometry || finding.kind == Kind::misplaced_laser ||
                   finding.kind == Kind::odometry_scale || finding.kind == Kind::odometry_turns;
        });
        own.push_back(*std::move(unseen));
    }
    std::ranges::move(own, std::back_inserter(told));
    settle_scans(told);
    std::ranges::stable_sort(told, {}, &TourFinding::kind);
    return told;
}

}  // namespace hitos
