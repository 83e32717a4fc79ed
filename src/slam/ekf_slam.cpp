#include "ekf_slam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hitos/slam/ekf.hpp"

namespace hitos {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Of a landmark that no observation is compared with.
constexpr Likelihood kNothing{-kNever, kNever};

/// Rounding can cost S its positivity where variances are next to nothing: no comparison then.
Likelihood compared(const Vector2& nu, const Matrix2& s) {
    const Likelihood likelihood = likelihood_of(nu, s);
    const double det = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
    return det > 0.0 && likelihood.mahalanobis_squared >= 0.0 ? likelihood : kNothing;
}

}  // namespace

EkfSlam::EkfSlam(const FilterParams& params)
    : params_(params),
      robot_(make_robot(params.motion)),
      gate_(chi_square_gate(params.association.gate_probability)),
      new_gate_(chi_square_gate(params.association.new_probability)) {
    statistics_.neff = 1.0;
}

void EkfSlam::step(const SlamInput& input) {
    predict(sum_controls(input.controls));
    measurements_.take(input.observation, params_.observation);
    associations_.clear();
    rows_.clear();
    associate<SensorRecta>(measurements_.lines, lines_);
    associate<SensorEsquina>(measurements_.corners, corners_);
    update();
    add_new<SensorRecta>(measurements_.lines, lines_);
    add_new<SensorEsquina>(measurements_.corners, corners_);
    normalize();
    // Places in the map are counted lines first, and lines may just have been added.
    for (Association& association : associations_) {
        if (association.kind == FeatureKind::corner && association.landmark >= 0) {
            association.landmark += best_count(FeatureKind::line);
        }
    }
    history_.push_back(state_.pose());
}

void EkfSlam::predict(const MotionIncrement& increment) {
    const Pose before = state_.pose();
    // At the first scan there is no step to be uncertain about, as in the particle filter.
    const Matrix3 noise =
        steps() == 0 ? Matrix3(Matrix3::Zero()) : robot_->noise_covariance(before, increment);
    state_.move(robot_->mean(before, increment), robot_->jacobian(before, increment), noise);
}

template <class S>
void EkfSlam::associate(std::span<const Measurement> measured, const std::vector<Mark>& marks) {
    const Pose pose = state_.pose();
    const Matrix3 pose_covariance = state_.pose_covariance();
    const bool may_be_ambiguous = params_.association.ambiguity != AmbiguityRule::off;
    const double log_ratio = std::log(params_.association.ambiguity_ratio);
    for (std::size_t k = 0; k < measured.size(); ++k) {
        Likelihood nearest = kNothing;
        Likelihood second = kNothing;
        JointState::Row row;
        std::size_t which = 0;
        bool comparable = marks.empty();
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const Eigen::Index at = marks[i].at;
            const auto landmark = S::from_state(state_.landmark(at));
            const JointInnovation seen = joint_innovation<S>(measured[k].z, pose, landmark);
            const Matrix23 cross = state_.cross_covariance(at);
            const Matrix23 hp = seen.by_pose * pose_covariance + seen.by_landmark * cross;
            const Matrix2 s = hp * seen.by_pose.transpose() +
                              (seen.by_pose * cross.transpose() +
                               seen.by_landmark * state_.landmark_covariance(at)) *
                                  seen.by_landmark.transpose() +
                              measured[k].r;
            const Likelihood close = compared(seen.nu, s);
            comparable = comparable || close.mahalanobis_squared < kNever;
            if (close.mahalanobis_squared < nearest.mahalanobis_squared) {
                second = nearest;
                nearest = close;
                which = i;
                row = {at, seen.nu, seen.by_pose, seen.by_landmark, measured[k].r};
            } else if (close.mahalanobis_squared < second.mahalanobis_squared) {
                second = close;
            }
        }
        Association association;
        association.kind = S::kKind;
        association.observed = static_cast<std::uint32_t>(k);
        const bool ambiguous = may_be_ambiguous && second.mahalanobis_squared <= gate_ &&
                               second.log_likelihood > nearest.log_likelihood + log_ratio;
        if (nearest.mahalanobis_squared <= gate_ && !ambiguous) {
            association.outcome = Association::Outcome::matched;
            association.landmark = static_cast<std::int32_t>(which);
            rows_.push_back(row);
            statistics_.best_log_weight += nearest.log_likelihood;
        } else if (comparable && nearest.mahalanobis_squared > new_gate_) {
            association.outcome = Association::Outcome::created;
        }
        associations_.push_back(association);
    }
}

void EkfSlam::update() {
    state_.update(rows_);
    for (const Association& association : associations_) {
        if (association.outcome != Association::Outcome::matched) continue;
        auto& marks = association.kind == FeatureKind::line ? lines_ : corners_;
        ++marks[static_cast<std::size_t>(association.landmark)].observations;
    }
    normalize();
}

template <class S>
void EkfSlam::add_new(std::span<const Measurement> measured, std::vector<Mark>& marks) {
    const Pose pose = state_.pose();
    for (Association& association : associations_) {
        if (association.kind != S::kKind || association.outcome != Association::Outcome::created) {
            continue;
        }
        const Measurement& seen = measured[association.observed];
        const Matrix2 by_z = S::inverse_jacobian(pose, seen.z);
        const Eigen::Index at =
            state_.append(S::to_state(S::inverse(pose, seen.z)),
                          S::inverse_pose_jacobian(pose, seen.z), by_z * seen.r * by_z.transpose());
        association.landmark = static_cast<std::int32_t>(marks.size());
        marks.push_back({at, 1});
    }
}

void EkfSlam::normalize() {
    state_.set_heading(wrap_angle(state_.pose().theta));
    for (const Mark& mark : lines_) {
        const Recta line = SensorRecta::from_state(state_.landmark(mark.at));
        if (line.rho < 0.0) state_.negate(mark.at);
        state_.set_landmark(mark.at, SensorRecta::to_state(normalized(line)));
    }
}

LandmarkMap EkfSlam::best_map() const {
    LandmarkMap map;
    map.reserve(lines_.size() + corners_.size());
    const auto add = [&](const Mark& mark, const auto& value) {
        map.push_back({value, state_.landmark_covariance(mark.at), mark.observations});
    };
    for (const Mark& mark : lines_) {
        add(mark, SensorRecta::from_state(state_.landmark(mark.at)));
    }
    for (const Mark& mark : corners_) {
        add(mark, SensorEsquina::from_state(state_.landmark(mark.at)));
    }
    return map;
}

SlamAlgorithmEntry ekf_slam_algorithm() {
    SlamAlgorithmEntry entry;
    entry.word = "ekf-slam";
    entry.label = HITOS_TEXT("ParameterChoice", "EKF-SLAM");
    entry.purpose = "one extended Kalman filter over the pose and all landmarks";
    entry.reads = {"association.gate_probability", "association.new_probability"};
    entry.make = [](const FilterParams& params, std::uint64_t /*seed*/, int /*threads*/) {
        return std::make_unique<EkfSlam>(params);
    };
    return entry;
}

}  // namespace hitos
