// SPDX-License-Identifier: GPL-3.0-or-later
// FastSLAM 1.0 [T ch. 3, tables 3.2 and 6.3].
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "association/association.hpp"
#include "association/free_space.hpp"
#include "association/joint_association.hpp"
#include "association/scan_twins.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/proposal.hpp"
#include "hitos/slam/resampler.hpp"
#include "models/map_store.hpp"
#include "particle_loop.hpp"
#include "pose_history.hpp"

namespace hitos {

/// One hypothesis: pose, weight, and handle of a pose history. Its map has its number.
struct Particula {
    Pose pose;
    double log_weight = 0.0;
    PoseHistory::Node history = PoseHistory::kNone;
    double weight_before = 1.0;  // normalised, before the last resampling
    std::uint32_t from = 0;      // its number then
};

/// The particle filter with one small EKF per landmark and particle.
class FiltroParticulas final : public SlamFilter {
  public:
    FiltroParticulas(const FilterParams& params, std::uint64_t seed, int threads);

    void step(const SlamInput& input) override;
    void correct(const PathCorrection& correction) override;
    std::unique_ptr<SlamFilter> clone() const override;
    std::size_t bytes() const override;

    std::uint64_t steps() const override { return steps_; }
    Pose best_pose() const override { return particles_[best_].pose; }
    LandmarkMap best_map() const override { return map(best_); }
    LandmarkMap map(std::size_t hypothesis) const override;
    std::vector<Pose> best_history() const override;
    int best_count(FeatureKind kind) const override;
    std::span<const Association> associations() const override { return associations_; }
    std::vector<WeightedPose> hypotheses() const override;
    std::vector<Pose> history(std::size_t hypothesis) const override {
        return history_.path(particles_[hypothesis].history);
    }
    std::size_t best_hypothesis() const override { return best_; }
    std::vector<HistoryBranch> ancestry() const override;
    FilterStatistics statistics() const override { return statistics_; }
    Matrix3 pose_covariance() const override;
    Pose mean_pose() const override;

    /// For tests and benchmarks: leaves of the maps and nodes held by histories.
    std::size_t map_leaves() const { return maps_.leaves(); }
    std::size_t history_nodes() const { return history_.size(); }
    /// Throws std::logic_error where histories or maps contradict themselves; builds that check
    /// (hitos/base/validate.hpp) do it after every step.
    void check_structures();

  private:
    /// What one of those that work at the same time needs to write maps and histories.
    struct Worker : MapStore::Worker {
        bool is_alone = true;
        std::vector<PoseHistory::Node> gone;  // of particles that nobody was drawn from
        std::vector<PoseHistory::Node> freed;
    };
    /// Particles whose places follow each other, on one worker.
    struct Block {
        std::size_t begin;
        std::size_t end;
        Worker& worker;
    };
    /// What a block works with, of each thread its own: memory, never a result.
    struct BlockMemory;
    static BlockMemory& block_memory();

    // A step, in the order of [T tables 3.2, 6.3].
    void propose(const SlamInput& input);
    void observe(const Observation& observation);
    void step_block(const Block& block, AssociationRecord* record);
    /// `watch` is Unwatched or Watched.
    template <class Watch>
    void associate(std::size_t place, std::span<Decision> decisions, const Watch& watch);
    /// The same for all observations at once.
    template <class Watch>
    void associate_together(std::size_t place, std::span<Decision> decisions, const Watch& watch);
    /// The same as associate() for a whole block, where every observation is decided alone.
    void associate_block(const Block& block, BlockMemory& memory);
    template <Sensor S>
    void find_near(const Block& block, BlockMemory& memory) const;
    template <Sensor S>
    void decide_block(const Block& block, std::size_t observation, BlockMemory& memory);
    /// Of two observations that claim one landmark leaves the likelier one to it.
    template <Sensor S>
    void exclude(std::span<Decision> decisions) const;
    void update_block(const Block& block, BlockMemory& memory);
    template <Sensor S>
    void update_block(const Block& block, std::size_t observation, BlockMemory& memory);
    /// Makes the landmark of an observation that is new; false where it is that of its twin.
    template <Sensor S>
    bool create(typename S::Columns& landmarks, const Pose& pose, std::size_t observation,
                std::span<Decision> decisions) const;
    void note_seen(LandmarkRecord& record, Decision& decision) const;
    /// Makes one landmark of bounded lines that have grown to meet; takes those out of the map that
    /// should be there and are not, and those that were not confirmed in time.
    /// What was `recorded` of the observations, if anything, follows.
    void review(std::size_t place, MapStore::Worker& worker, std::span<Decision> decisions,
                std::span<RecordedFeature> recorded);
    static void weigh(Particula& particle, std::span<const Decision> decisions);
    void choose_best();
    void resample();
    /// Those that were selected, with what they hold, take the places of all.
    void take_selected();
    /// Makes the block's particles copies of those that were selected.
    void draw(const Block& block);
    /// Gives them what only one can have, and lets go what nobody was drawn from.
    void let_go(const Block& block);
    /// Whether the one before was drawn from the same particle.
    bool drawn_again(std::size_t m) const { return m > 0 && selected_[m - 1] == selected_[m]; }
    /// Whether the map is a copy that resampling has just made of the one before it.
    bool just_copied(std::size_t m) const { return statistics_.resampled && drawn_again(m); }
    /// Calls body(i) for the particles that nobody was drawn from: those right before the one that
    /// a draw is of, for the draws from `begin` to `end`; with the last draw those behind it too.
    template <class Body>
    void for_each_passed_over(std::size_t begin, std::size_t end, const Body& body) const {
        for (std::size_t m = begin; m < end; ++m) {
            for (std::size_t i = m == 0 ? 0 : selected_[m - 1] + 1U; i < selected_[m]; ++i) body(i);
        }
        if (end < selected_.size()) return;
        for (std::size_t i = selected_.back() + 1U; i < particles_.size(); ++i) body(i);
    }

