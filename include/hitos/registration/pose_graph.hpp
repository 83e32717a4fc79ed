// Poses and what is known between them: the graph of key scans (Lu and Milios, 1997).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/registration/normal_equations.hpp"

namespace hitos {

/// A scan that the graph keeps.
struct KeyPose {
    Pose pose;               ///< of the robot in the world
    std::uint64_t scan = 0;  ///< its number in the tour
};

enum class EdgeKind : std::uint8_t {
    odometry,  ///< what the wheels say from one key to the next
    scan,      ///< what the key's scan says against a key not long ago
    loop       ///< what it says against one of an earlier passage
};

/// The pose of key `to` as key `from` saw it, with its information (the inverse of its covariance)
/// of (x, y, theta) in the axes of `from` [1/m^2, 1/m^2, 1/rad^2]; singular where a corridor leaves
/// a direction unknown.
struct PoseEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    Pose z;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    EdgeKind kind = EdgeKind::odometry;
};

/// The error of an edge and its derivatives by both poses.
struct EdgeError {
    Eigen::Vector3d value;    ///< (x, y, theta) of from^-1 to, less z [m, m, rad]
    Eigen::Matrix3d by_from;  ///< d(value)/d(from)
    Eigen::Matrix3d by_to;    ///< d(value)/d(to)
};
EdgeError edge_error(const PoseEdge& edge, const Pose& from, const Pose& to);

/// Weight of Cauchy's robust loss at a squared Mahalanobis distance, 1 / (1 + d2 / 9): at three
/// standard deviations an error counts half.
inline double robust_weight(double mahalanobis_squared) {
    return 1.0 / (1.0 + mahalanobis_squared / 9.0);
}

/// The loss itself, of which an error's weight is the slope: 9 ln(1 + d2 / 9).
inline double robust_loss(double mahalanobis_squared) {
    return 9.0 * std::log1p(mahalanobis_squared / 9.0);
}

/// How a graph is solved.
struct GraphSolution {
    int iterations = 10;  ///< with a factorisation of their own
    bool robust = true;   ///< whether edges far from the rest lose weight
};

/// Moves keys to where the edges' errors, squared and weighted, are least: Gauss-Newton with a
/// sparse Cholesky factorisation, the first key held. It stops where no key moves a millimetre.
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

    std::span<const PoseEdge> edges_;
    NormalEquations equations_;
};

/// One PoseGraphSolver's one solution.
double solve(std::vector<KeyPose>& keys, std::span<const PoseEdge> edges, const GraphSolution& how);

}  // namespace hitos
