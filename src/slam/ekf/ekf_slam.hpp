// SPDX-License-Identifier: GPL-3.0-or-later
// EKF-SLAM: one Gaussian over the pose and all landmarks [P 3-5].
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "association/association.hpp"
#include "association/map_correction.hpp"
#include "association/measurement.hpp"
#include "association/scan_twins.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/robot.hpp"
#include "joint_innovation.hpp"
#include "joint_state.hpp"
#include "pairing_sieve.hpp"

namespace hitos {

/// The extended Kalman filter over the joint state. One hypothesis, nothing drawn at random.
class EkfSlam final : public SlamFilter {
  public:
    explicit EkfSlam(const FilterParams& params);

    void step(const SlamInput& input) override;
    void correct(const PathCorrection& correction) override;
    std::unique_ptr<SlamFilter> clone() const override { return std::make_unique<EkfSlam>(*this); }
    std::size_t bytes() const override;

    std::uint64_t steps() const override { return history_.size(); }
    Pose best_pose() const override { return state_.pose(); }
    LandmarkMap best_map() const override;
    std::vector<Pose> best_history() const override { return history_; }
    int best_count(FeatureKind kind) const override;
    std::span<const Association> associations() const override { return associations_; }
    std::vector<WeightedPose> hypotheses() const override { return {{state_.pose(), 1.0}}; }
    FilterStatistics statistics() const override { return statistics_; }
    Matrix3 pose_covariance() const override { return state_.pose_covariance(); }

    Eigen::MatrixXd joint_covariance() const override;

    /// The joint covariance of pose and landmarks in the order of their creation; for tests.
    Eigen::MatrixXd covariance() const { return state_.covariance(); }

  private:
    /// A landmark's place in the joint state.
    struct Mark {
        Eigen::Index at = 0;
        LandmarkRecord record = {};
        Extent extent = {};
        Vector2 extent_of = Vector2::Zero();  ///< the estimate that the extent refers to
    };

    /// What a candidate of the joint search stands for.
    struct Found {
        std::uint32_t landmark = 0;
        double log_likelihood = 0.0;
    };

    using Marks = std::vector<Mark>;

    void predict(const MotionIncrement& increment);
    /// Features of a scan that is recorded; null where none is.
    using Recorded = std::vector<RecordedFeature>*;
    void begin_record(AssociationRecord& record) const;
    /// Adds the decisions; landmarks become places in the map.
    void end_record(AssociationRecord& record) const;
    /// Appends to associations_ and, where matched, to rows_.
    void associate(Recorded recorded);
    template <Sensor S>
    void associate(const Measurement& measured, std::uint32_t observed, Recorded recorded);
    /// The same for all observations of all kinds at once, by joint compatibility.
    void associate_together(Recorded recorded);
    /// Calls body(landmark of its kind, row, likelihood) for every landmark, or, where nothing is
    /// recorded, for every one that may lie inside a gate; what is recorded is of the newest
    /// feature. Returns the least squared distance, or anything beyond the gates.
    template <Sensor S, class Body>
    double compare(const Measurement& measured, Recorded recorded, const Body& body);
    /// The landmark of that identity; nothing where there is none.
    template <Sensor S>
    std::optional<std::size_t> identified(std::int32_t identity) const;
    /// Whether an observation is of no landmark; `nearest` is its least squared distance.
    template <Sensor S>
    bool is_new(double nearest) const;
    void match(Association& association, std::uint32_t landmark, const JointState::Row& row,
               double log_likelihood);
    void update();
    template <Sensor S>
    void add_new();
    /// Of new observations that are one landmark only the first stays new.
    void set_twins_aside();
    /// Updates new landmarks with those set aside.
    template <Sensor S>
    void update_new();
    void normalize_heading();
    /// Brings headings, angles and the signs of lines to normal form.
    void normalize();
    /// Notes which landmarks have been seen in this step, and where.
    void note_all_seen();
    template <Sensor S>
    void note_seen(Association& association);
    /// Moves the landmarks of a kind, their covariances left to the `turns` that it appends.
    template <Sensor S>
    void move(std::span<const Pose> by_scan, std::vector<JointState::Turn>& turns);
    /// Makes one landmark of those of a kind that are the same.
    template <Sensor S>
    NewPlaces merge();
    template <Sensor S>
    bool same(const Mark& a, const Mark& b) const;
    /// Makes the first landmark what both are together; the second is left to remove().
    template <Sensor S>
    void take_in(Mark& mark, const Mark& other);
    void remove(Eigen::Index at);
    /// The extent along the landmark as it is estimated now.
    template <Sensor S>
    Extent extent(const Mark& mark) const;
    /// Makes the landmarks of associations places in the map instead of places in their kind.
    void point_into_map();

    template <Sensor S>
    Marks& marks() {
        return marks_[LandmarkKinds::place<S>()];
    }
    template <Sensor S>
    const Marks& marks() const {
        return marks_[LandmarkKinds::place<S>()];
    }

    template <Sensor S>
    PairingSieve<S>& sieve() {
        return std::get<PairingSieve<S>>(sieves_);
    }

    FilterParams params_;
    std::shared_ptr<const Robot> robot_;
    bool registered_;  // the motion model follows registration, whose corrections move all
    AssociationRule rule_;
    ScanTwins twins_;
    double
        new_gate_;  ///< squared Mahalanobis distance beyond which an observation is of no landmark
    JointState state_;
    std::array<Marks, LandmarkKinds::kSize> marks_;
    std::vector<Pose> history_;
    std::vector<Association> associations_;
    FilterStatistics statistics_;
    // Working memory of a step.
    Measurements measurements_;
    KindRow<SeenReach> reaches_;
    LandmarkKinds::Tuple<PairingSieve> sieves_;
    std::vector<JointState::Row> rows_;
    std::vector<std::pair<std::size_t, std::size_t>> second_of_;  // twin set aside, its first
    JointSearch search_;
    std::vector<Found> found_;
    std::vector<JointState::Row> found_rows_;
};

/// "ekf-slam".
SlamAlgorithmEntry ekf_slam_algorithm();

}  // namespace hitos
