// SPDX-License-Identifier: GPL-3.0-or-later
// Solves the graph of key scans by Gauss-Newton steps (Lu and Milios, 1997).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hitos/registration/normal_equations.hpp"
#include "hitos/registration/pose_graph.hpp"

namespace hitos {

/// Weight of Cauchy's robust loss at a squared Mahalanobis distance, 1 / (1 + d2 / 9): at three
/// standard deviations an error counts half.
inline double robust_weight(double mahalanobis_squared) {
    return 1.0 / (1.0 + mahalanobis_squared / 9.0);
}

/// The loss itself, of which an error's weight is the slope: 9 ln(1 + d2 / 9).
inline double robust_loss(double mahalanobis_squared) {
    return 9.0 * std::log1p(mahalanobis_squared / 9.0);
}

/// The same of an edge: what somebody says keeps its weight.
inline double edge_weight(const PoseEdge& edge, double mahalanobis_squared) {
    return edge.said() ? 1.0 : robust_weight(mahalanobis_squared);
}
inline double edge_loss(const PoseEdge& edge, double mahalanobis_squared) {
    return edge.said() ? mahalanobis_squared : robust_loss(mahalanobis_squared);
}

/// The furthest that a key has moved [m].
double greatest_move(std::span<const KeyPose> before, std::span<const KeyPose> after);

/// How a graph is solved.
struct GraphSolution {
    int iterations = 10;   ///< with a factorisation of their own
    bool robust = true;    ///< whether edges far from the rest lose weight
    std::size_t held = 0;  ///< the first keys, that do not move at all
};

/// Moves keys to where the edges' errors, squared and weighted, are least: Gauss-Newton with a
/// sparse Cholesky factorisation, the first key held. It stops where no key moves a millimetre. The
/// drawing of anchors goes where they and the keys have it.
class PoseGraphSolver {
  public:
    /// `edges` have to stay while it is used. What depends on them alone, the order in which keys
    /// are eliminated, is found out once.
    PoseGraphSolver(std::size_t keys, std::span<const PoseEdge> edges);

    /// Returns the greatest move of a key [m] against where it began; keys stay where the last step
    /// left them where the equations cannot be solved. There are as many as the solver was made
    /// for.
    double solve(std::vector<KeyPose>& keys, const GraphSolution& how) {
        return solve(keys, how, edges_.size());
    }
    /// The same with the first `used` edges alone.
    double solve(std::vector<KeyPose>& keys, const GraphSolution& how, std::size_t used);

  private:
    void sum(const std::vector<KeyPose>& keys, bool robust, std::size_t used);
    double greatest_step(std::size_t keys) const;
    void lay_drawing(const std::vector<KeyPose>& keys);
    PoseEdge from_origin(const PoseEdge& anchor) const;

    std::span<const PoseEdge> edges_;
    NormalEquations equations_;
    // Of the drawing, where there are anchors, about a place in it.
    std::optional<std::size_t> drawing_;
    Point2 origin_;
    Pose laid_;  // in the world, of a frame at the origin with the drawing's axes
};

/// One PoseGraphSolver's one solution.
double solve(std::vector<KeyPose>& keys, std::span<const PoseEdge> edges, const GraphSolution& how);

}  // namespace hitos
