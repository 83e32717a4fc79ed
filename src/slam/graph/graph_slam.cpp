// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_slam.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graph_merging.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/validate.hpp"
#include "hitos/slam/association_record.hpp"

namespace hitos {
namespace {

constexpr int kMergings = 2;            // rounds after a correction
constexpr double kMergingStill = 1e-2;  // [m]; whether landmarks are one hangs on more

/// d(compose(a, b))/da.
Matrix3 by_first(const Pose& a, const Pose& b) {
    Matrix3 j = Matrix3::Identity();
    j(0, 2) = -std::sin(a.theta) * b.x - std::cos(a.theta) * b.y;
    j(1, 2) = std::cos(a.theta) * b.x - std::sin(a.theta) * b.y;
    return j;
}

/// Covariance of compose(a, b), both with their own; b's in the axes of a.
Matrix3 composed(const Pose& a, const Matrix3& of_a, const Pose& b, const Matrix3& of_b) {
    const Matrix3 turn = turn_of(a.theta);
    const Matrix3 f = by_first(a, b);
    return f * of_a * f.transpose() + turn * of_b * turn.transpose();
}

}  // namespace

GraphSlam::GraphSlam(const FilterParams& params) : association_(params) {
    statistics_.neff = 1.0;
}

void GraphSlam::step(const SlamInput& input) {
    if (input.registered == nullptr) {
        throw ConfigError(
            "filter.algorithm",
            HITOS_TEXT("Errors", "graph-slam needs registration, and the run has none"));
    }
    const RegisteredStep& registered = *input.registered;
    // The first scan is where the world begins; there is no step to it.
    if (steps() > 0) {
        const Pose motion = between(registered.before, registered.pose);
        covariance_ = composed(pose_, covariance_, motion, registered.covariance);
        since_key_.covariance =
            composed(since_key_.pose, since_key_.covariance, motion, registered.covariance);
        since_key_.pose = compose(since_key_.pose, motion);
    } else {
        since_key_.pose = registered.pose;
    }
    const BelievedPose now = believed();
    pose_ = now.pose;
    if (input.record != nullptr) begin_record(*input.record);
    association_.find(graph_, window_, now, input.observation,
                      input.record == nullptr ? nullptr : &input.record->hypotheses.front());
    if (registered.key) add_key(registered, input.record);
    note_associations(registered.key);
    if (input.record != nullptr) end_record(*input.record);
    history_.push_back({graph_.keys().size(), since_key_.pose});
}

BelievedPose GraphSlam::believed() const {
    if (graph_.keys().empty()) return {since_key_.pose, since_key_.covariance, Matrix3::Zero()};
    const Pose& key = graph_.keys().back().pose;
    return {compose(key, since_key_.pose),
            composed(key, window_.key_covariance(), since_key_.pose, since_key_.covariance),
            by_first(key, since_key_.pose)};
}

void GraphSlam::add_key(const RegisteredStep& registered, AssociationRecord* record) {
    if (registered.keys.size() != graph_.keys().size() + 1) {
        throw std::logic_error("graph-slam missed keys of registration");
    }
    graph_.add_key({pose_, registered.scan});
    // Those of the key: where it shows that the robot was carried, earlier ones are gone, which the
    // correction tells.
    const std::size_t newest = registered.keys.size() - 1;
    const auto behind =
        std::ranges::find_if(registered.edges.rbegin(), registered.edges.rend(),
                             [newest](const PoseEdge& edge) { return edge.to != newest; });
    graph_.add_edges(
        registered.edges.last(static_cast<std::size_t>(behind - registered.edges.rbegin())));
    since_key_ = {};
    add_sightings();
    if (association_.closes()) GraphSolver().solve(graph_);
    window_.solve(graph_);
    merge_bridged(record);
    if constexpr (kValidates) check(graph_);
    pose_ = graph_.keys().back().pose;
    renew_covariance();
    map_.reset();
}

/// What landmarks seen again say of the pose is in the graph alone, and asking it costs as much as
/// solving it: the more keys there are, the more of them go by from one time to the next. Between
/// them it grows with the steps.
void GraphSlam::renew_covariance() {
    constexpr std::size_t kLeast = 8;
    constexpr std::size_t kPart = 8;
    const std::size_t keys = graph_.keys().size();
    if (keys < asked_ + std::max(kLeast, asked_ / kPart)) return;
    asked_ = keys;
    GraphSolver solver;
    if (solver.linearize(graph_)) covariance_ = solver.key_covariance(keys - 1);
}

void GraphSlam::add_sightings() {
    const auto key = static_cast<std::uint32_t>(graph_.keys().size() - 1);
    landmarks_of_.clear();
    for (const FoundFeature& feature : association_.found()) {
        std::int32_t landmark = -1;
        if (feature.outcome == Association::Outcome::matched) {
            landmark = static_cast<std::int32_t>(feature.landmark);
        } else if (feature.outcome == Association::Outcome::created) {
            if (feature.first < landmarks_of_.size()) {
                landmark = landmarks_of_[feature.first];  // a twin
            } else {
                for_kind(feature.kind, [&]<class S>() {
                    landmark = static_cast<std::int32_t>(graph_.add_landmark(
                        S::kKind, LocalCoordinates<S>::place(S::inverse(pose_, feature.measured.z)),
                        feature.measured.identity));
                });
            }
        }
        landmarks_of_.push_back(landmark);
        if (landmark < 0) continue;
        graph_.add({key, static_cast<std::uint32_t>(landmark), feature.measured.z,
                    feature.measured.r.inverse(), feature.low, feature.high,
                    feature.measured.identity != kNameless});
        graph_.name(static_cast<std::uint32_t>(landmark), feature.measured.identity);
    }
}

void GraphSlam::merge_bridged(AssociationRecord* record) {
    std::vector<std::uint32_t> leader(graph_.landmarks().size());
    for (std::uint32_t i = 0; i < leader.size(); ++i) leader[i] = i;
    bool any = false;
    for (const auto& [a, b] : association_.bridged()) {
        if (leader[a] != a || leader[b] != b) continue;
        const PlaceDifference apart = difference(graph_.landmarks()[a], graph_.landmarks()[b]);
        if (!is_none(apart, window_.covariance(graph_, a, apart.by_first, b, apart.by_second),
                     graph_.landmarks()[a].kind, association_.gate())) {
            continue;
        }
        leader[b] = a;
        any = true;
    }
    if (!any) return;
    merge(leader, record);
    window_.solve(graph_);
}

void GraphSlam::begin_record(AssociationRecord& record) const {
    record = {};
    record.hypotheses.resize(1);
    record.gate = association_.gate();
    record.new_gate = association_.new_gate();
}

void GraphSlam::end_record(AssociationRecord& record) const {
    const std::vector<std::int32_t> places = places_in_map();
    std::vector<RecordedFeature>& features = record.hypotheses.front();
    for (std::size_t i = 0; i < associations_.size(); ++i) {
        features[i].decision = associations_[i];
        for (ComparedLandmark& compared : features[i].compared) {
            compared.landmark = places[static_cast<std::size_t>(compared.landmark)];
        }
    }
}

void GraphSlam::merge(std::span<const std::uint32_t> leader, AssociationRecord* record) {
    const std::vector<std::uint32_t> now = graph_.merge(leader);
    if (record != nullptr) {
        for (RecordedFeature& feature : record->hypotheses.front()) {
            for (ComparedLandmark& compared : feature.compared) {
                compared.landmark =
                    static_cast<std::int32_t>(now[static_cast<std::size_t>(compared.landmark)]);
            }
        }
    }
    for (std::int32_t& landmark : landmarks_of_) {
        if (landmark >= 0) {
            landmark = static_cast<std::int32_t>(now[static_cast<std::size_t>(landmark)]);
        }
    }
}

std::vector<std::int32_t> GraphSlam::places_in_map() const {
    std::vector<std::int32_t> places(graph_.landmarks().size());
    std::int32_t next = 0;
    for_each_kind([&]<class S>() {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (graph_.landmarks()[i].kind == S::kKind) places[i] = next++;
        }
    });
    return places;
}

