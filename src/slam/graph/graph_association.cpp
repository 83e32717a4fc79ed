// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_association.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

/// No landmark further off than this is evaluated: relative to the keys of the window no pose is as
/// uncertain [m, rad].
constexpr double kFarthest = 3.0;
constexpr double kMostTurned = 0.7;
/// Of a line whose points are not known: as far as any laser sees [m].
constexpr double kUnknownEnd = 1e3;
/// What an observation has to see of two lines to say that they are one [m], or of its own length.
constexpr double kBridged = 0.3;
constexpr double kBridgedPart = 0.25;

/// The ends of what was seen of a line, in the robot's frame.
std::pair<Point2, Point2> ends_of(const Observation& observation, const DetectedLine& line) {
    const PreparedRecta prepared(line.recta);
    if (line.count < 2) return {prepared.at(-kUnknownEnd), prepared.at(kUnknownEnd)};
    double low = kUnknownEnd;
    double high = -kUnknownEnd;
    for (const Point2& point : observation.support_of(line)) {
        low = std::min(low, prepared.along(point));
        high = std::max(high, prepared.along(point));
    }
    return {prepared.at(low), prepared.at(high)};
}

Extent seen_along(const LandmarkPlace& line, const Pose& pose, const FoundFeature& feature) {
    return extent_along(line, transform(pose, feature.low), transform(pose, feature.high));
}

}  // namespace

GraphAssociation::GraphAssociation(const FilterParams& params)
    : observation_(params.observation),
      known_association_(params.association.known),
      rule_(params.association),
      log_ratio_(std::log(params.association.ambiguity_ratio)),
      twins_(params.association, false),
      new_gate_(chi_square_gate(params.association.new_probability)) {}

void GraphAssociation::find(const LandmarkGraph& graph, const GraphWindow& window,
                            const BelievedPose& believed, const Observation& observation,
                            std::vector<RecordedFeature>* recorded) {
    measure(observation, observation_, measurements_, known_association_);
    closes_ = false;
    found_.clear();
    bridged_.clear();
    for_each_kind([&]<class S>() {
        std::uint32_t observed = 0;
        for (const Measurement& measured : measurements_.of<S>()) {
            FoundFeature feature;
            feature.kind = S::kKind;
            feature.observed = observed;
            feature.measured = measured;
            feature.first = found_.size();
            if constexpr (S::kKind == FeatureKind::line) {
                std::tie(feature.low, feature.high) =
                    ends_of(observation, observation.lines[observed]);
            }
            if (recorded != nullptr) recorded->emplace_back();
            find<S>(graph, window, believed, feature, recorded);
            found_.push_back(feature);
            ++observed;
        }
    });
    find_twins();
}

std::span<const std::uint32_t> GraphAssociation::compared(const LandmarkGraph& graph,
                                                          const GraphWindow& window,
                                                          const FoundFeature& feature) {
    const std::int32_t identity = feature.measured.identity;
    if (identity == kNameless) return window.reachable();
    known_.clear();
    const auto landmark = std::ranges::find(graph.landmarks(), identity, &GraphLandmark::identity);
    if (landmark == graph.landmarks().end()) return window.reachable();
    known_.push_back(static_cast<std::uint32_t>(landmark - graph.landmarks().begin()));
    closes_ = closes_ || !std::ranges::binary_search(window.reachable(), known_.front());
    return known_;
}

