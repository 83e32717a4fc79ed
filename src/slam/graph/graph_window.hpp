// SPDX-License-Identifier: GPL-3.0-or-later
// The newest part of the graph of graph-slam, solved while the rest stays where it is.
#pragma once

#include <vector>

#include "landmark_graph.hpp"

namespace hitos {

/// Least squares over the newest keys and the landmarks that they see, with every older key held:
/// what a new scan changes lies there, until a loop is closed. What it knows is relative to the
/// older keys, as it has to be for the association: how far all of them have drifted together is
/// no reason to take a wall for its neighbour.
class GraphWindow {
  public:
    /// The keys that move.
    static constexpr std::size_t kKeys = 8;

    void solve(LandmarkGraph& graph);

    /// Of the newest key.
    Matrix3 key_covariance() const;
    /// Of a landmark's local coordinates, and with the newest key's pose; as of solve(), or where
    /// it is none of the window's, given all poses.
    Matrix2 landmark_covariance(const LandmarkGraph& graph, std::size_t landmark) const;
    Matrix23 cross_covariance(std::size_t landmark) const;
    /// Of j_a a + j_b b.
    Matrix2 covariance(const LandmarkGraph& graph, std::size_t a, const Matrix2& j_a, std::size_t b,
                       const Matrix2& j_b) const;
    /// The landmarks that the newest scan may be compared with, ascending: those seen by keys of
    /// the window or by keys that an edge ties to one of them. To others the drift is not known.
    const std::vector<std::uint32_t>& reachable() const { return reachable_; }

  private:
    static constexpr Eigen::Index kNone = -1;

    void lay_out(const LandmarkGraph& graph);
    void find_reachable(const LandmarkGraph& graph);
    void sum(const LandmarkGraph& graph);
    void add(const PoseEdge& edge, const LandmarkGraph& graph);
    void add(const Sighting& sighting, const LandmarkGraph& graph);
    /// Where the variables of a key or landmark begin.
    Eigen::Index of_key(std::size_t key) const {
        return key < first_ ? kNone : 3 * static_cast<Eigen::Index>(key - first_);
    }
    Eigen::Index of_landmark(std::size_t landmark) const {
        return landmark < at_.size() ? at_[landmark] : kNone;
    }

    std::size_t first_ = 0;  // key of the window
    std::size_t keys_ = 0;
    std::vector<std::uint32_t> landmarks_;
    std::vector<Eigen::Index> at_;  // by landmark
    std::vector<std::uint32_t> reachable_;
    Eigen::MatrixXd h_;
    Eigen::VectorXd gradient_;
    double objective_ = 0.0;  // of sum()
    Eigen::MatrixXd covariance_;
};

}  // namespace hitos
