// SPDX-License-Identifier: GPL-3.0-or-later
// What every SLAM algorithm of Hitos offers to the services.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hitos/features/caracteristica.hpp"
#include "hitos/features/control.hpp"
#include "hitos/features/observation.hpp"
#include "hitos/registration/registered_step.hpp"

namespace hitos {

/// What became of one observed feature in the best hypothesis.
struct Association {
    enum class Outcome : std::uint8_t { matched, created, ignored };
    /// Why.
    enum class Reason : std::uint8_t {
        fits,           ///< matched: one landmark fits, no other is plausible
        stretches,      ///< matched: all that fit are stretches of one wall
        together,       ///< matched: of the pairings that fit best together
        twin,           ///< matched: with what an earlier feature of the scan made
        known,          ///< matched: it says which landmark it is
        drawn,          ///< matched or created: drawn from all that are plausible
        fits_none,      ///< created: no landmark fits
        ambiguous,      ///< ignored: several landmarks are plausible
        taken,          ///< ignored: another feature fits its landmark better
        left_over,      ///< ignored: others fit its landmarks better together
        between_gates,  ///< ignored: fits no landmark, but is not far enough from all to be new
        between_keys,   ///< ignored: fits no landmark, and only key scans make new ones
        gone            ///< ignored: its landmark was taken out of the map
    };
    FeatureKind kind = FeatureKind::line;
    std::uint32_t observed = 0;  ///< index among the lines or corners of the observation
    Outcome outcome = Outcome::ignored;
    Reason reason = Reason::between_gates;
    std::int32_t landmark = -1;  ///< index in best_map(); -1 where ignored
    /// Scans since the landmark was seen before; 0 where this scan made it, or nothing was matched.
    std::uint32_t unseen = 0;
};

/// A hypothesis of the robot's pose with its normalised weight.
struct WeightedPose {
    Pose pose;
    double weight = 0.0;
    double weight_before = 1.0;  ///< before the last resampling, of the one that it was drawn from
    std::uint32_t from = 0;      ///< the number that this one had then
};

/// A stretch without a fork of the tree that the hypotheses' histories are.
struct HistoryBranch {
    std::vector<Pose> poses;  ///< from the fork or the first scan to the next fork or the newest
    std::uint32_t particles = 0;  ///< hypotheses that have it behind them
    std::uint64_t first = 0;      ///< scan of its first pose, from 0
};

/// Of the last step, where nothing else is said.
struct FilterStatistics {
    double neff = 0.0;             ///< effective particles before resampling [T eq 6.14]
    double best_log_weight = 0.0;  ///< ln of the best weight before resampling, not normalised
    /// Joint associations so far, of all hypotheses, whose search was cut before it had seen all.
    std::uint64_t searches_cut = 0;
    bool resampled = false;     ///< in the last step
    bool best_changed = false;  ///< the best one is no continuation of the best one before
};

/// What a step weighed (hitos/slam/association_record.hpp).
struct AssociationRecord;

/// What a step takes: the scan, the controls from the scan before to this one, and what was found
/// in the scan, in the robot frame.
struct SlamInput {
    const Scan& scan;
    std::span<const Control> controls;
    const Observation& observation;
    /// Where registration places the scan; null where the run has none.
    const RegisteredStep* registered = nullptr;
    /// Takes what the step weighs; null where nobody asks, and then it costs nothing.
    AssociationRecord* record = nullptr;
};

/// One algorithm, fed step by step.
class SlamFilter {
  public:
    virtual ~SlamFilter() = default;

    /// One scan. Deterministic: the result depends on the seed, not on the number of threads.
    virtual void step(const SlamInput& input) = 0;
    /// Registration moved the path behind, after the last step. An algorithm that takes its motion
    /// from registration moves every pose and landmark along.
    virtual void correct(const PathCorrection& /*correction*/) {}

    /// The same state, to go on from independently: what a step gives afterwards is the same in
    /// both, to the last bit. An algorithm that cannot be copied gives nothing; then a run of it
    /// goes back by beginning anew.
    virtual std::unique_ptr<SlamFilter> clone() const { return nullptr; }
    /// Memory that a clone takes, about.
    virtual std::size_t bytes() const { return 0; }

    virtual std::uint64_t steps() const = 0;
    /// The best hypothesis (greatest weight before resampling): pose in the world, map (lines
    /// first, then corners) and its pose at every scan so far.
    virtual Pose best_pose() const = 0;
    virtual LandmarkMap best_map() const = 0;
    virtual std::vector<Pose> best_history() const = 0;
    /// Landmarks of the best hypothesis without building its map.
    virtual int best_count(FeatureKind kind) const = 0;
    /// What the best hypothesis made of the last observation.
    virtual std::span<const Association> associations() const = 0;
    /// All hypotheses, after resampling.
    virtual std::vector<WeightedPose> hypotheses() const = 0;
    /// The poses of one of hypotheses() at every scan so far. An algorithm that has a single one
    /// need not say more than this does.
    virtual std::vector<Pose> history(std::size_t /*hypothesis*/) const { return best_history(); }
    /// Its map, likewise.
    virtual LandmarkMap map(std::size_t /*hypothesis*/) const { return best_map(); }
    /// The place of the best one in hypotheses().
    virtual std::size_t best_hypothesis() const { return 0; }
    /// The histories of all hypotheses as the trees that they are, the oldest branches first.
    virtual std::vector<HistoryBranch> ancestry() const { return {{best_history(), 1}}; }
    virtual FilterStatistics statistics() const = 0;
    /// Covariance of (x, y, theta) [m, m, rad]: the filter's own, or that of its hypotheses.
    virtual Eigen::Matrix3d pose_covariance() const = 0;
    /// What it is about: the mean of all hypotheses.
    virtual Pose mean_pose() const { return best_pose(); }
    /// Covariance of pose and landmarks together: of (x, y, theta), then of the two values of every
    /// landmark of best_map(), in its order. 0 x 0 where the algorithm keeps none.
    virtual Eigen::MatrixXd joint_covariance() const { return {}; }
};

}  // namespace hitos
