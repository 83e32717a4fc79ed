// SPDX-License-Identifier: GPL-3.0-or-later
// Poses and what is known between them: the graph of key scans (Lu and Milios, 1997).
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// A scan that the graph keeps.
struct KeyPose {
    Pose pose;               ///< of the robot in the world
    std::uint64_t scan = 0;  ///< its number in the tour
};

enum class EdgeKind : std::uint8_t {
    odometry,  ///< what the wheels say from one key to the next
    scan,      ///< what the key's scan says against a key not long ago
    loop,      ///< what it says against one of an earlier passage
    by_hand,   ///< what somebody says: it keeps its weight, however far the rest is from it
    fix,       ///< the same of where a key lies in the map, from the first one
    anchor     ///< the same of a place in a drawing, wherever the drawing lies
};

/// The pose of key `to` as key `from` saw it, with its information (the inverse of its covariance)
/// of (x, y, theta) in the axes of `from` [1/m^2, 1/m^2, 1/rad^2]; singular where a corridor leaves
/// a direction unknown. Of an anchor the drawing stands for `from`: z and the axes are those of its
/// frame, which no key says anything of (LaidDrawing).
struct PoseEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    Pose z;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    EdgeKind kind = EdgeKind::odometry;
    /// The place, in the frame of `to`, whose position is meant [m].
    Point2 at = {};

    /// Whether somebody has said it.
    bool said() const { return kind >= EdgeKind::by_hand; }
};

/// The error of an edge and its derivatives by both poses.
struct EdgeError {
    Eigen::Vector3d value;    ///< (x, y, theta) of from^-1 to, at its place, less z [m, m, rad]
    Eigen::Matrix3d by_from;  ///< d(value)/d(from)
    Eigen::Matrix3d by_to;    ///< d(value)/d(to)
};
EdgeError edge_error(const PoseEdge& edge, const Pose& from, const Pose& to);

/// The edge for who knows of no place in the frame of `to`: of its origin, and the same to the
/// first order of the turn between z, where it knows the heading, and the poses as they lie.
PoseEdge edge_of_origin(const PoseEdge& edge, const Pose& from, const Pose& to);

}  // namespace hitos
