// SPDX-License-Identifier: GPL-3.0-or-later
// Points, poses and twists of the plane. Metres, radians, seconds. A pose named `pose_a_b` takes
// coordinates in frame b to frame a.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace hitos {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / kPi;

/// The angle modulo 2*pi in (-pi, pi]; by formula, so that a huge angle costs no loop. A
/// non-finite angle gives NaN.
inline double wrap_angle(double angle_rad) {
    if (angle_rad > -kPi && angle_rad <= kPi) return angle_rad;
    const double wrapped = std::remainder(angle_rad, 2.0 * kPi);  // in [-pi, pi]
    return wrapped <= -kPi ? kPi : wrapped;
}

/// A point [m] in the frame that its name or owner states.
struct Point2 {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point2&, const Point2&) = default;
};

/// From one point to the other [m].
inline double distance(const Point2& a, const Point2& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// The upright rectangle that holds all points told to it.
struct Bounds {
    Point2 low;
    Point2 high;
    bool empty = true;

    void hold(const Point2& p) {
        low = empty ? p : Point2{std::min(low.x, p.x), std::min(low.y, p.y)};
        high = empty ? p : Point2{std::max(high.x, p.x), std::max(high.y, p.y)};
        empty = false;
    }
};

/// Position [m] and heading [rad] of a frame in another one.
struct Pose {
    double x = 0.0;
    double y = 0.0;
    double theta = 0.0;
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// A pose of the robot in the world at a time.
struct StampedPose {
    double time_s = 0.0;
    Pose pose;            ///< world from robot
    bool begins = false;  ///< another tour: no way leads here from the pose before
    friend bool operator==(const StampedPose&, const StampedPose&) = default;
};

using Trajectory = std::vector<StampedPose>;

/// The places of a path [m], for each tour of it a line.
std::vector<std::vector<Point2>> lines_of(const Trajectory& path);

/// Straight walls by their ends [m], in the frame that the owner states.
using Walls = std::vector<std::pair<Point2, Point2>>;

/// A velocity that is constant in the moving frame: forward [m/s], to the left [m/s], turn
/// [rad/s]. A differential robot has no lateral part; logged poses that were rounded do.
struct Twist {
    double v = 0.0;
    double v_lateral = 0.0;
    double w = 0.0;
    friend bool operator==(const Twist&, const Twist&) = default;
};

/// pose_a_c from pose_a_b and pose_b_c; the heading is wrapped to (-pi, pi].
Pose compose(const Pose& pose_a_b, const Pose& pose_b_c);

/// pose_b_a from pose_a_b.
Pose inverse(const Pose& pose_a_b);

/// pose_b_c from pose_a_b and pose_a_c, so that compose(pose_a_b, between) == pose_a_c.
Pose between(const Pose& pose_a_b, const Pose& pose_a_c);

/// The point's coordinates in frame a from those in frame b.
Point2 transform(const Pose& pose_a_b, const Point2& point_b);

/// The displacement in the starting frame after holding `twist` for `seconds`: the exponential
/// map of SE(2). With v_lateral = 0 this is [T eq 7.17] seen from the starting pose, with its
/// straight-line limit as w -> 0.
Pose displacement(const Twist& twist, double seconds);

/// The constant twist that makes exactly `pose_start_end` in `seconds` > 0 (|turn| <= pi): the
/// logarithm of SE(2), the inverse of displacement().
Twist twist_between(const Pose& pose_start_end, double seconds);

}  // namespace hitos
