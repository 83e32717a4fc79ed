// The robot's driver: where to turn and how fast to go, without noise and without chance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/simulation/driven_path.hpp"

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

class Driver {
  public:
    explicit Driver(const World& world)
        : world_(world),
          robot_(world.robot),
          period_s_(1.0 / world.robot.control_rate_hz),
          path_(world.tour.start, world.robot.control_rate_hz) {}

    DrivenPath drive() {
        check_start();
        check_spacing();
        for (double t = 0.0; t + 0.5 * period_s_ < world_.tour.rest_s; t += period_s_)
            path_.append({});
        if (world_.tour.look_around) look_around();
        const std::size_t count = world_.tour.way_points.size();
        const std::size_t goals = count * static_cast<std::size_t>(world_.tour.laps);
        for (goal_ = 0; goal_ < goals; ++goal_) {
            const Point2* next = goal_ + 1 < goals ? &at(goal_ + 1) : nullptr;
            drive_to(at(goal_), next);
        }
        --goal_;  // where it stops, for messages
        while (twist_.v != 0.0 || twist_.w != 0.0) command(0.0, 0.0);
        return std::move(path_);
    }

  private:
    const Pose& pose() const { return path_.poses().back(); }
    const WayPoint& way_point(std::size_t goal) const {
        const std::size_t count = world_.tour.way_points.size();
        const std::size_t at = goal % count;
        const bool turned = world_.tour.reverse && at + 1 < count;
        return world_.tour.way_points[turned ? count - 2 - at : at];
    }
    const Point2& at(std::size_t goal) const { return way_point(goal).at; }

    std::string name(std::size_t goal) const {
        const std::size_t count = world_.tour.way_points.size();
        const std::string lap =
            world_.tour.laps > 1 ? fmt::format(" of lap {}", goal / count + 1) : "";
        return fmt::format("way point {} at ({:g}, {:g}){}", goal % count + 1, at(goal).x,
                           at(goal).y, lap);
    }

    [[noreturn]] void fail(std::uint64_t line, const std::string& problem) const {
        throw FormatError(world_.file, line, problem);
    }

    static std::string wall_name(const WallSegment& wall) {
        return fmt::format("wall {}, ({:g}, {:g}) to ({:g}, {:g})", wall.wall, wall.a.x, wall.a.y,
                           wall.b.x, wall.b.y);
    }

    void check_start() const {
        const Point2 start{world_.tour.start.x, world_.tour.start.y};
        for (const WallSegment& wall : world_.walls) {
            const double gap = distance(wall, start);
            if (gap < robot_.radius_m) {
                fail(world_.tour.line,
                     fmt::format("the start at ({:g}, {:g}) is {:.3f} m from {}; expected at least "
                                 "the robot's radius of {:g} m",
                                 start.x, start.y, gap, wall_name(wall), robot_.radius_m));
            }
        }
    }

    /// A way point that is passed before the robot sets out for it is a mistake in the list.
    void check_spacing() const {
        const std::size_t count = world_.tour.way_points.size();
        Point2 before{world_.tour.start.x, world_.tour.start.y};
        for (std::size_t goal = 0; goal < count + (world_.tour.laps > 1 ? 1U : 0U); ++goal) {
            const double gap = std::hypot(at(goal).x - before.x, at(goal).y - before.y);
            if (gap <= 2.0 * robot_.tolerance_m) {
                fail(way_point(goal).line,
                     fmt::format("{} is {:.3f} m from {}; expected more than {:g} m, twice the "
                                 "tolerance at which it is passed",
                                 name(goal), gap, goal == 0 ? "the start" : "the one before",
                                 2.0 * robot_.tolerance_m));
            }
            before = at(goal);
        }
    }

    void look_around() {
        double left = 2.0 * kPi;
        while (left > kTurnDone || twist_.w != 0.0) {
            command(0.0, left > kTurnDone ? turn_rate(left) : 0.0);
            left -= twist_.w * period_s_;
        }
    }

    /// The turn rate for an angle still to be turned: proportional, so slow that the greatest turn
    /// acceleration brakes it without overshoot.
    double turn_rate(double angle_rad) const {
        const double gain = kReserve * std::min(robot_.turn_acceleration / robot_.max_turn_rate,
                                                robot_.control_rate_hz / 2.0);
        return std::clamp(gain * angle_rad, -robot_.max_turn_rate, robot_.max_turn_rate);
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
                     fmt::format("{} cannot be reached: the robot is still {:.2f} m away after "
                                 "{:.0f} s; raise robot.tolerance or the accelerations",
                                 name(goal_), left, t));
            }
            const double error = heading_error(pose(), goal);
            // Where the goal is passed the robot has to be as slow as the next turn asks for.
            double at_goal = 0.0;
            if (next != nullptr) {
                const double way_in = std::atan2(goal.y - pose().y, goal.x - pose().x);
                const double way_out = std::atan2(next->y - goal.y, next->x - goal.x);
                at_goal = robot_.max_speed * speed_part(wrap_angle(way_out - way_in));
            }
            const double braking =
                std::sqrt(at_goal * at_goal + 2.0 * kReserve * robot_.acceleration *
                                                  std::max(0.0, left - 0.5 * robot_.tolerance_m));
            command(std::min(robot_.max_speed * speed_part(error), braking), turn_rate(error));
        }
    }

    /// Changes the velocities towards the wanted ones as fast as the robot can, and holds them.
    void command(double v, double w) {
        const double dv = robot_.acceleration * period_s_;
        const double dw = robot_.turn_acceleration * period_s_;
        twist_.v = std::clamp(v, twist_.v - dv, twist_.v + dv);
        twist_.w = std::clamp(w, twist_.w - dw, twist_.w + dw);
        const Pose before = pose();
        path_.append(twist_);
        check_clearance({before.x, before.y}, {pose().x, pose().y});
        if (path_.twists().size() > kMostSteps) {
            throw ConfigError("tour", fmt::format("takes more than {} control steps; expected a "
                                                  "shorter tour or a faster robot",
                                                  kMostSteps));
        }
    }

    void check_clearance(const Point2& from, const Point2& to) const {
        // An arc leaves its chord by less than length * turn / 8.
        const double bulge = twist_.v * period_s_ * std::abs(twist_.w) * period_s_ / 8.0;
        for (const WallSegment& wall : world_.walls) {
            const double gap = distance(wall, from, to) - bulge;
            if (gap < robot_.radius_m) {
                fail(
                    way_point(goal_).line,
                    fmt::format("on the way to {} the robot comes within {:.3f} m of {}; expected "
                                "at least its radius of {:g} m",
                                name(goal_), std::max(0.0, gap), wall_name(wall), robot_.radius_m));
            }
        }
    }

    const World& world_;
    const RobotParams& robot_;
    double period_s_;
    DrivenPath path_;
    Twist twist_;
    std::size_t goal_ = 0;
};

}  // namespace

DrivenPath drive(const World& world) {
    check(world);
    return Driver(world).drive();
}

}  // namespace hitos
