// SPDX-License-Identifier: GPL-3.0-or-later
// States of a run that nobody has run, for what is told of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "hitos/services/run/run_worker.hpp"

namespace hitos::test {

/// After so many scans, one a second, on a straight way.
inline Snapshot snapshot_after(std::uint64_t scans) {
    Snapshot snapshot;
    snapshot.steps = scans;
    snapshot.scan.time_s = static_cast<double>(scans);
    for (std::uint64_t i = 0; i < scans; ++i) {
        const auto at = static_cast<double>(i);
        snapshot.best_trajectory.push_back({at + 1.0, {at, 0.5, 0.1}});
    }
    if (scans > 0) snapshot.best_pose = snapshot.best_trajectory.back().pose;
    snapshot.mean_pose = snapshot.best_pose;
    snapshot.pose_covariance = Eigen::Vector3d(0.04, 0.01, 0.0025).asDiagonal();
    return snapshot;
}

/// With a wall, a corner, two loops, three particles, two points of a scan and a grid.
inline Snapshot full_snapshot() {
    Snapshot snapshot = snapshot_after(3);
    ICaracteristica wall;
    wall.value = Recta{2.0, 0.5 * kPi};
    wall.covariance = Eigen::Vector2d(0.01, 0.0001).asDiagonal();
    ICaracteristica corner;
    corner.value = Esquina{1.0, 2.0};
    corner.covariance = Eigen::Vector2d(0.09, 0.01).asDiagonal();
    snapshot.best_map = {wall, corner};
    snapshot.line_extents = {{0, {-1.0, 2.0}, {3.0, 2.0}, 100}};
    for (const double x : {1.9, 2.0, 2.1}) {
        WeightedPose particle;
        particle.pose = {x, 0.5, 0.1};
        snapshot.hypotheses.push_back(particle);
    }
    RunLoop closed;
    closed.scan = snapshot.best_trajectory[2];
    closed.earlier = snapshot.best_trajectory[0];
    RunLoop refused = closed;
    refused.record.verdict = LoopVerdict::poor_fit;
    snapshot.loops = {closed, refused, closed};
    snapshot.scan.points = {{1.0, -2.0}, {0.5, 0.25}};
    Grid grid;
    grid.add(snapshot.scan, snapshot.best_pose);
    snapshot.step_grid = tiles_of(grid);
    return snapshot;
}

inline std::shared_ptr<const Snapshot> shared(Snapshot snapshot) {
    return std::make_shared<const Snapshot>(std::move(snapshot));
}

}  // namespace hitos::test
