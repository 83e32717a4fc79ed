// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/odometry_steps.hpp"

#include <algorithm>
#include <cmath>

#include "remedies.hpp"

namespace hitos {
namespace {

double way_of(const Pose& step) {
    return std::hypot(step.x, step.y);
}

/// Where a driver begins anew: at zero, or at what is driven since then.
bool begins_anew(const Pose& pose, double way, double seconds) {
    constexpr double kBegun = 0.3;  // [m], [rad]
    constexpr double kSpeed = 3.0;
    return pose == Pose{} || (std::hypot(pose.x, pose.y) < kBegun &&
                              std::abs(wrap_angle(pose.theta)) < kBegun && way > kSpeed * seconds);
}

/// Whether no robot makes that step to `pose` in that time. Less than 0: by a clock that was set
/// back, of which it says nothing, or, where that is little, by readings that are out of order.
bool is_leap(const Pose& step, const Pose& pose, double seconds) {
    constexpr double kLeap = 0.5;          // [m]
    constexpr double kLeapInNoTime = 1.0;  // stamps of whole seconds stand still meanwhile
    constexpr double kGreatestSpeed = 15;  // [m/s], of the fastest robots of this kind
    constexpr double kTurn = 0.5;          // [rad]
    constexpr double kTurnInNoTime = 1.0;
    constexpr double kGreatestTurn = 6.0;  // [rad/s]
    constexpr double kLatest = 2.0;        // [s], out of order
    constexpr double kSpeedBack = 5.0;     // [m/s]
    const bool late = seconds < 0.0 && seconds >= -kLatest;
    const double time_s = late ? -seconds : std::max(0.0, seconds);
    const double way = way_of(step);
    const double turn = std::abs(wrap_angle(step.theta));
    return (way > (time_s > 0.0 ? kLeap : kLeapInNoTime) &&
            ((!late && begins_anew(pose, way, time_s)) ||
             way > (late ? kSpeedBack : kGreatestSpeed) * time_s)) ||
           (turn > (time_s > 0.0 ? kTurn : kTurnInNoTime) && turn > kGreatestTurn * time_s);
}

/// From one end of a turn to the other in degrees, which no heading in radians does.
bool steps_a_turn_of_degrees(const Pose& before, const Pose& pose) {
    constexpr double kTurn = 360.0;
    constexpr double kOff = 60.0;
    return std::abs(std::abs(pose.theta - before.theta) - kTurn) < kOff &&
           std::max(std::abs(pose.theta), std::abs(before.theta)) <= kTurn;
}

double motion_of(const Twist& twist) {
    return std::hypot(twist.v, twist.v_lateral) + std::abs(twist.w);
}

}  // namespace

void OdometrySteps::Told::note(const Pose& step, std::uint64_t at_line) {
    const double way = way_of(step);
    const double turn = std::abs(wrap_angle(step.theta));
    if (++count > 1 && way + turn <= longest_m + turn_rad) return;
    longest_m = way;
    turn_rad = turn;
    line = at_line;
}

void OdometrySteps::Turns::note(double told_rad, double other_rad) {
    constexpr double kLeast = 0.3;
    constexpr double kMost = 2.5;
    constexpr double kOff = 0.25;
    const double expected = kDegreesPerRadian * other_rad;
    if (std::abs(expected) < kLeast || std::abs(expected) > kMost) return;
    ++asked;
    const auto is = [&](double turn) {
        return std::abs(wrap_angle(told_rad - turn)) < kOff * std::abs(expected);
    };
    if (is(expected)) ++of_degrees;
    if (is(-expected)) ++reversed;
}

bool OdometrySteps::Turns::are_degrees() const {
    constexpr std::uint64_t kLeast = 20;
    return asked >= kLeast && 2 * most() > asked;
}

/// Degrees that were turned into a quaternion are wrapped to one turn in radians, and step by
/// nothing that looks like a heading.
void OdometrySteps::note_turn(const OdometryRecord& before, const OdometryRecord& record) {
    const Pose& from = *before.pose_odom_robot;
    const Pose& to = *record.pose_odom_robot;
    const Pose step{to.x - from.x, to.y - from.y, wrap_angle(to.theta - from.theta)};
    if (record.velocity) {
        by_velocity_.note(step.theta, record.velocity->w * (record.time_s - before.time_s));
    }
    constexpr double kMoves = 5e-3;  // [m]
    if (way_of(step) < kMoves) return;
    if (way_of(last_step_) > 0.0) {
        const double turn =
            wrap_angle(std::atan2(step.y, step.x) - std::atan2(last_step_.y, last_step_.x));
        by_path_.note((step.theta + last_step_.theta) / 2.0, turn);
    }
    last_step_ = step;
}

Pose OdometrySteps::taken(const OdometryRecord& before, const OdometryRecord& record) {
    const double seconds = record.time_s - before.time_s;
    const Pose logged = between(*before.pose_odom_robot, *record.pose_odom_robot);
    tracks_.note({*record.pose_odom_robot});
    positions_.note({{record.pose_odom_robot->x, record.pose_odom_robot->y, 0.0}});
    headings_.note(*record.pose_odom_robot);
    note_turn(before, record);
    if (steps_a_turn_of_degrees(*before.pose_odom_robot, *record.pose_odom_robot)) {
        if (turns_of_degrees_++ == 0) turn_line_ = record.line;
    }
    if (makes_up(record, logged, seconds)) {
        made_up_.note(logged, record.line);
        longest_halt_s_ = std::max(longest_halt_s_, record.time_s - *under_way_.begin_s);
        after_leap_ = false;
        under_way_.begin_s = record.time_s;
        under_way_.still = 0;
        return logged;
    }
    const Pose step = bridged(before, record, seconds);
    learn(before, record, step);
    return step;
}

/// Whether the odometry stopped dead while the robot drove, and this is what it drove meanwhile.
bool OdometrySteps::makes_up(const OdometryRecord& record, const Pose& step, double seconds) const {
    constexpr double kLeast = 0.5;     // [m], [rad]: less is no leap either
    constexpr double kTimes = 3.0;     // so many times the step before; some log one pose of many
    constexpr double kShortest = 0.5;  // [s]
    constexpr double kLongest = 30.0;
    constexpr double kDrives = 0.05;  // [m/s]
    constexpr double kDead = 0.5;     // of the motion before; who brakes comes below that
    constexpr double kRounding = 0.3;
    constexpr double kTurns = 1.0;   // [rad/s], of those that drove straight on before
    constexpr double kPaces = 3.0;   // of readings: who tells few may have stood for one of them,
    constexpr double kDriven = 2.0;  // and driven all of it behind the last, not much faster
    constexpr double kSpeed = 0.5;   // [m/s]
    const UnderWay& known = under_way_;
    if (known.still == 0) return false;
    const double halt_s = record.time_s - *known.begin_s;
    const double speed = std::hypot(known.twist.v, known.twist.v_lateral);
    const double way = way_of(step);
    const double turn = std::abs(wrap_angle(step.theta));
    const double known_turn = std::abs(wrap_angle(known.step.theta));
    const bool seen_still = halt_s - seconds >= kPaces * std::max(seconds, known.seconds);
    const bool too_fast = way > kDriven * std::max(speed, kSpeed) * seconds ||
                          turn > kDriven * std::max(std::abs(known.twist.w), kTurns) * seconds;
    if (!seen_still || !too_fast) return false;
    const bool long_step = (way > kLeast && way > kTimes * way_of(known.step)) ||
                           (turn > kLeast && turn > kTimes * known_turn);
    const bool stopped_dead = motion_of(known.twist) >= std::max(kDrives, kDead * known.before);
    return long_step && stopped_dead && halt_s >= kShortest && halt_s <= kLongest &&
           way <= 2.0 * speed * halt_s + kRounding &&
           turn <= std::max(2.0 * std::abs(known.twist.w), kTurns) * halt_s + kRounding &&
           !begins_anew(*record.pose_odom_robot, way, halt_s);
}

/// Whether a step that would be a leap goes on as the one before it: then it is its stamps that are
/// too near each other, of scans that were held up, and over both times no robot is that fast.
bool OdometrySteps::goes_on(const Pose& step, const Pose& pose, double seconds) const {
    constexpr double kTimes = 3.0;
    constexpr double kMore = 0.1;  // [m], [rad]
    constexpr double kShort = 0.2;
    constexpr double kSpeed = 2.0;  // [m/s], of many robots
    constexpr double kTurns = 2.5;  // [rad/s]
    const UnderWay& known = under_way_;
    const double turn = wrap_angle(step.theta);
    const double known_turn = wrap_angle(known.step.theta);
    const double both_s = known.seconds + seconds;
    const bool one_way = turn * known_turn >= 0.0;
    const bool alike = way_of(step) <= kTimes * way_of(known.step) + kMore &&
                       std::abs(turn) <= kTimes * std::abs(known_turn) + kMore;
    // Of a stamp that stands right behind the one before it, what is usual says more.
    const bool held_up = seconds <= kShort * known.seconds && way_of(step) <= kSpeed * both_s &&
                         std::abs(turn) <= kTurns * both_s;
    return seconds > 0.0 && known.still == 0 && known.seconds > 0.0 && one_way &&
           (alike || held_up) && !is_leap(compose(known.step, step), pose, both_s);
}

Pose OdometrySteps::bridged(const OdometryRecord& before, const OdometryRecord& record,
                            double seconds) {
    constexpr double kGoesOn = 1.0;  // as before: longer, nobody knows
    const Pose& pose = *record.pose_odom_robot;
    const Pose logged = between(*before.pose_odom_robot, pose);
    const bool after_leap = after_leap_;
    after_leap_ = is_leap(logged, pose, seconds) && !goes_on(logged, pose, seconds);
    if (!after_leap_) return logged;
    if (after_leap) {
        // Back from a single wrong pose; or each step is a leap, as in millimetres.
        const Pose back = between(compose(from_, driven_), pose);
        after_leap_ = is_leap(back, back, seconds);
        if (!after_leap_) return back;
        ++in_a_row_;
        return logged;
    }
    leaps_.note(logged, record.line);
    from_ = *before.pose_odom_robot;
    driven_ = displacement(twist_, std::clamp(seconds, 0.0, kGoesOn));
    return driven_;
}

void OdometrySteps::learn(const OdometryRecord& before, const OdometryRecord& record,
                          const Pose& step) {
    // What was driven in no time says nothing of how fast.
    const double seconds = record.time_s - before.time_s;
    if (seconds > 0.0) twist_ = twist_between(step, seconds);
    UnderWay& known = under_way_;
    if (!known.begin_s) known.begin_s = before.time_s;
    if (*before.pose_odom_robot == *record.pose_odom_robot) {
        ++known.still;
        return;
    }
    const double since_s = record.time_s - *known.begin_s;
    known = {record.time_s,          step, since_s > 0.0 ? twist_between(step, since_s) : Twist{},
             motion_of(known.twist), 0,    since_s};
}

void OdometrySteps::tell(std::vector<TourFinding>& found, const ReadOptions& read) const {
    using Kind = TourFinding::Kind;
    // Headings that are none say nothing of steps.
    if (std::ranges::count(found, Kind::odometry_units, &TourFinding::kind) > 0) return;
    const auto tenths = [](double value) { return std::round(value * 10.0) / 10.0; };
    if (std::optional<TourFinding> doubt = headings_.doubt(read)) {
        found.push_back(*std::move(doubt));
        return;
    }
    constexpr std::uint64_t kMoreThanOneMistake = 2;
    if (turns_of_degrees_ >= kMoreThanOneMistake) {
        found.push_back({Kind::odometry_units,
                         kRadiansPerDegree,
                         message(HITOS_TEXT("Errors",
                                            "the odometry's headings go from one end of a turn to "
                                            "the other in steps of 360, %1 times (first in line "
                                            "%2): they are in degrees, and are read as radians"),
                                 turns_of_degrees_, turn_line_),
                         {headings_in_degrees(read)}});
        return;
    }
    const bool velocities_turn = by_velocity_.are_degrees();
    if (velocities_turn || by_path_.are_degrees()) {
        const Turns& by = velocities_turn ? by_velocity_ : by_path_;
        found.push_back(
            {Kind::odometry_units,
             kRadiansPerDegree,
             message(HITOS_TEXT("Errors",
                                "the odometry's headings turn 57 times as far as its %1, in %2 of "
                                "%3 steps: degrees were taken for radians"),
                     velocities_turn ? marked(HITOS_TEXT("Errors", "velocities"))
                                     : marked(HITOS_TEXT("Errors", "way")),
                     by.most(), by.asked),
             {velocities_turn ? take_velocities() : take_it_from_scans()}});
        return;
    }
    const bool told = std::ranges::count(found, Kind::two_publishers, &TourFinding::kind) > 0;
    if (tracks_.returns() > 0) {
        if (told) return;
        if (positions_.returns() == 0) {
            found.push_back(
                {Kind::two_publishers, static_cast<double>(tracks_.returns()),
                 message(HITOS_TEXT("Errors",
                                    "the odometry's headings go to and fro, %1 times, and its "
                                    "positions do not: they are not in radians, or two programs "
                                    "tell them"),
                         tracks_.returns()),
                 by_velocity_.asked > 0
                     ? std::vector<Remedy>{take_velocities(), take_it_from_scans()}
                     : std::vector<Remedy>{take_it_from_scans()}});
            return;
        }
        found.push_back(
            {Kind::two_publishers,
             static_cast<double>(tracks_.returns()),
             message(HITOS_TEXT("Errors",
                                "the odometry goes to and fro between two tracks, %1 times: two "
                                "programs tell it, and the map is of neither"),
                     tracks_.returns()),
             {{marked(HITOS_TEXT("Errors", "record with one of them only"))},
              take_it_from_scans()}});
        return;
    }
    constexpr double kNoWay = 0.05;  // [m]: then only the heading leaps
    if (leaps_.count > in_a_row_) {
        const bool turns = leaps_.longest_m < kNoWay;
        const long degrees = std::lround(leaps_.turn_rad * kDegreesPerRadian);
        found.push_back(
            {Kind::leaping_odometry,
             leaps_.longest_m,
             turns
                 ? message(
                       HITOS_TEXT(
                           "Errors",
                           "the odometry's heading leaps, by up to %1 degrees (line %2) and %3 in "
                           "all; the robot is taken to drive on there as before, for a second"),
                       degrees, leaps_.line, leaps_.count)
                 : message(HITOS_TEXT("Errors",
                                      "the odometry leaps, by up to %1 m (line %2) and %3 in all, "
                                      "as where a driver begins anew; the robot is taken to drive "
                                      "on there as before, for a second"),
                           tenths(leaps_.longest_m), leaps_.line, leaps_.count),
             {map_with_registration()}});
    }
    if (made_up_.count > 0) {
        const bool turns = made_up_.longest_m < kNoWay;
        found.push_back(
            {Kind::leaping_odometry,
             made_up_.longest_m,
             turns
                 ? message(HITOS_TEXT("Errors",
                                      "the odometry stands still while the robot turns, for up to "
                                      "%1 s, and makes up for it in one step, of up to %2 degrees "
                                      "(line %3), %4 in all; scans of that time lie on each other"),
                           tenths(longest_halt_s_),
                           std::lround(made_up_.turn_rad * kDegreesPerRadian), made_up_.line,
                           made_up_.count)
                 : message(HITOS_TEXT("Errors",
                                      "the odometry stands still while the robot drives, for up to "
                                      "%1 s, and makes up for it in one step, of up to %2 m (line "
                                      "%3), %4 in all; scans of that time lie on one place"),
                           tenths(longest_halt_s_), tenths(made_up_.longest_m), made_up_.line,
                           made_up_.count),
             {take_it_from_scans()}});
    }
}

}  // namespace hitos
