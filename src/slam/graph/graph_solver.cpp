// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_solver.hpp"

#include <Eigen/LU>

#include "hitos/registration/pose_graph_solver.hpp"

namespace hitos {
namespace {

constexpr int kMostSteps = 20;
constexpr double kShrinks = 0.5;

}  // namespace

void GraphSolver::lay_out(const LandmarkGraph& graph) {
    equations_ = NormalEquations();
    keys_ = graph.keys().size();
    landmarks_ = graph.landmarks().size();
    for (std::size_t i = 1; i < keys_; ++i) equations_.add_variable(3);
    for (std::size_t i = 0; i < landmarks_; ++i) equations_.add_variable(2);
}

/// `gradient_only`: where the matrix stays.
void GraphSolver::sum(const LandmarkGraph& graph, bool gradient_only) {
    if (gradient_only) {
        equations_.begin_gradient();
    } else {
        equations_.begin();
    }
    objective_ = 0.0;
    for (std::size_t i = 1; i < keys_; ++i) equations_.hold(variable_of_key(i), kUntiedInformation);
    for (const PoseEdge& edge : graph.edges()) add(edge, graph);
    for (const Sighting& sighting : graph.sightings()) add(sighting, graph);
}

void GraphSolver::add(const PoseEdge& edge, const LandmarkGraph& graph) {
    const EdgeError error =
        edge_error(edge, graph.keys()[edge.from].pose, graph.keys()[edge.to].pose);
    const double d2 = error.value.dot(edge.information * error.value);
    objective_ += edge_loss(edge, d2);
    const Matrix3 weight = edge_weight(edge, d2) * edge.information;
    if (edge.from == 0) {
        equations_.add(variable_of_key(edge.to), error.by_to, weight, error.value);
    } else if (edge.to == 0) {
        equations_.add(variable_of_key(edge.from), error.by_from, weight, error.value);
    } else if (edge.from < edge.to) {
        equations_.add(variable_of_key(edge.from), error.by_from, variable_of_key(edge.to),
                       error.by_to, weight, error.value);
    } else {
        equations_.add(variable_of_key(edge.to), error.by_to, variable_of_key(edge.from),
                       error.by_from, weight, error.value);
    }
}

void GraphSolver::add(const Sighting& sighting, const LandmarkGraph& graph) {
    const SightingError error = graph.error_of(sighting);
    const double d2 = error.value.dot(sighting.information * error.value);
    objective_ += sighting.loss(d2);
    const Matrix2 weight = sighting.weight(d2) * sighting.information;
    const std::size_t landmark = variable_of_landmark(sighting.landmark);
    if (sighting.key == 0) {
        equations_.add(landmark, error.by_landmark, weight, error.value);
    } else {
        equations_.add(variable_of_key(sighting.key), error.by_pose, landmark, error.by_landmark,
                       weight, error.value);
    }
}

bool GraphSolver::solve(LandmarkGraph& graph, double still_m) {
    lay_out(graph);
    if (equations_.variables() == 0) return false;
    double before = 0.0;
    double greatest = 0.0;
    double objective = 0.0;
    LandmarkGraph::Places places;
    for (int iteration = 0; iteration < kMostSteps; ++iteration) {
        // Factorising takes most of the time; while steps shrink without it they lead to the same.
        const bool shrinks = iteration > 1 ? greatest < kShrinks * before : iteration == 1;
        sum(graph, shrinks);
        if (iteration > 0 && objective_ > objective) {
            // Where sightings and edges contradict each other they all have next to no weight left,
            // and steps no limit.
            graph.restore(places);
            sum(graph);
            return equations_.solve();
        }
        objective = objective_;
        places = graph.places();
        if (!(shrinks ? equations_.solve_again() : equations_.solve())) return false;
        before = greatest;
        greatest = 0.0;
        for (std::size_t i = 1; i < keys_; ++i) {
            const Eigen::Vector3d step = equations_.step(variable_of_key(i));
            graph.pose(i) = shifted(graph.pose(i), step);
            greatest = std::max(greatest, std::abs(step(0)) + std::abs(step(1)));
        }
        for (std::size_t i = 0; i < landmarks_; ++i) {
            const Vector2 step = equations_.step(variable_of_landmark(i));
            graph.move_landmark(i, step);
            greatest = std::max(greatest, std::abs(step(0)) + std::abs(step(1)));
        }
        if (greatest < still_m) break;
    }
    return true;
}

bool GraphSolver::linearize(const LandmarkGraph& graph) {
    lay_out(graph);
    if (equations_.variables() == 0) return false;
    sum(graph);
    return equations_.solve();
}

Matrix3 GraphSolver::key_covariance(std::size_t key) const {
    if (key == 0) return Matrix3::Zero();
    return equations_.marginal(variable_of_key(key));
}

std::vector<Matrix2> GraphSolver::landmark_covariances() const {
    const std::vector<Eigen::MatrixXd> all = equations_.marginals();
    std::vector<Matrix2> covariances;
    for (std::size_t i = 0; i < landmarks_; ++i) {
        covariances.emplace_back(all[variable_of_landmark(i)]);
    }
    return covariances;
}

Matrix2 GraphSolver::covariance(std::size_t a, const Matrix2& j_a, std::size_t b,
                                const Matrix2& j_b) const {
    return equations_.covariance(variable_of_landmark(a), j_a, variable_of_landmark(b), j_b);
}

}  // namespace hitos
