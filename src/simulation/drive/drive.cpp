// SPDX-License-Identifier: GPL-3.0-or-later
// The robot's driver: where to turn and how fast to go, without noise and without chance.
#include "drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/driver.hpp"

namespace hitos {
namespace {

/// With the goal this far off the nose or more the robot turns on the spot; below it the speed
/// grows in proportion.
constexpr double kTurnOnTheSpot = kPi / 2.0;
/// Ramps are planned with this part of the acceleration, as velocities change in steps.
constexpr double kReserve = 0.8;
/// A look around ends when less than this is left of the full turn.
constexpr double kTurnDone = 0.02;
/// Longer tours would not fit into memory.
constexpr std::size_t kMostSteps = 10'000'000;

double heading_error(const Pose& pose, const Point2& goal) {
    return wrap_angle(std::atan2(goal.y - pose.y, goal.x - pose.x) - pose.theta);
}

/// The part of the full speed that suits an angle still to be turned.
double speed_part(double angle_rad) {
    return std::max(0.0, 1.0 - std::abs(angle_rad) / kTurnOnTheSpot);
}

/// The turn rate for an angle still to be turned: proportional, so slow that the greatest turn
/// acceleration brakes it without overshoot.
double turn_rate(const RobotParams& robot, double angle_rad) {
    const double gain = kReserve * std::min(robot.turn_acceleration / robot.max_turn_rate,
                                            robot.control_rate_hz / 2.0);
    return std::clamp(gain * angle_rad, -robot.max_turn_rate, robot.max_turn_rate);
}

/// The velocities towards a goal that is `left` away, to pass it with `at_goal` [m/s] at most.
Twist velocities(const RobotParams& robot, const Pose& pose, const Point2& goal, double left,
                 double at_goal) {
    const double error = heading_error(pose, goal);
    const double braking =
        std::sqrt(at_goal * at_goal + 2.0 * kReserve * robot.acceleration *
                                          std::max(0.0, left - 0.5 * robot.tolerance_m));
    return {std::min(robot.max_speed * speed_part(error), braking), 0.0, turn_rate(robot, error)};
}

class Driver {
  public:
    explicit Driver(const World& world)
        : world_(world),
          robot_(world.robot),
          period_s_(1.0 / world.robot.control_rate_hz),
          motion_(world) {}

    RobotMotion drive() {
        check_start();
        check_spacing();
        check_length();
        for (double t = 0.0; t + 0.5 * period_s_ < world_.tour.rest_s; t += period_s_)
            motion_.command(0.0, 0.0);
        if (world_.tour.look_around) look_around();
        if (!world_.tour.commands.empty()) {
            follow_commands();
            return std::move(motion_);
        }
        const std::size_t count = world_.tour.way_points.size();
        const std::size_t goals = count * static_cast<std::size_t>(world_.tour.laps);
        for (goal_ = 0; goal_ < goals; ++goal_) {
            const Point2* next = goal_ + 1 < goals ? &at(goal_ + 1) : nullptr;
            drive_to(at(goal_), next);
        }
        --goal_;  // where it stops, for messages
        while (twist().v != 0.0 || twist().w != 0.0) command(0.0, 0.0);
        return std::move(motion_);
    }

  private:
    const Pose& pose() const { return motion_.pose(); }
    const Twist& twist() const { return motion_.twist(); }
    const WayPoint& way_point(std::size_t goal) const {
        const std::size_t count = world_.tour.way_points.size();
        const std::size_t at = goal % count;
        const bool turned = world_.tour.reverse && at + 1 < count;
        return world_.tour.way_points[turned ? count - 2 - at : at];
    }
    const Point2& at(std::size_t goal) const { return way_point(goal).at; }

    Message name(std::size_t goal) const {
        const std::size_t count = world_.tour.way_points.size();
        const std::size_t number = goal % count + 1;
        const std::string x = fmt::format("{:g}", at(goal).x);
        const std::string y = fmt::format("{:g}", at(goal).y);
        if (world_.tour.laps == 1) {
            return message(HITOS_TEXT("Errors", "way point %1 at (%2, %3)"), number, x, y);
        }
        return message(HITOS_TEXT("Errors", "way point %1 at (%2, %3) of lap %4"), number, x, y,
                       goal / count + 1);
    }