template <Sensor S>
void GraphAssociation::find(const LandmarkGraph& graph, const GraphWindow& window,
                            const BelievedPose& believed, FoundFeature& feature,
                            std::vector<RecordedFeature>* recorded) {
    BestTwo inside;  // of the landmarks whose gate it lies in, by distance
    inside_.clear();
    double nearest = std::numeric_limits<double>::infinity();
    const std::int32_t identity = feature.measured.identity;
    bool known = false;  // then nothing speaks against it
    for (const std::uint32_t i : compared(graph, window, feature)) {
        const GraphLandmark& landmark = graph.landmarks()[i];
        if (landmark.kind != S::kKind || !may_be_one(identity, landmark.identity)) continue;
        known = identity != kNameless && landmark.identity == identity;
        double shared_m = 0.0;
        double seen_m = 0.0;
        if constexpr (S::kKind == FeatureKind::line) {
            const double turn = feature.measured.z(1) + believed.pose.theta - landmark.place.angle;
            if (std::cos(turn) < std::cos(kMostTurned)) continue;
            const Extent seen = seen_along(landmark.place, believed.pose, feature);
            shared_m = -seen.gap(landmark.extent);
            seen_m = seen.length();
            if (shared_m < -kReach) continue;
        }
        const SightingError error = sighting_error(feature.measured.z, believed.pose, landmark);
        if (!known && std::abs(error.value(0)) > kFarthest) continue;
        const Matrix23 across = window.cross_covariance(i) * believed.by_key.transpose();
        const Matrix2 both = error.by_landmark * across * error.by_pose.transpose();
        const Matrix2 s = error.by_pose * believed.covariance * error.by_pose.transpose() +
                          error.by_landmark * window.landmark_covariance(graph, i) *
                              error.by_landmark.transpose() +
                          both + both.transpose() + feature.measured.r;
        const Likelihood close = likelihood_of(error.value, s);
        // Rounding can cost S its positivity where variances are next to nothing.
        if (!(s.determinant() > 0.0) || !(close.mahalanobis_squared >= 0.0)) continue;
        if (recorded != nullptr) {
            const bool fits = known || close.mahalanobis_squared <= rule_.gate();
            recorded->back().compared.push_back({static_cast<std::int32_t>(i), -error.value,
                                                 close.mahalanobis_squared, close.log_likelihood,
                                                 fits ? Standing::candidate : Standing::outside});
        }
        nearest = std::min(nearest, close.mahalanobis_squared);
        if (!known && close.mahalanobis_squared > rule_.gate()) continue;
        inside.offer(i, -close.mahalanobis_squared, close.log_likelihood);
        inside_.push_back({i, close.log_likelihood, shared_m, seen_m});
    }
    if (inside.none()) {
        // Where rounding leaves no comparison with its landmark, it is no new one either.
        if (nearest > new_gate_ && !known) {
            feature.outcome = Association::Outcome::created;
            feature.reason = Association::Reason::fits_none;
        }
    } else if (!rule_.ambiguous(inside)) {
        feature.outcome = Association::Outcome::matched;
        feature.reason = known ? Association::Reason::known : Association::Reason::fits;
        feature.landmark = inside.best();
        feature.log_likelihood = inside.best_log();
    } else {
        feature.reason = Association::Reason::ambiguous;
        if (S::kKind == FeatureKind::line) note_bridges(graph, inside);
    }
}

void GraphAssociation::note_bridges(const LandmarkGraph& graph, const BestTwo& inside) {
    const auto covered = [&](const Candidate& candidate) {
        const double length =
            std::min(candidate.seen_m, graph.landmarks()[candidate.landmark].extent.length());
        return candidate.shared_m >= std::min(kBridged, kBridgedPart * length);
    };
    const auto best = std::ranges::find(inside_, inside.best(), &Candidate::landmark);
    if (!covered(*best)) return;
    for (const Candidate& rival : inside_) {
        if (rival.landmark != best->landmark && covered(rival) &&
            rival.log_likelihood > best->log_likelihood + log_ratio_) {
            bridged_.emplace_back(std::min(best->landmark, rival.landmark),
                                  std::max(best->landmark, rival.landmark));
        }
    }
}

void GraphAssociation::find_twins() {
    twins_.find(measurements_);
    for (std::size_t i = 0; i < found_.size(); ++i) {
        FoundFeature& later = found_[i];
        if (later.outcome != Association::Outcome::created) continue;
        const auto twin = twins_.of(i, [&](std::size_t k) {
            const FoundFeature& earlier = found_[k];
            if (earlier.outcome != Association::Outcome::created || earlier.first != k) {
                return false;
            }
            if (later.kind != FeatureKind::line) return true;
            const LandmarkPlace line = LocalCoordinates<SensorRecta>::place(
                {earlier.measured.z(0), earlier.measured.z(1)});
            return extent_along(line, earlier.low, earlier.high)
                       .gap(extent_along(line, later.low, later.high)) <= kReach;
        });
        if (twin) later.first = *twin;
    }
}

}  // namespace hitos
