// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot_motion.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

/// The robot's velocities where its wheels lose part of their way.
Twist slipped(const Twist& wheels, const Conditions& conditions, double track_m) {
    const double half = 0.5 * track_m;
    const double left = (wheels.v - wheels.w * half) * (1.0 - conditions.slip_left);
    const double right = (wheels.v + wheels.w * half) * (1.0 - conditions.slip_right);
    return {0.5 * (left + right), 0.0, (right - left) / track_m};
}

/// An arc leaves its chord by less than length * turn / 8.
double bulge(const Twist& twist, double period_s) {
    return std::abs(twist.v) * period_s * std::abs(twist.w) * period_s / 8.0;
}

/// How near a straight way comes to the bark of a tree.
double distance_to_bark(const MarkParams& marks, std::size_t tree, const Point2& from,
                        const Point2& to) {
    const Point2& middle = marks.at[tree];
    const double away =
        from == to ? distance(from, middle) : distance(WallSegment{from, to, 0, 0}, middle);
    return away - marks.radii_m[tree];
}

}  // namespace

RobotMotion::RobotMotion(const World& world)
    : world_(world),
      period_s_(1.0 / world.robot.control_rate_hz),
      path_(world.tour.start, world.robot.control_rate_hz),
      conditions_(world),
      events_(world.tour.events) {
    std::ranges::stable_sort(events_, {}, &Disturbance::at_s);
    take_events();
}

void RobotMotion::take_events() {
    constexpr double kRounding = 1e-9;
    while (taken_ < events_.size() && events_[taken_].at_s <= time_s() + kRounding) {
        disturb(events_[taken_++]);
    }
}

void RobotMotion::disturb(const Disturbance& disturbance) {
    conditions_.apply(disturbance, time_s(), world_);
    if (disturbance.kind != DisturbanceKind::push) return;
    const auto& [ahead, left, turn_deg] = disturbance.values;
    path_.displace({ahead, left, wrap_angle(turn_deg / 180.0 * kPi)});
}

Twist RobotMotion::next_twist(double v, double w) const {
    const double dv = world_.robot.acceleration * period_s_;
    const double dw = world_.robot.turn_acceleration * period_s_;
    return {std::clamp(v, twist_.v - dv, twist_.v + dv), 0.0,
            std::clamp(w, twist_.w - dw, twist_.w + dw)};
}

/// What the robot does where its wheels turn so.
Twist RobotMotion::motion_of(const Twist& wheels) const {
    const Conditions& now = conditions_.last();
    return time_s() < now.slip_until_s ? slipped(wheels, now, world_.robot.track_m) : wheels;
}

void RobotMotion::hold(const Twist& wheels) {
    twist_ = wheels;
    path_.append(motion_of(wheels), wheels);
    take_events();
}

void RobotMotion::command(double v, double w) {
    hold(next_twist(v, w));
}

void RobotMotion::command_among_walls(double v, double w) {
    const Twist next = next_twist(v, w);
    hold(barred(motion_of(next)) ? Twist{} : next);
}

/// Whether the robot would come nearer to a wall than its radius. One that stands too near
/// already, because it was carried there or the wall put before it, may leave.
bool RobotMotion::barred(const Twist& twist) const {
    const Pose after = compose(pose(), displacement(twist, period_s_));
    const Point2 from{pose().x, pose().y};
    const Point2 to{after.x, after.y};
    if (from == to) return false;
    const auto bars = [&](double nearest, const auto& from_point) {
        if (nearest - bulge(twist, period_s_) >= world_.robot.radius_m) return false;
        const double at_first = from_point(from);
        const bool leaves = nearest >= at_first && from_point(to) > at_first;
        return !leaves;
    };
    for (std::size_t i = 0; i < world_.landmarks.radii_m.size(); ++i) {
        const auto away = [&](const Point2& a, const Point2& b) {
            return distance_to_bark(world_.landmarks, i, a, b);
        };
        if (bars(away(from, to), [&](const Point2& p) { return away(p, p); })) return true;
    }
    return std::ranges::any_of(conditions_.walls(), [&](const auto& wall) {
        return bars(distance(wall, from, to), [&](const Point2& p) { return distance(wall, p); });
    });
}

/// Of the last control period.
RobotMotion::Way RobotMotion::last_way() const {
    const Twist& twist = path_.twists().back();
    const Pose& from = path_.poses()[path_.twists().size() - 1];
    const Pose to = compose(from, displacement(twist, period_s_));  // wherever it was carried then
    return {{from.x, from.y}, {to.x, to.y}, bulge(twist, period_s_)};
}

double RobotMotion::gap(const WallSegment& wall) const {
    const Way way = last_way();
    return distance(wall, way.from, way.to) - way.bulge_m;
}

double RobotMotion::gap_to_tree(std::size_t tree) const {
    const Way way = last_way();
    return distance_to_bark(world_.landmarks, tree, way.from, way.to) - way.bulge_m;
}

}  // namespace hitos