void GraphSlam::note_associations(bool key) {
    using Outcome = Association::Outcome;
    const std::vector<std::int32_t> places = places_in_map();
    associations_.clear();
    if (!key) landmarks_of_.clear();
    std::size_t i = 0;
    for (const FoundFeature& feature : association_.found()) {
        Association association{feature.kind, feature.observed, feature.outcome, feature.reason};
        if (feature.outcome == Outcome::matched) {
            statistics_.best_log_weight += feature.log_likelihood;
        } else if (feature.first != i && feature.outcome == Outcome::created) {
            association.outcome = Outcome::matched;
            association.reason = Association::Reason::twin;
        }
        if (!key) {
            // Only keys make landmarks.
            const bool matched = feature.outcome == Outcome::matched;
            if (feature.outcome == Outcome::created) {
                association.reason = Association::Reason::between_keys;
            }
            if (!matched) association.outcome = Outcome::ignored;
            landmarks_of_.push_back(matched ? static_cast<std::int32_t>(feature.landmark) : -1);
        }
        if (landmarks_of_[i] >= 0) {
            const auto landmark = static_cast<std::size_t>(landmarks_of_[i]);
            association.landmark = places[landmark];
            association.unseen = unseen(landmark, key);
        }
        associations_.push_back(association);
        ++i;
    }
}

/// Scans since a key saw the landmark, or since one before this scan where it is a key.
std::uint32_t GraphSlam::unseen(std::size_t landmark, bool key) const {
    const std::vector<std::uint32_t>& sightings = graph_.landmarks()[landmark].sightings;
    const std::size_t keys = graph_.keys().size() - (key ? 1 : 0);
    const auto seen = std::find_if(sightings.rbegin(), sightings.rend(), [&](std::uint32_t i) {
        return graph_.sightings()[i].key < keys;
    });
    if (seen == sightings.rend()) return 0;
    const KeyPose& seen_by = graph_.keys()[graph_.sightings()[*seen].key];
    return static_cast<std::uint32_t>(steps() - seen_by.scan);
}

