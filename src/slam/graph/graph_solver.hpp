// SPDX-License-Identifier: GPL-3.0-or-later
// The whole graph of graph-slam at once: its least squares and what it knows.
#pragma once

#include <memory>

#include "hitos/registration/normal_equations.hpp"
#include "landmark_graph.hpp"

namespace hitos {

/// Gauss-Newton over all keys but the first, and all landmarks. The equations stay as they were
/// after the last step: covariances are asked of them.
class GraphSolver {
  public:
    /// Moves keys and landmarks to where the squared errors of edges and sightings, in units of
    /// their standard deviations and with robust_weight(), are least; it stops where none moves by
    /// `still_m`. False where the equations cannot be solved.
    bool solve(LandmarkGraph& graph, double still_m = 1e-3);
    /// Only sets up the equations where the graph is now. False where they cannot be solved.
    bool linearize(const LandmarkGraph& graph);

    /// Covariances in the frame of the first key, after solve() or linearize().
    Matrix3 key_covariance(std::size_t key) const;
    /// Of all landmarks' local coordinates.
    std::vector<Matrix2> landmark_covariances() const;
    /// Of j_a a + j_b b, a and b the local coordinates of two landmarks.
    Matrix2 covariance(std::size_t a, const Matrix2& j_a, std::size_t b, const Matrix2& j_b) const;

  private:
    void lay_out(const LandmarkGraph& graph);
    void sum(const LandmarkGraph& graph, bool gradient_only = false);
    void add(const PoseEdge& edge, const LandmarkGraph& graph);
    void add(const Sighting& sighting, const LandmarkGraph& graph);
    /// The first key is no variable.
    static std::size_t variable_of_key(std::size_t key) { return key - 1; }
    std::size_t variable_of_landmark(std::size_t landmark) const { return keys_ - 1 + landmark; }

    NormalEquations equations_;
    double objective_ = 0.0;  // of sum()
    std::size_t keys_ = 0;
    std::size_t landmarks_ = 0;
};

}  // namespace hitos
