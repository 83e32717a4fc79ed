// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/geometry.hpp"

namespace hitos {
namespace {

/// sin(a)/a and (1 - cos a)/a, by series where the quotient would lose digits.
struct TurnFactors {
    double sinc;
    double cosc;
};

TurnFactors turn_factors(double a) {
    if (std::abs(a) < 1e-4) return {1.0 - a * a / 6.0, a / 2.0 - a * a * a / 24.0};
    return {std::sin(a) / a, (1.0 - std::cos(a)) / a};
}

}  // namespace

Pose compose(const Pose& pose_a_b, const Pose& pose_b_c) {
    const Point2 origin = transform(pose_a_b, {pose_b_c.x, pose_b_c.y});
    return {origin.x, origin.y, wrap_angle(pose_a_b.theta + pose_b_c.theta)};
}

Pose inverse(const Pose& pose_a_b) {
    const double c = std::cos(pose_a_b.theta);
    const double s = std::sin(pose_a_b.theta);
    return {-c * pose_a_b.x - s * pose_a_b.y, s * pose_a_b.x - c * pose_a_b.y,
            wrap_angle(-pose_a_b.theta)};
}

Pose between(const Pose& pose_a_b, const Pose& pose_a_c) {
    const double dx = pose_a_c.x - pose_a_b.x;
    const double dy = pose_a_c.y - pose_a_b.y;
    const double c = std::cos(pose_a_b.theta);
    const double s = std::sin(pose_a_b.theta);
    return {c * dx + s * dy, -s * dx + c * dy, wrap_angle(pose_a_c.theta - pose_a_b.theta)};
}

Point2 transform(const Pose& pose_a_b, const Point2& point_b) {
    const double c = std::cos(pose_a_b.theta);
    const double s = std::sin(pose_a_b.theta);
    return {pose_a_b.x + c * point_b.x - s * point_b.y, pose_a_b.y + s * point_b.x + c * point_b.y};
}

Pose displacement(const Twist& twist, double seconds) {
    const double turn = twist.w * seconds;
    const auto [sinc, cosc] = turn_factors(turn);
    const double forward = twist.v * seconds;
    const double left = twist.v_lateral * seconds;
    return {sinc * forward - cosc * left, cosc * forward + sinc * left, wrap_angle(turn)};
}

Twist twist_between(const Pose& pose_start_end, double seconds) {
    const auto [sinc, cosc] = turn_factors(pose_start_end.theta);
    const double det = sinc * sinc + cosc * cosc;  // 4/pi^2 at the least, for |turn| <= pi
    const double forward = (sinc * pose_start_end.x + cosc * pose_start_end.y) / det;
    const double left = (sinc * pose_start_end.y - cosc * pose_start_end.x) / det;
    return {forward / seconds, left / seconds, pose_start_end.theta / seconds};
}

std::vector<std::vector<Point2>> lines_of(const Trajectory& path) {
    std::vector<std::vector<Point2>> lines;
    for (const StampedPose& stamped : path) {
        if (lines.empty() || stamped.begins) lines.emplace_back();
        lines.back().push_back({stamped.pose.x, stamped.pose.y});
    }
    return lines;
}

}  // namespace hitos