    // What a step needs besides.
    /// The landmarks of a kind in the map of a particle.
    template <Sensor S>
    typename S::Columns landmarks_of(std::size_t place, MapStore::Worker& worker) {
        return maps_.landmarks<S>(place, worker);
    }
    template <Sensor S>
    const typename S::Columns landmarks_of(
        std::size_t place) const {  // NOLINT(*-const-return-type)
        return maps_.landmarks<S>(place);
    }
    /// Decisions of a particle.
    std::span<Decision> decisions_of(std::size_t place) {
        return std::span(decisions_).subspan(place * seen_.size(), seen_.size());
    }
    /// Makes ready as many workers as blocks of `particles`, for work of that size.
    void begin_work(std::size_t particles, std::size_t work_each);
    /// Calls body(Block) for each block of as many particles.
    template <class Body>
    void for_each_block(std::size_t particles, std::size_t work_each, const Body& body) {
        begin_work(particles, work_each);
        for_each_(particles, work_each,
                  [&](std::size_t number, std::size_t begin, std::size_t end) {
                      body(Block{begin, end, workers_[number]});
                  });
    }
    /// What that particle, as it was before resampling, made of the scan: the best one's map is
    /// its.
    void note_associations(std::size_t source);
    /// Makes associations_ of what was noted: places in the map that is told.
    void publish_associations();
    /// Of each landmark of a kind its place in the map that is told, from `next` on, which moves
    /// on; -1 where it is not told.
    template <Sensor S>
    std::vector<std::int32_t> told(std::size_t particle, std::int32_t& next) const;
    void begin_record(AssociationRecord& record) const;
    /// Adds the decisions; landmarks become places in the map that is told.
    void end_record(AssociationRecord& record) const;
    /// Whether a landmark is told of: not while it is on probation.
    bool confirmed(const LandmarkRecord& record) const {
        return record.observations >= params_.landmarks.probation;
    }
    void remember_poses();

    FilterParams params_;
    std::uint64_t seed_;
    int threads_;
    std::unique_ptr<Proposal> proposal_;
    Associator associator_;
    ScanTwins twins_;
    std::unique_ptr<Resampler> resampler_;
    std::unique_ptr<ResamplingMethod> resampling_;
    bool registered_;  // the motion model follows registration, whose corrections move all
    bool heeds_extents_;
    bool identified_ = false;  // whether a feature of the scan says which landmark it is of
    bool one_by_one_;  // whether every observation is decided alone, by nothing but its candidates
    bool reviews_;     // whether landmarks may go
    ParticleLoop for_each_;

    std::vector<Particula> particles_;
    MapStore maps_;
    PoseHistory history_;
    std::size_t best_ = 0;
    std::uint64_t steps_ = 0;
    FilterStatistics statistics_;
    std::atomic<std::uint64_t> searches_cut_ = 0;  // counted on all threads
    std::vector<Association> noted_;  // of the best: landmarks by their places in their kind
    std::vector<Association> associations_;

    // Working memory of a step.
    Measurements measurements_;
    KindRow<SeenReach> reaches_;
    KindRow<SeenFeature> seen_;
    FreeSpace free_space_;
    std::vector<Decision> decisions_;  // observations of particle 0, of particle 1, …
    std::vector<double> log_weights_;
    std::vector<double> weights_;
    std::vector<std::uint32_t> selected_;
    std::vector<Particula> resampled_;
    std::vector<Worker> workers_;  // of every block
};

/// "fastslam".
SlamAlgorithmEntry fastslam_algorithm();

}  // namespace hitos
