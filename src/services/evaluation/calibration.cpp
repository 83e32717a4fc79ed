// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "hitos/services/evaluation/measures.hpp"
#include "hitos/slam/slam_filter.hpp"
#include "nearest_landmark.hpp"

namespace hitos {
namespace {

/// The landmark written as the other one of its kind is: of the two ways to write a line the
/// nearer.
ICaracteristica written_as(ICaracteristica landmark, const ICaracteristica& other) {
    if (auto* line = std::get_if<Recta>(&landmark.value)) {
        const double theta = std::get<Recta>(other.value).theta;
        if (std::abs(wrap_angle(line->theta - theta)) > kPi / 2.0) {
            *line = {-line->rho, line->theta + kPi};
            landmark.covariance(0, 1) *= -1.0;
            landmark.covariance(1, 0) *= -1.0;
        }
    }
    return landmark;
}

/// How far a landmark that is written as the other one is from it, in its own values.
Eigen::Vector2d error_of(const ICaracteristica& landmark, const ICaracteristica& other) {
    if (const auto* corner = std::get_if<Esquina>(&landmark.value)) {
        const auto& there = std::get<Esquina>(other.value);
        return {corner->x - there.x, corner->y - there.y};
    }
    const auto& line = std::get<Recta>(landmark.value);
    const auto& there = std::get<Recta>(other.value);
    return {line.rho - there.rho, wrap_angle(line.theta - there.theta)};
}

/// The landmark with values that lie so far from its own.
void shift(ICaracteristica& landmark, const Eigen::Vector2d& by) {
    if (auto* corner = std::get_if<Esquina>(&landmark.value)) {
        *corner = {corner->x + by.x(), corner->y + by.y()};
        return;
    }
    auto& line = std::get<Recta>(landmark.value);
    line.rho += by.x();
    line.theta += by.y();
}

}  // namespace

void for_each_hypothesis(const SlamFilter& filter, const LandmarkMap& best,
                         const std::function<void(const HypothesisMap&)>& visit) {
    const std::vector<WeightedPose> hypotheses = filter.hypotheses();
    const NearestLandmark here(best);
    for (std::size_t h = 0; h < hypotheses.size(); ++h) {
        if (hypotheses[h].weight <= 0.0) continue;
        HypothesisMap one{hypotheses[h].weight, filter.map(h), {}};
        const NearestLandmark there(one.map);
        const bool identities = have_identities(one.map, best);
        one.places.resize(best.size());
        for (std::size_t i = 0; i < best.size(); ++i) {
            const std::optional<std::size_t> near = there.of(best[i], identities);
            if (near && here.of(one.map[*near], identities) == i) one.places[i] = near;
        }
        visit(one);
    }
}

LandmarkMap mixed_map(const SlamFilter& filter) {
    LandmarkMap best = filter.best_map();
    if (filter.hypotheses().size() < 2) return best;
    // About the best one's values: of a line's angle there is no other mean.
    std::vector<Eigen::Vector2d> means(best.size(), Eigen::Vector2d::Zero());
    std::vector<Eigen::Matrix2d> squares(best.size(), Eigen::Matrix2d::Zero());
    std::vector<double> weights(best.size(), 0.0);
    for_each_hypothesis(filter, best, [&](const HypothesisMap& hypothesis) {
        const double weight = hypothesis.weight;
        for (std::size_t i = 0; i < best.size(); ++i) {
            if (!hypothesis.places[i]) continue;
            const ICaracteristica one = written_as(hypothesis.map[*hypothesis.places[i]], best[i]);
            const Eigen::Vector2d away = error_of(one, best[i]);
            means[i] += weight * away;
            squares[i] += weight * (one.covariance + away * away.transpose());
            weights[i] += weight;
        }
    });
    for (std::size_t i = 0; i < best.size(); ++i) {
        if (weights[i] <= 0.0) continue;
        const Eigen::Vector2d mean = means[i] / weights[i];
        best[i].covariance = squares[i] / weights[i] - mean * mean.transpose();
        shift(best[i], mean);
    }
    return best;
}

double chi_square_probability(double x, int degrees) {
    if (!(x > 0.0)) return 0.0;
    if (degrees == 1) return std::erf(std::sqrt(x / 2.0));
    if (degrees == 2) return -std::expm1(-x / 2.0);
    return std::erf(std::sqrt(x / 2.0)) -
           std::sqrt(2.0 * x / std::numbers::pi) * std::exp(-x / 2.0);
}

void Coverage::add(double squared) {
    ++count_;
    sum_ += squared;
    const double probability = chi_square_probability(squared, degrees_);
    for (std::size_t i = 0; i < kRegions.size(); ++i)
        inside_[i] += probability <= kRegions[i] ? 1 : 0;
}

void count_landmarks(Coverage& coverage, const LandmarkMap& map, const LandmarkMap& reference) {
    const NearestLandmark nearest(reference);
    const bool identities = have_identities(map, reference);
    for (const ICaracteristica& found : map) {
        const std::optional<std::size_t> place = nearest.of(found, identities);
        if (!place) continue;
        const ICaracteristica& truth = reference[*place];
        const ICaracteristica landmark = written_as(found, truth);
        const Eigen::LLT<Eigen::Matrix2d> root(landmark.covariance);
        if (root.info() != Eigen::Success) continue;
        const Eigen::Vector2d error = error_of(landmark, truth);
        const double squared = error.dot(root.solve(error));
        if (std::isfinite(squared)) coverage.add(squared);
    }
}

}  // namespace hitos
