// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid motions of space, as far as the mounting of a laser needs them.
#pragma once

#include <algorithm>
#include <cmath>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Takes coordinates of frame b to frame a: a rotation by a quaternion of length 1, then a shift
/// [m].
struct Transform {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double qx = 0.0;
    double qy = 0.0;
    double qz = 0.0;
    double qw = 1.0;
    double length = 1.0;  ///< that the quaternion had where it was read

    /// The heading of the b frame's x axis in the plane of frame a.
    double yaw() const {
        return std::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz));
    }
    /// The b frame's z axis along that of frame a: 1 level, -1 upside down.
    double upward() const { return 1.0 - 2.0 * (qx * qx + qy * qy); }
    /// Without height and tilt.
    Pose plane() const { return {x, y, yaw()}; }
};

/// a_c from a_b and b_c.
inline Transform compose(const Transform& a, const Transform& b) {
    Transform c;
    c.qw = a.qw * b.qw - a.qx * b.qx - a.qy * b.qy - a.qz * b.qz;
    c.qx = a.qw * b.qx + a.qx * b.qw + a.qy * b.qz - a.qz * b.qy;
    c.qy = a.qw * b.qy - a.qx * b.qz + a.qy * b.qw + a.qz * b.qx;
    c.qz = a.qw * b.qz + a.qx * b.qy - a.qy * b.qx + a.qz * b.qw;
    // v + 2 q x (q x v + w v)
    const double tx = 2.0 * (a.qy * b.z - a.qz * b.y);
    const double ty = 2.0 * (a.qz * b.x - a.qx * b.z);
    const double tz = 2.0 * (a.qx * b.y - a.qy * b.x);
    c.x = a.x + b.x + a.qw * tx + a.qy * tz - a.qz * ty;
    c.y = a.y + b.y + a.qw * ty + a.qz * tx - a.qx * tz;
    c.z = a.z + b.z + a.qw * tz + a.qx * ty - a.qy * tx;
    return c;
}

/// b_a from a_b.
inline Transform inverse(const Transform& a) {
    const Transform turned{0.0, 0.0, 0.0, -a.qx, -a.qy, -a.qz, a.qw};
    return compose(turned, {-a.x, -a.y, -a.z});
}

/// How far two places are from each other [m], a radian counted as a metre.
inline double apart(const Transform& a, const Transform& b) {
    const double dot = a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw;
    const double angle = 2.0 * std::acos(std::min(1.0, std::abs(dot)));
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) + angle;
}

}  // namespace hitos
