// SPDX-License-Identifier: GPL-3.0-or-later
// graph-slam: key poses and landmarks as one least-squares problem.
#pragma once

#include <optional>
#include <vector>

#include "graph_association.hpp"
#include "graph_solver.hpp"
#include "hitos/slam/filters.hpp"

namespace hitos {

/// Poses of registration's keys and the landmarks that their scans show, in one graph: from scan to
/// scan its newest part is solved, after a correction the whole. One hypothesis, nothing drawn at
/// random. Needs SlamInput::registered.
class GraphSlam final : public SlamFilter {
  public:
    explicit GraphSlam(const FilterParams& params);

    /// Throws ConfigError where the run has no registration.
    void step(const SlamInput& input) override;
    void correct(const PathCorrection& correction) override;
    std::unique_ptr<SlamFilter> clone() const override {
        return std::make_unique<GraphSlam>(*this);
    }
    std::size_t bytes() const override;

    std::uint64_t steps() const override { return history_.size(); }
    Pose best_pose() const override { return pose_; }
    /// Sets up the whole graph once more for the covariances, unless nothing changed since.
    LandmarkMap best_map() const override;
    std::vector<Pose> best_history() const override;
    int best_count(FeatureKind kind) const override { return graph_.count(kind); }
    std::span<const Association> associations() const override { return associations_; }
    std::vector<WeightedPose> hypotheses() const override { return {{pose_, 1.0}}; }
    FilterStatistics statistics() const override { return statistics_; }
    /// That of the newest key after the last solution of the whole graph, in the frame of the
    /// first, and what the steps since have added.
    Matrix3 pose_covariance() const override { return covariance_; }

    const LandmarkGraph& graph() const { return graph_; }

  private:
    /// A motion from a known frame on, with its covariance in that frame's axes.
    struct Motion {
        Pose pose;
        Matrix3 covariance = Matrix3::Zero();
    };
    /// A scan's pose, from its key on; or where there was no key yet from the origin.
    struct Placed {
        std::size_t keys = 0;  ///< so far; the last of them is the scan's
        Pose from_key;
    };

    BelievedPose believed() const;
    /// Makes the scan the newest key, with what it saw.
    void add_key(const RegisteredStep& registered, AssociationRecord* record);
    void add_sightings();
    void renew_covariance();
    /// Merges landmarks that the scan has shown to be one.
    void merge_bridged(AssociationRecord* record);
    void merge(std::span<const std::uint32_t> leader, AssociationRecord* record = nullptr);
    void note_associations(bool key);
    void begin_record(AssociationRecord& record) const;
    /// Adds the decisions; landmarks become places in the map.
    void end_record(AssociationRecord& record) const;
    std::uint32_t unseen(std::size_t landmark, bool key) const;
    /// Places of landmarks in the map, which lists them kind by kind.
    std::vector<std::int32_t> places_in_map() const;

    GraphAssociation association_;
    LandmarkGraph graph_;
    GraphWindow window_;
    Pose pose_;
    Matrix3 covariance_ = Matrix3::Zero();
    std::size_t asked_ = 0;  // keys when the whole graph was last asked for it
    Motion since_key_;
    std::vector<Placed> history_;
    std::vector<Association> associations_;
    std::vector<std::int32_t> landmarks_of_;  // of the graph, by association; -1: none
    FilterStatistics statistics_;
    mutable std::optional<LandmarkMap> map_;  // while nothing has changed
};

/// "graph-slam".
SlamAlgorithmEntry graph_slam_algorithm();

}  // namespace hitos