std::size_t GraphSlam::bytes() const {
    return graph_.edges().size() * (sizeof(PoseEdge) + sizeof(std::uint32_t)) +
           graph_.sightings().size() * (sizeof(Sighting) + sizeof(std::uint32_t)) +
           graph_.keys().size() * sizeof(KeyPose) + history_.size() * sizeof(Placed) +
           graph_.landmarks().size() * sizeof(GraphLandmark);
}

void GraphSlam::correct(const PathCorrection& correction) {
    if (graph_.keys().empty()) return;
    if (correction.keys.size() != graph_.keys().size()) {
        throw std::logic_error("graph-slam missed keys of registration");
    }
    // Registration's solution is the start: keys are taken over, landmarks go with the key that saw
    // them last. What landmarks with names say of the path it knows nothing of.
    const bool named = std::ranges::any_of(graph_.landmarks(), [](const GraphLandmark& landmark) {
        return landmark.identity != kNameless;
    });
    for (std::size_t i = 0; !named && i < graph_.landmarks().size(); ++i) {
        const Sighting& last = graph_.sightings()[graph_.landmarks()[i].sightings.back()];
        graph_.transform_landmark(
            i, compose(correction.keys[last.key].pose, inverse(graph_.keys()[last.key].pose)));
    }
    for (std::size_t i = 0; !named && i < graph_.keys().size(); ++i) {
        graph_.pose(i) = correction.keys[i].pose;
    }
    graph_.replace_edges(correction.edges);
    for (std::size_t i = 0; i < graph_.landmarks().size(); ++i) graph_.remeasure(i);
    GraphSolver solver;
    bool solved = solver.solve(graph_, kMergingStill);
    for (int round = 0; solved && round < kMergings; ++round) {
        const auto leader =
            find_duplicates(graph_, association_.gate(),
                            [&](std::size_t a, const Matrix2& j_a, std::size_t b,
                                const Matrix2& j_b) { return solver.covariance(a, j_a, b, j_b); });
        if (!leader) break;
        merge(*leader);
        solved = solver.solve(graph_, kMergingStill);
    }
    solved = solved && solver.solve(graph_);
    if (solved) {
        covariance_ =
            composed(graph_.keys().back().pose, solver.key_covariance(graph_.keys().size() - 1),
                     since_key_.pose, since_key_.covariance);
    }
    window_.solve(graph_);
    if constexpr (kValidates) check(graph_);
    pose_ = compose(graph_.keys().back().pose, since_key_.pose);
    const std::vector<std::int32_t> places = places_in_map();
    for (std::size_t i = 0; i < associations_.size(); ++i) {
        if (landmarks_of_[i] >= 0) {
            associations_[i].landmark = places[static_cast<std::size_t>(landmarks_of_[i])];
        }
    }
    map_.reset();
}

LandmarkMap GraphSlam::best_map() const {
    if (map_) return *map_;
    GraphSolver solver;
    std::vector<Matrix2> covariances(graph_.landmarks().size(), Matrix2::Zero());
    if (solver.linearize(graph_)) covariances = solver.landmark_covariances();
    LandmarkMap map;
    for_each_kind([&]<class S>() {
        for (std::size_t i = 0; i < covariances.size(); ++i) {
            const GraphLandmark& landmark = graph_.landmarks()[i];
            if (landmark.kind != S::kKind) continue;
            const Matrix2 j = LocalCoordinates<S>::jacobian(landmark.place);
            LandmarkEstimate<S> estimate{LocalCoordinates<S>::landmark(landmark.place),
                                         j * covariances[i] * j.transpose()};
            normalize(estimate);
            Extent extent;  // from the line's foot
            if (S::kKind == FeatureKind::line) {
                extent = extent_along(LocalCoordinates<S>::place(estimate.mean), landmark);
            }
            const auto scan_of = [&](std::uint32_t sighting) {
                return static_cast<std::uint32_t>(
                    graph_.keys()[graph_.sightings()[sighting].key].scan);
            };
            map.push_back({estimate.mean, estimate.covariance,
                           static_cast<int>(landmark.sightings.size()), extent.low, extent.high,
                           scan_of(landmark.sightings.front()), scan_of(landmark.sightings.back()),
                           landmark.identity});
        }
    });
    map_ = map;
    return map;
}

std::vector<Pose> GraphSlam::best_history() const {
    std::vector<Pose> poses;
    poses.reserve(history_.size());
    for (const Placed& placed : history_) {
        poses.push_back(placed.keys == 0
                            ? placed.from_key
                            : compose(graph_.keys()[placed.keys - 1].pose, placed.from_key));
    }
    return poses;
}

SlamAlgorithmEntry graph_slam_algorithm() {
    SlamAlgorithmEntry entry;
    entry.word = "graph-slam";
    entry.label = HITOS_TEXT("ParameterChoice", "Graph-SLAM");
    entry.purpose = "registered poses and all landmarks as one least-squares problem";
    entry.reads = {"association.gate_probability", "association.new_probability"};
    entry.make = [](const FilterParams& params, std::uint64_t /*seed*/, int /*threads*/) {
        return std::make_unique<GraphSlam>(params);
    };
    entry.registered = true;
    return entry;
}

}  // namespace hitos
