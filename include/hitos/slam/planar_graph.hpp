// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs of poses and landmarks of the plane as other programs have them, and their least squares.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/registration/graph_edit.hpp"

namespace hitos {

/// What is looked for.
struct PlanarVertex {
    enum class Kind : std::uint8_t {
        pose,   ///< (x, y, theta) [m, m, rad] in the world
        point,  ///< (x, y) [m]
        line    ///< (theta, rho): x cos theta + y sin theta = rho [rad, m]
    };
    Kind kind = Kind::pose;
    bool fixed = false;
    std::uint64_t id = 0;  ///< no other vertex has it
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::array<std::int64_t, 2> ends{-1, -1};  ///< ids of a line's end points; -1: none

    Pose pose() const { return {at(0), at(1), at(2)}; }
    Point2 point() const { return {at(0), at(1)}; }
};

/// What was measured. Its error is what the vertices make of it less z, in z's own axes.
struct PlanarEdge {
    enum class Kind : std::uint8_t {
        step,            ///< z: pose `to` seen from pose `from`
        point,           ///< z: point `to` seen from pose `from`
        line,            ///< z: line `to` seen from pose `from`; its normal is not turned
        pose_prior,      ///< z: pose `to`; `from` is the same vertex, in all priors
        position_prior,  ///< z: (x, y) of pose `to`
        point_prior      ///< z: point `to`
    };
    Kind kind = Kind::step;
    bool by_hand = false;  ///< keeps its weight, however far the rest is from it
    std::uint32_t from = 0;
    std::uint32_t to = 0;  ///< both of PlanarGraph::vertices
    Eigen::Vector3d z = Eigen::Vector3d::Zero();
    /// Of the numbers of z, the inverse of their covariance; it may be singular.
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

    bool prior() const { return kind >= Kind::pose_prior; }
    /// How many numbers of z are used.
    Eigen::Index size() const { return kind == Kind::step || kind == Kind::pose_prior ? 3 : 2; }
};

/// Poses and points of the plane, and what ties them to each other.
struct PlanarGraph {
    std::vector<PlanarVertex> vertices;
    std::vector<PlanarEdge> edges;

    std::size_t count(PlanarVertex::Kind kind) const;
    std::size_t count(PlanarEdge::Kind kind) const;
};

/// The squared error of an edge in units of its standard deviations.
double mahalanobis_squared(const PlanarGraph& graph, const PlanarEdge& edge);
/// The sum of them.
double chi_square(const PlanarGraph& graph);
/// Which edges have the greatest errors, at most so many, the greatest first.
std::vector<std::size_t> worst_edges(const PlanarGraph& graph, std::size_t most);

/// How a graph was solved.
struct PlanarSolution {
    double chi_square_before = 0.0;
    double chi_square_after = 0.0;
    int steps = 0;                 ///< tried, with a factorisation each
    bool converged = false;        ///< further steps would move nothing
    double greatest_move_m = 0.0;  ///< of a pose or point
    std::size_t parts = 0;         ///< that no edge ties to each other
    /// A vertex of each part in which nothing is fixed and that has no prior: it was held.
    std::vector<std::uint32_t> held;
};

enum class PlanarStart : std::uint8_t {
    best,  ///< from where the vertices are, or where the fewest edges have them
    here   ///< three steps from where they are: enough for an eye after a small change
};

/// Moves the vertices that are not fixed to where the sum of squared errors is least, by
/// Levenberg's and Marquardt's steps from where they are, or from where the fewest edges from what
/// is fixed have them if that sum is less there; it never grows. `robust`: errors far from the rest
/// lose weight, and the sum is robust_loss()'s. Asked to stop it ends with the step under way, not
/// converged. Throws Error where the numbers are beyond reckoning.
PlanarSolution solve(PlanarGraph& graph, bool robust, PlanarStart start = PlanarStart::best,
                     const std::stop_token& stop = {});

/// Changes by hand (parse_vertex_edits()): refuse drops the edges between two poses, close adds one
/// as sure as an eye is, fix adds a prior of a place that is known, slip takes the edges to a pose
/// from the one with the next lower id for a metre and a radian. Throws wrong_edit() for a
/// change that meets nothing.
void edit(PlanarGraph& graph, const PlacedEdits& edits);
/// What parse_vertex_edits() reads back as the same, to the last bit: one a line.
std::string vertex_text_of(std::span<const GraphEdit> edits);

}  // namespace hitos
