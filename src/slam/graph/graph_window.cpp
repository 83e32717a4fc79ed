// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_window.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "hitos/registration/pose_graph_solver.hpp"

namespace hitos {
namespace {

constexpr int kWindowSteps = 3;
constexpr double kStill = 1e-3;  // [m]

template <class First, class Second>
void add_outer(Eigen::MatrixXd& h, Eigen::Index row, const First& jw, Eigen::Index column,
               const Second& j) {
    h.block<First::RowsAtCompileTime, Second::ColsAtCompileTime>(row, column) += jw * j;
}

}  // namespace

void GraphWindow::lay_out(const LandmarkGraph& graph) {
    keys_ = graph.keys().size();
    // The first key of all is held.
    first_ = std::max<std::size_t>(keys_ > kKeys ? keys_ - kKeys : 0, 1);
    at_.assign(graph.landmarks().size(), kNone);
    landmarks_.clear();
    Eigen::Index size = 3 * static_cast<Eigen::Index>(keys_ > first_ ? keys_ - first_ : 0);
    for (std::size_t key = keys_ > first_ ? first_ : 0; key < keys_; ++key) {
        for (const std::uint32_t i : graph.sightings_of(key)) {
            const std::uint32_t landmark = graph.sightings()[i].landmark;
            if (at_[landmark] != kNone) continue;
            at_[landmark] = size;
            size += 2;
            landmarks_.push_back(landmark);
        }
    }
    h_.resize(size, size);
    gradient_.resize(size);
}

void GraphWindow::find_reachable(const LandmarkGraph& graph) {
    std::vector<bool> near(keys_, false);
    for (std::size_t key = keys_ > kKeys ? keys_ - kKeys : 0; key < keys_; ++key) {
        near[key] = true;
        for (const std::uint32_t i : graph.edges_of(key)) {
            near[graph.edges()[i].from] = true;
            near[graph.edges()[i].to] = true;
        }
    }
    reachable_.clear();
    std::vector<bool> noted(graph.landmarks().size(), false);
    for (std::size_t key = 0; key < keys_; ++key) {
        if (!near[key]) continue;
        for (const std::uint32_t i : graph.sightings_of(key)) {
            const std::uint32_t landmark = graph.sightings()[i].landmark;
            if (!noted[landmark]) reachable_.push_back(landmark);
            noted[landmark] = true;
        }
    }
    std::ranges::sort(reachable_);
}

void GraphWindow::add(const PoseEdge& edge, const LandmarkGraph& graph) {
    const EdgeError error =
        edge_error(edge, graph.keys()[edge.from].pose, graph.keys()[edge.to].pose);
    const double d2 = error.value.dot(edge.information * error.value);
    objective_ += edge_loss(edge, d2);
    const Matrix3 weight = edge_weight(edge, d2) * edge.information;
    const Eigen::Index from = of_key(edge.from);
    const Eigen::Index to = of_key(edge.to);
    const Matrix3 from_w = error.by_from.transpose() * weight;
    const Matrix3 to_w = error.by_to.transpose() * weight;
    if (from != kNone) {
        add_outer(h_, from, from_w, from, error.by_from);
        gradient_.segment<3>(from) += from_w * error.value;
    }
    if (to != kNone) {
        add_outer(h_, to, to_w, to, error.by_to);
        gradient_.segment<3>(to) += to_w * error.value;
    }
    if (from != kNone && to != kNone) {
        add_outer(h_, from, from_w, to, error.by_to);
        add_outer(h_, to, to_w, from, error.by_from);
    }
}

void GraphWindow::add(const Sighting& sighting, const LandmarkGraph& graph) {
    const SightingError error = graph.error_of(sighting);
    const double d2 = error.value.dot(sighting.information * error.value);
    objective_ += sighting.loss(d2);
    const Matrix2 weight = sighting.weight(d2) * sighting.information;
    const Eigen::Index landmark = at_[sighting.landmark];
    const Matrix2 landmark_w = error.by_landmark.transpose() * weight;
    add_outer(h_, landmark, landmark_w, landmark, error.by_landmark);
    gradient_.segment<2>(landmark) += landmark_w * error.value;
    const Eigen::Index key = of_key(sighting.key);
    if (key == kNone) return;
    const Eigen::Matrix<double, 3, 2> key_w = error.by_pose.transpose() * weight;
    add_outer(h_, key, key_w, key, error.by_pose);
    add_outer(h_, key, key_w, landmark, error.by_landmark);
    add_outer(h_, landmark, landmark_w, key, error.by_pose);
    gradient_.segment<3>(key) += key_w * error.value;
}

void GraphWindow::sum(const LandmarkGraph& graph) {
    h_.setZero();
    gradient_.setZero();
    objective_ = 0.0;
    for (std::size_t key = first_; key < keys_; ++key) {
        const Eigen::Index at = of_key(key);
        h_.diagonal().segment<3>(at).array() += kUntiedInformation;
        for (const std::uint32_t i : graph.edges_of(key)) {
            const PoseEdge& edge = graph.edges()[i];
            // An edge inside the window is met at both of its keys.
            if (std::max(edge.from, edge.to) == key || std::min(edge.from, edge.to) < first_) {
                add(edge, graph);
            }
        }
    }
    for (const std::uint32_t landmark : landmarks_) {
        for (const std::uint32_t i : graph.landmarks()[landmark].sightings) {
            add(graph.sightings()[i], graph);
        }
    }
}

void GraphWindow::solve(LandmarkGraph& graph) {
    lay_out(graph);
    for (const std::uint32_t landmark : landmarks_) graph.remeasure(landmark);
    covariance_ = Eigen::MatrixXd::Zero(h_.rows(), h_.cols());
    double objective = 0.0;
    double greatest = 0.0;
    LandmarkGraph::Places places;
    for (int iteration = 0; h_.rows() > 0; ++iteration) {
        sum(graph);
        bool last = iteration == kWindowSteps || (iteration > 0 && greatest < kStill);
        if (iteration > 0 && objective_ > objective) {  // as in GraphSolver
            graph.restore(places);
            sum(graph);
            last = true;
        }
        const Eigen::LLT<Eigen::MatrixXd> cholesky(h_);
        if (cholesky.info() != Eigen::Success) break;
        if (last) {
            covariance_ = cholesky.solve(Eigen::MatrixXd::Identity(h_.rows(), h_.cols()));
            break;
        }
        objective = objective_;
        places = graph.places();
        const Eigen::VectorXd step = -cholesky.solve(gradient_);
        greatest = 0.0;
        for (std::size_t key = first_; key < keys_; ++key) {
            const Eigen::Vector3d its = step.segment<3>(of_key(key));
            graph.pose(key) = shifted(graph.pose(key), its);
            greatest = std::max(greatest, std::abs(its(0)) + std::abs(its(1)));
        }
        for (const std::uint32_t landmark : landmarks_) {
            const Vector2 its = step.segment<2>(at_[landmark]);
            graph.move_landmark(landmark, its);
            greatest = std::max(greatest, std::abs(its(0)) + std::abs(its(1)));
        }
    }
    find_reachable(graph);
}

Matrix3 GraphWindow::key_covariance() const {
    if (keys_ <= first_) return Matrix3::Zero();
    const Eigen::Index at = of_key(keys_ - 1);
    return covariance_.block<3, 3>(at, at);
}

Matrix2 GraphWindow::landmark_covariance(const LandmarkGraph& graph, std::size_t landmark) const {
    const Eigen::Index at = of_landmark(landmark);
    if (at == kNone) return graph.covariance_given_poses(landmark);
    return covariance_.block<2, 2>(at, at);
}

Matrix23 GraphWindow::cross_covariance(std::size_t landmark) const {
    const Eigen::Index at = of_landmark(landmark);
    if (at == kNone || keys_ <= first_) return Matrix23::Zero();
    return covariance_.block<2, 3>(at, of_key(keys_ - 1));
}

Matrix2 GraphWindow::covariance(const LandmarkGraph& graph, std::size_t a, const Matrix2& j_a,
                                std::size_t b, const Matrix2& j_b) const {
    Matrix2 both = j_a * landmark_covariance(graph, a) * j_a.transpose() +
                   j_b * landmark_covariance(graph, b) * j_b.transpose();
    const Eigen::Index at_a = of_landmark(a);
    const Eigen::Index at_b = of_landmark(b);
    if (at_a != kNone && at_b != kNone) {
        const Matrix2 cross = j_a * covariance_.block<2, 2>(at_a, at_b) * j_b.transpose();
        both += cross + cross.transpose();
    }
    return both;
}

}  // namespace hitos
