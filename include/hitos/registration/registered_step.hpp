// SPDX-License-Identifier: GPL-3.0-or-later
// What registration says of a scan, as plain values for whoever uses the path.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "hitos/registration/pose_graph.hpp"

namespace hitos {

/// One scan placed by registration. Poses are of the robot in the world; the first scan's is the
/// origin.
struct RegisteredStep {
    std::uint64_t scan = 0;  ///< its number, from 0
    Pose before;             ///< at the scan before, with every correction so far
    Pose pose;               ///< at this scan, before a loop that it closes corrects it
    /// Of the step from `before` to `pose`, of (x, y, theta) in the axes of `before` [m, m, rad];
    /// as great as the odometry's where the scan fitted nothing.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double path_m = 0.0;      ///< way by odometry since the scan before
    double turned_rad = 0.0;  ///< sum of absolute turns by odometry
    bool matched = false;     ///< whether the scan fitted what was seen before
    double score = 0.0;       ///< of the match, 0 … 1
    bool key = false;         ///< whether the scan became the graph's newest key
    /// The graph's keys, oldest first, and its edges, the newest last; valid until registration
    /// takes the next scan.
    std::span<const KeyPose> keys;
    std::span<const PoseEdge> edges;

    bool moved() const { return path_m > 0.0 || turned_rad > 0.0; }
};

/// That the graph moved what lies behind: a loop was closed, or the tour is at its end.
struct PathCorrection {
    /// For every scan so far the rigid motion G of the world, new pose = G * old pose.
    std::span<const Pose> by_scan;
    /// As in RegisteredStep, after the correction. At the end of a tour the edges between scans are
    /// measured anew, so none may be the one it was.
    std::span<const KeyPose> keys;
    std::span<const PoseEdge> edges;
    bool map_stays = false;  ///< of another tour, which is at its end: the path alone moves
};

}  // namespace hitos
