// SPDX-License-Identifier: GPL-3.0-or-later
// The graph of graph-slam solved the slow way, to compare with.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "graph/landmark_graph.hpp"

namespace hitos {

/// (rho, theta) or (x, y).
inline Vector2 value_of(const ICaracteristica& landmark) {
    if (const auto* line = std::get_if<Recta>(&landmark.value)) return {line->rho, line->theta};
    const auto& corner = std::get<Esquina>(landmark.value);
    return {corner.x, corner.y};
}

/// Gauss-Newton with dense matrices and numerical Jacobians, lines as (rho, theta) in the world,
/// over the same poses, edges and sightings. Begins beside where the graph is.
class GraphOracle {
  public:
    explicit GraphOracle(const LandmarkGraph& graph) : graph_(graph) {
        const std::size_t keys = graph.keys().size();
        const std::size_t landmarks = graph.landmarks().size();
        poses_ = 3 * static_cast<Eigen::Index>(keys - 1);
        state_.resize(poses_ + 2 * static_cast<Eigen::Index>(landmarks));
        for (std::size_t i = 1; i < keys; ++i) {
            const Pose& pose = graph.keys()[i].pose;
            const double off = i % 2 == 0 ? 0.01 : -0.01;
            state_.segment<3>(at_key(i)) << pose.x + off, pose.y - off, pose.theta + 0.1 * off;
        }
        for (std::size_t i = 0; i < landmarks; ++i) {
            for_kind(graph.landmarks()[i].kind, [&]<class S>() {
                state_.segment<2>(at_landmark(i)) =
                    S::to_state(LocalCoordinates<S>::landmark(graph.landmarks()[i].place)) +
                    Vector2(0.01, -0.002);
            });
        }
    }

    void solve() {
        for (int iteration = 0; iteration < 40; ++iteration) {
            sum();
            state_ -= h_.ldlt().solve(gradient_);
        }
        sum();
        covariance_ = h_.inverse();
    }

    /// Lines first, then corners, in normal form.
    LandmarkMap map() const {
        LandmarkMap map;
        for_each_kind([&]<class S>() {
            for (std::size_t i = 0; i < graph_.landmarks().size(); ++i) {
                if (graph_.landmarks()[i].kind != S::kKind) continue;
                const Eigen::Index at = at_landmark(i);
                auto landmark = S::from_state(state_.segment<2>(at));
                Matrix2 covariance = covariance_.block<2, 2>(at, at);
                const double sign = S::normalize(landmark);
                covariance(0, 1) *= sign;
                covariance(1, 0) *= sign;
                map.push_back({landmark, covariance, 0});
            }
        });
        return map;
    }
    /// Of the newest key.
    Matrix3 pose_covariance() const { return covariance_.block<3, 3>(poses_ - 3, poses_ - 3); }

  private:
    static Eigen::Index at_key(std::size_t key) { return 3 * static_cast<Eigen::Index>(key) - 3; }
    Eigen::Index at_landmark(std::size_t landmark) const {
        return poses_ + 2 * static_cast<Eigen::Index>(landmark);
    }
    Pose pose(std::size_t key) const {
        if (key == 0) return graph_.keys()[0].pose;
        const auto its = state_.segment<3>(at_key(key));
        return {its(0), its(1), its(2)};
    }

    Eigen::VectorXd error_of(const PoseEdge& edge) const {
        const Pose way = between(pose(edge.from), pose(edge.to));
        return Eigen::Vector3d(way.x - edge.z.x, way.y - edge.z.y,
                               wrap_angle(way.theta - edge.z.theta));
    }
    Eigen::VectorXd error_of(const Sighting& sighting) const {
        Eigen::VectorXd error;
        for_kind(graph_.landmarks()[sighting.landmark].kind, [&]<class S>() {
            const auto landmark = S::from_state(state_.segment<2>(at_landmark(sighting.landmark)));
            error = -S::innovation(sighting.z, pose(sighting.key), landmark).nu;
        });
        return error;
    }

    /// Adds one error, which depends on the state's numbers at `places`.
    template <class Factor>
    void add(const Factor& factor, const std::vector<Eigen::Index>& places) {
        constexpr double kSmall = 1e-6;
        const Eigen::VectorXd error = error_of(factor);
        Eigen::MatrixXd j(error.size(), static_cast<Eigen::Index>(places.size()));
        Eigen::Index column = 0;
        for (const Eigen::Index place : places) {
            const double kept = state_(place);
            state_(place) = kept + kSmall;
            const Eigen::VectorXd ahead = error_of(factor);
            state_(place) = kept - kSmall;
            j.col(column++) = (ahead - error_of(factor)) / (2 * kSmall);
            state_(place) = kept;
        }
        const double d2 = error.dot(factor.information * error);
        const Eigen::MatrixXd weight = factor.information / (1.0 + d2 / 9.0);
        const Eigen::MatrixXd h = j.transpose() * weight * j;
        const Eigen::VectorXd b = j.transpose() * weight * error;
        for (Eigen::Index row = 0; row < h.rows(); ++row) {
            const Eigen::Index at = places[static_cast<std::size_t>(row)];
            for (Eigen::Index k = 0; k < h.cols(); ++k) {
                h_(at, places[static_cast<std::size_t>(k)]) += h(row, k);
            }
            gradient_(at) += b(row);
        }
    }
    void sum() {
        h_ = Eigen::MatrixXd::Zero(state_.size(), state_.size());
        gradient_ = Eigen::VectorXd::Zero(state_.size());
        const auto places = [&](std::size_t key, Eigen::Index more, int count) {
            std::vector<Eigen::Index> found;
            for (int c = 0; c < 3 && key > 0; ++c) found.push_back(at_key(key) + c);
            for (int c = 0; c < count; ++c) found.push_back(more + c);
            return found;
        };
        for (const PoseEdge& edge : graph_.edges()) {
            add(edge, places(edge.from, edge.to > 0 ? at_key(edge.to) : 0, edge.to > 0 ? 3 : 0));
        }
        for (const Sighting& sighting : graph_.sightings()) {
            add(sighting, places(sighting.key, at_landmark(sighting.landmark), 2));
        }
    }

    const LandmarkGraph& graph_;
    Eigen::Index poses_ = 0;
    Eigen::VectorXd state_;
    Eigen::MatrixXd h_;
    Eigen::VectorXd gradient_;
    Eigen::MatrixXd covariance_;
};

}  // namespace hitos
