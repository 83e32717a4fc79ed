// SPDX-License-Identifier: GPL-3.0-or-later
// The graph that a finished run stands for.
#pragma once

#include "hitos/services/run/algoritmo.hpp"
#include "hitos/slam/planar_graph.hpp"

namespace hitos {

/// Poses of the best path, landmarks of the best map, and what the tour says between them: poses
/// have the numbers of their scans, the first is fixed, landmarks come after them. The tour
/// is read and its features are found once more: what the filter took for what at the time belongs
/// to other maps than the finished one.
///
/// Between scans that follow on each other stands what the motion model makes of the controls, with
/// its noise and 0.1 mm and 0.1 mrad besides, since a robot at rest has none. A run with
/// registration has there what the wheels say, as sure as registration takes them to be
/// (odometry_variances()), and registration's own edges between key scans, loops among them, with
/// their information.
///
/// A feature belongs to the landmark that is nearest to it, seen from the path, within the gate
/// that holds 99 % (chi-square, of the landmark's covariance and the measurement's); of lines only
/// those count whose known part comes within 0.5 m of what was seen. A landmark that no feature
/// came so near to has the one that came nearest, so that none is alone.
PlanarGraph graph_of(const Algoritmo& run);

}  // namespace hitos