    [[noreturn]] void fail(std::uint64_t line, const Message& problem) const {
        throw FormatError(world_.file, line, problem);
    }

    static Message wall_name(const WallSegment& wall) {
        const auto of = [](double value) { return fmt::format("{:g}", value); };
        const auto& [a, b, number, line] = wall;
        if (number > 0) {
            return message(HITOS_TEXT("Errors", "wall %1, (%2, %3) to (%4, %5)"), number, of(a.x),
                           of(a.y), of(b.x), of(b.y));
        }
        if (number < 0) {
            return message(HITOS_TEXT("Errors",
                                      "closed door %1, (%2, %3) to (%4, %5), which an event { at = "
                                      "0, open = %1 } would open"),
                           -number, of(a.x), of(a.y), of(b.x), of(b.y));
        }
        return message(HITOS_TEXT("Errors", "a side of a box, (%1, %2) to (%3, %4)"), of(a.x),
                       of(a.y), of(b.x), of(b.y));
    }

    Message tree_name(std::size_t tree) const {
        const Point2& at = world_.landmarks.at[tree];
        return message(HITOS_TEXT("Errors", "landmark %1, (%2, %3)"), tree,
                       fmt::format("{:g}", at.x), fmt::format("{:g}", at.y));
    }

    void check_start() const {
        const Point2 start{world_.tour.start.x, world_.tour.start.y};
        const auto check = [&](double gap, const auto& name) {
            if (gap >= robot_.radius_m) return;
            fail(world_.tour.line,
                 message(HITOS_TEXT("Errors",
                                    "the start at (%1, %2) is %3 m from %4; expected at least "
                                    "the robot's radius of %5 m"),
                         fmt::format("{:g}", start.x), fmt::format("{:g}", start.y),
                         fmt::format("{:.3f}", gap), name(), fmt::format("{:g}", robot_.radius_m)));
        };
        for (const WallSegment& wall : motion_.conditions().walls())
            check(distance(wall, start), [&] { return wall_name(wall); });
        for (std::size_t i = 0; i < world_.landmarks.radii_m.size(); ++i) {
            check(distance(world_.landmarks.at[i], start) - world_.landmarks.radii_m[i],
                  [&] { return tree_name(i); });
        }
    }

    /// A way point that is passed before the robot sets out for it is a mistake in the list.
    void check_spacing() const {
        const std::size_t count = world_.tour.way_points.size();
        if (count == 0) return;
        Point2 before{world_.tour.start.x, world_.tour.start.y};
        for (std::size_t goal = 0; goal < count + (world_.tour.laps > 1 ? 1U : 0U); ++goal) {
            const double gap = std::hypot(at(goal).x - before.x, at(goal).y - before.y);
            if (gap <= 2.0 * robot_.tolerance_m) {
                fail(way_point(goal).line,
                     message(HITOS_TEXT("Errors",
                                        "%1 is %2 m from %3; expected more than %4 m, twice the "
                                        "tolerance at which it is passed"),
                             name(goal), fmt::format("{:.3f}", gap),
                             goal == 0 ? message(HITOS_TEXT("Errors", "the start"))
                                       : message(HITOS_TEXT("Errors", "the one before")),
                             fmt::format("{:g}", 2.0 * robot_.tolerance_m)));
            }
            before = at(goal);
        }
    }

    /// What cannot be driven within the limit is told before it is tried.
    void check_length() const {
        const std::size_t count = world_.tour.way_points.size();
        double least_s = world_.tour.rest_s;
        for (const DriveCommand& command : world_.tour.commands) least_s += command.duration_s;
        Point2 before{world_.tour.start.x, world_.tour.start.y};
        for (std::size_t goal = 0; goal < count * static_cast<std::size_t>(world_.tour.laps);
             ++goal) {
            const double way = std::hypot(at(goal).x - before.x, at(goal).y - before.y);
            least_s += std::max(0.0, way - 2.0 * robot_.tolerance_m) / robot_.max_speed;
            if (least_s * robot_.control_rate_hz > kMostSteps) {
                fail(way_point(goal).line,
                     message(HITOS_TEXT("Errors",
                                        "%1 is %2 m from %3: the tour takes more than %4 control "
                                        "steps; expected a shorter tour or a faster robot"),
                             name(goal), fmt::format("{:.0f}", way),
                             goal == 0 ? message(HITOS_TEXT("Errors", "the start"))
                                       : message(HITOS_TEXT("Errors", "the one before")),
                             kMostSteps));
            }
            before = at(goal);
        }
        if (least_s * robot_.control_rate_hz > kMostSteps + 1.0) check_steps(kMostSteps + 1);
    }

