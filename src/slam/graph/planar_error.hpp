// SPDX-License-Identifier: GPL-3.0-or-later
// The error of an edge of a planar graph, with its derivatives.
#pragma once

#include <algorithm>

#include "graph_landmark.hpp"
#include "hitos/registration/odometry_step.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/pose_graph.hpp"
#include "hitos/slam/planar_graph.hpp"

namespace hitos {

/// Of two or three numbers.
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

struct PlanarError {
    SmallVector value;
    SmallMatrix by_from;  ///< of no size in a prior
    SmallMatrix by_to;    ///< a line's by its (theta, rho)
    SmallMatrix information;
};
PlanarError planar_error(const PlanarGraph& graph, const PlanarEdge& edge);
/// Of information written with few digits a direction may be a little below 0.
inline double mahalanobis_squared(const PlanarError& error) {
    return std::max(0.0, error.value.dot(error.information * error.value));
}

/// The vertices where the fewest edges from a root have them; those that none leads to stay.
std::vector<PlanarVertex> along_edges(const PlanarGraph& graph,
                                      const std::vector<std::uint32_t>& roots);

}  // namespace hitos
