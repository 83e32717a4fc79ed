// EKF-SLAM: one Gaussian over the pose and all landmarks [P 3-5].
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hitos/slam/filters.hpp"
#include "hitos/slam/robot.hpp"
#include "joint_state.hpp"
#include "measurement.hpp"

namespace hitos {

/// The extended Kalman filter over the joint state. One hypothesis, nothing drawn at random.
class EkfSlam final : public SlamFilter {
  public:
    explicit EkfSlam(const FilterParams& params);

    void step(const SlamInput& input) override;

    std::uint64_t steps() const override { return history_.size(); }
    Pose best_pose() const override { return state_.pose(); }
    LandmarkMap best_map() const override;
    std::vector<Pose> best_history() const override { return history_; }
    int best_count(FeatureKind kind) const override {
        return static_cast<int>(kind == FeatureKind::line ? lines_.size() : corners_.size());
    }
    std::span<const Association> associations() const override { return associations_; }
    std::vector<WeightedPose> hypotheses() const override { return {{state_.pose(), 1.0}}; }
    FilterStatistics statistics() const override { return statistics_; }
    Matrix3 pose_covariance() const override { return state_.pose_covariance(); }

    /// The joint covariance of pose and landmarks in the order of their creation; for tests.
    Eigen::MatrixXd covariance() const { return state_.covariance(); }

  private:
    /// A landmark's place in the joint state.
    struct Mark {
        Eigen::Index at = 0;
        int observations = 0;
    };

    void predict(const MotionIncrement& increment);
    /// Appends to associations_ and, where matched, to rows_.
    template <class S>
    void associate(std::span<const Measurement> measured, const std::vector<Mark>& marks);
    void update();
    template <class S>
    void add_new(std::span<const Measurement> measured, std::vector<Mark>& marks);
    /// Brings headings, angles and the signs of lines to normal form.
    void normalize();

    FilterParams params_;
    std::shared_ptr<const Robot> robot_;
    double gate_;      ///< squared Mahalanobis distance within which an observation is a landmark's
    double new_gate_;  ///< and beyond which it is of none
    JointState state_;
    std::vector<Mark> lines_;
    std::vector<Mark> corners_;
    std::vector<Pose> history_;
    std::vector<Association> associations_;
    FilterStatistics statistics_;
    // Working memory of a step.
    Measurements measurements_;
    std::vector<JointState::Row> rows_;
};

/// "ekf-slam".
SlamAlgorithmEntry ekf_slam_algorithm();

}  // namespace hitos