    void look_around() {
        double left = 2.0 * kPi;
        while (left > kTurnDone || twist().w != 0.0) {
            command(0.0, left > kTurnDone ? turn_rate(robot_, left) : 0.0);
            left -= twist().w * period_s_;
        }
    }

    void drive_to(const Point2& goal, const Point2* next) {
        // Twice the time at a tenth of the speed, and half a turn: beyond it something is wrong.
        const double straight = std::hypot(goal.x - pose().x, goal.y - pose().y);
        const double patience_s =
            20.0 * straight / robot_.max_speed + 10.0 * kPi / robot_.max_turn_rate + 60.0;
        for (double t = 0.0;; t += period_s_) {
            const double left = std::hypot(goal.x - pose().x, goal.y - pose().y);
            if (left <= robot_.tolerance_m) return;
            if (t > patience_s) {
                fail(way_point(goal_).line,
                     message(HITOS_TEXT("Errors",
                                        "%1 cannot be reached: the robot is still %2 m away after "
                                        "%3 s; raise robot.tolerance or the accelerations"),
                             name(goal_), fmt::format("{:.2f}", left), fmt::format("{:.0f}", t)));
            }
            // Where the goal is passed the robot has to be as slow as the next turn asks for.
            double at_goal = 0.0;
            if (next != nullptr) {
                const double way_in = std::atan2(goal.y - pose().y, goal.x - pose().x);
                const double way_out = std::atan2(next->y - goal.y, next->x - goal.x);
                at_goal = robot_.max_speed * speed_part(wrap_angle(way_out - way_in));
            }
            const Twist wanted = velocities(robot_, pose(), goal, left, at_goal);
            command(wanted.v, wanted.w);
        }
    }

    void follow_commands() {
        for (const DriveCommand& command : world_.tour.commands) {
            const double periods = command.duration_s * robot_.control_rate_hz;
            for (double k = 0.0; k + 0.5 < periods; k += 1.0) {
                motion_.command_among_walls(command.v, command.w);
                check_steps(motion_.steps());
            }
        }
    }

    void command(double v, double w) {
        motion_.command(v, w);
        check_clearance();
        check_steps(motion_.steps());
    }

    void check_clearance() const {
        if (world_.tour.way_points.empty()) return;  // it looks round before it is driven by hand
        const auto check = [&](double gap, const auto& what) {
            if (gap >= robot_.radius_m) return;
            fail(way_point(goal_).line,
                 message(HITOS_TEXT("Errors",
                                    "on the way to %1 the robot comes within %2 m of %3; "
                                    "expected at least its radius of %4 m"),
                         name(goal_), fmt::format("{:.3f}", std::max(0.0, gap)), what(),
                         fmt::format("{:g}", robot_.radius_m)));
        };
        for (const WallSegment& wall : motion_.conditions().walls())
            check(motion_.gap(wall), [&] { return wall_name(wall); });
        for (std::size_t i = 0; i < world_.landmarks.radii_m.size(); ++i)
            check(motion_.gap_to_tree(i), [&] { return tree_name(i); });
    }

    const World& world_;
    const RobotParams& robot_;
    double period_s_;
    RobotMotion motion_;
    std::size_t goal_ = 0;
};

}  // namespace

Twist towards(const Pose& pose, const Point2& goal, const RobotParams& robot) {
    const double left = std::hypot(goal.x - pose.x, goal.y - pose.y);
    return left <= robot.tolerance_m ? Twist{} : velocities(robot, pose, goal, left, 0.0);
}

void check_steps(std::size_t steps) {
    if (steps <= kMostSteps) return;
    throw ConfigError(
        "tour",
        HITOS_TEXT("Errors",
                   "takes more than %1 control steps; expected a shorter tour or a faster robot"),
        kMostSteps);
}

RobotMotion driven(const World& world) {
    check(world);
    return Driver(world).drive();
}

DrivenPath drive(const World& world) {
    return driven(world).path();
}

}  // namespace hitos
