// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/pose_graph.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "hitos/registration/laid_drawing.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/pose_graph_solver.hpp"

namespace hitos {

EdgeError edge_error(const PoseEdge& edge, const Pose& from, const Pose& to) {
    const double c = std::cos(from.theta);
    const double s = std::sin(from.theta);
    const bool elsewhere = edge.at.x != 0.0 || edge.at.y != 0.0;
    Point2 lever;  // from the origin of `to` to the place, in world axes
    if (elsewhere) lever = transform(Pose{0.0, 0.0, to.theta}, edge.at);
    const double dx = to.x + lever.x - from.x;
    const double dy = to.y + lever.y - from.y;
    const double ahead = c * dx + s * dy;
    const double left = -s * dx + c * dy;
    EdgeError error;
    error.value << ahead - edge.z.x, left - edge.z.y,
        wrap_angle(to.theta - from.theta - edge.z.theta);
    error.by_to << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
    if (elsewhere) {
        error.by_to(0, 2) = s * lever.x - c * lever.y;
        error.by_to(1, 2) = s * lever.y + c * lever.x;
    }
    error.by_from << -c, -s, left, s, -c, -ahead, 0.0, 0.0, -1.0;
    return error;
}

PoseEdge edge_of_origin(const PoseEdge& edge, const Pose& from, const Pose& to) {
    if (edge.at == Point2{}) return edge;
    PoseEdge other = edge;
    other.at = {};
    if (!(edge.information(2, 2) > 0.0)) other.z.theta = wrap_angle(to.theta - from.theta);
    const Point2 lever = transform(Pose{0.0, 0.0, other.z.theta}, edge.at);
    other.z.x -= lever.x;
    other.z.y -= lever.y;
    // Where the place is off, by how far its origin is, and its turn about that.
    Eigen::Matrix3d by_origin = Eigen::Matrix3d::Identity();
    by_origin(0, 2) = -lever.y;
    by_origin(1, 2) = lever.x;
    other.information = by_origin.transpose() * edge.information * by_origin;
    return other;
}

double greatest_move(std::span<const KeyPose> before, std::span<const KeyPose> after) {
    double greatest = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) {
        greatest = std::max(greatest, std::hypot(after[k].pose.x - before[k].pose.x,
                                                 after[k].pose.y - before[k].pose.y));
    }
    return greatest;
}

PoseGraphSolver::PoseGraphSolver(std::size_t keys, std::span<const PoseEdge> edges)
    : edges_(edges) {
    for (std::size_t i = 0; i < keys; ++i) equations_.add_variable(3);
    if (std::ranges::find(edges, EdgeKind::anchor, &PoseEdge::kind) != edges.end())
        drawing_ = equations_.add_variable(3);
}

void PoseGraphSolver::sum(const std::vector<KeyPose>& keys, bool robust, std::size_t used) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const PoseEdge& edge = edges_[i];
        if (edge.kind == EdgeKind::anchor) {
            // Which keeps its weight, wherever the drawing lies.
            const EdgeError error = edge_error(from_origin(edge), laid_, keys[edge.to].pose);
            const double weight = i < used ? 1.0 : 0.0;
            equations_.add(edge.to, error.by_to, *drawing_, error.by_from,
                           weight * edge.information, error.value);
            continue;
        }
        const EdgeError error = edge_error(edge, keys[edge.from].pose, keys[edge.to].pose);
        const double d2 = error.value.dot(edge.information * error.value);
        double weight = i < used ? 1.0 : 0.0;
        // The odometry's too: a log that has reversing as driving ahead (freiburg-079) would be
        // bent by it, 0.18 m instead of 0.08, and of the six other recorded tours none gains more
        // than 5 cm.
        if (robust) weight *= edge_weight(edge, d2);
        equations_.add(edge.from, error.by_from, edge.to, error.by_to, weight * edge.information,
                       error.value);
    }
}

/// About the place in it that the first anchor sees. No turn may move that: coordinates of surveys
/// are millions of metres, and a wall may be drawn by two places far from where it is seen.
void PoseGraphSolver::lay_drawing(const std::vector<KeyPose>& keys) {
    const auto anchor = std::ranges::find(edges_, EdgeKind::anchor, &PoseEdge::kind);
    const Point2 seen = transform(keys[anchor->to].pose, anchor->at);
    const Pose pose = laid_drawing(keys, edges_)->pose;
    origin_ = transform(inverse(pose), seen);
    laid_ = {seen.x, seen.y, pose.theta};
}

PoseEdge PoseGraphSolver::from_origin(const PoseEdge& anchor) const {
    PoseEdge edge = anchor;
    edge.z.x -= origin_.x;
    edge.z.y -= origin_.y;
    return edge;
}

double PoseGraphSolver::greatest_step(std::size_t keys) const {
    double greatest = 0.0;
    for (std::size_t i = 0; i < keys; ++i) {
        const auto step = equations_.step(i);
        greatest = std::max(greatest, std::abs(step(0)) + std::abs(step(1)));
    }
    return greatest;
}

double PoseGraphSolver::solve(std::vector<KeyPose>& keys, const GraphSolution& how,
                              std::size_t used) {
    // A key is held by 1/(0.1 mm)^2; the least information keeps the equations regular where
    // nothing says anything, and is next to none.
    constexpr double kHeld = 1e8;
    constexpr double kRegular = 1e-6;
    constexpr double kStill = 1e-3;  // [m]
    // Factorising takes most of the time. Small steps lead to the same place without it as long as
    // they shrink. After a large one neither the turns nor robust weights are what they were: with
    // the last factor a step of metres comes back as one of hundreds.
    constexpr double kSmall = 0.1;  // [m]
    constexpr double kShrinks = 0.5;
    if (keys.size() < 2 || edges_.empty()) return 0.0;

    const std::vector<KeyPose> before = keys;
    if (drawing_) lay_drawing(keys);
    double greatest = 0.0;
    bool factored = true;
    for (int iteration = 0; iteration < how.iterations;) {
        if (factored) {
            ++iteration;
            equations_.begin();
            equations_.hold(0, kHeld);
            for (std::size_t i = 1; i < keys.size(); ++i) {
                equations_.hold(i, i < how.held ? kHeld : kRegular);
            }
            if (drawing_) equations_.hold(*drawing_, kRegular);
        } else {
            equations_.begin_gradient();
        }
        sum(keys, how.robust, used);
        if (!(factored ? equations_.solve() : equations_.solve_again())) break;
        const double last = greatest;
        greatest = greatest_step(keys.size());
        if (!factored && !(greatest < kShrinks * last)) {
            factored = true;  // the same step again, with a factor of its own
            continue;
        }
        for (std::size_t i = how.held; i < keys.size(); ++i) {
            keys[i].pose = shifted(keys[i].pose, equations_.step(i));
        }
        if (drawing_) laid_ = shifted(laid_, equations_.step(*drawing_));
        if (greatest < kStill) break;
        factored = greatest >= kSmall;
    }
    return greatest_move(before, keys);
}

double solve(std::vector<KeyPose>& keys, std::span<const PoseEdge> edges,
             const GraphSolution& how) {
    return PoseGraphSolver(keys.size(), edges).solve(keys, how);
}

}  // namespace hitos
