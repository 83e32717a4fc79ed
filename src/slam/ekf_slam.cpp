#include "ekf_slam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace hitos {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Of a landmark that no observation is compared with.
constexpr Likelihood kNothing{-kNever, kNever};

/// Rounding can cost S its positivity where variances are next to nothing: no comparison then.
Likelihood compared(const Vector2& nu, const Matrix2& s) {
    const Likelihood likelihood = likelihood_of(nu, s);
    return s.determinant() > 0.0 && likelihood.mahalanobis_squared >= 0.0 ? likelihood : kNothing;
}

}  // namespace

EkfSlam::EkfSlam(const FilterParams& params)
    : params_(params),
      robot_(make_robot(params.motion)),
      rule_(params.association),
      new_gate_(chi_square_gate(params.association.new_probability)) {
    statistics_.neff = 1.0;
}

void EkfSlam::step(const SlamInput& input) {
    predict(sum_controls(input.controls));
    measure(input.observation, params_.observation, measurements_);
    associations_.clear();
    rows_.clear();
    for_each_kind([&]<class S>() { associate<S>(); });
    update();
    for_each_kind([&]<class S>() { add_new<S>(); });
    normalize();
    point_into_map();
    history_.push_back(state_.pose());
}

void EkfSlam::predict(const MotionIncrement& increment) {
    const Pose before = state_.pose();
    // At the first scan there is no step to be uncertain about, as in the particle filter.
    const Matrix3 noise =
        steps() == 0 ? Matrix3(Matrix3::Zero()) : robot_->noise_covariance(before, increment);
    state_.move(robot_->mean(before, increment), robot_->jacobian(before, increment), noise);
}

template <Sensor S>
void EkfSlam::associate() {
    std::uint32_t observed = 0;
    for (const Measurement& measured : measurements_.of<S>()) associate<S>(measured, observed++);
}

template <Sensor S>
void EkfSlam::associate(const Measurement& measured, std::uint32_t observed) {
    const Pose pose = state_.pose();
    const Matrix3 pose_covariance = state_.pose_covariance();
    BestTwo inside;  // of the landmarks whose gate it lies in, by distance
    double nearest = kNever;
    JointState::Row row;
    for (std::size_t i = 0; i < marks<S>().size(); ++i) {
        const Eigen::Index at = marks<S>()[i].at;
        const JointInnovation seen =
            S::joint_innovation(measured.z, pose, S::from_state(state_.landmark(at)));
        const Matrix23 cross = state_.cross_covariance(at);
        const Matrix23 hp = seen.by_pose * pose_covariance + seen.by_landmark * cross;
        const Matrix2 s =
            hp * seen.by_pose.transpose() +
            (seen.by_pose * cross.transpose() + seen.by_landmark * state_.landmark_covariance(at)) *
                seen.by_landmark.transpose() +
            measured.r;
        const Likelihood close = compared(seen.nu, s);
        const double distance = close.mahalanobis_squared;
        nearest = std::min(nearest, distance);
        if (distance <= rule_.gate() &&
            inside.offer(static_cast<std::uint32_t>(i), -distance, close.log_likelihood)) {
            row = {at, seen.nu, seen.by_pose, seen.by_landmark, measured.r};
        }
    }
    Association association{S::kKind, observed};
    // Where no comparison was possible nothing is known, and so nothing is new.
    const bool comparable = marks<S>().empty() || nearest < kNever;
    if (!inside.none() && !rule_.ambiguous(inside)) {
        association.outcome = Association::Outcome::matched;
        association.landmark = static_cast<std::int32_t>(inside.best());
        rows_.push_back(row);
        statistics_.best_log_weight += inside.best_log();
    } else if (comparable && nearest > new_gate_) {
        association.outcome = Association::Outcome::created;
    }
    associations_.push_back(association);
}

void EkfSlam::update() {
    state_.update(rows_);
    for_each_kind([&]<class S>() {
        for (const Association& association : associations_) {
            if (association.kind == S::kKind &&
                association.outcome == Association::Outcome::matched) {
                ++marks<S>()[static_cast<std::size_t>(association.landmark)].observations;
            }
        }
    });
    normalize();
}

template <Sensor S>
void EkfSlam::add_new() {
    const Pose pose = state_.pose();
    for (Association& association : associations_) {
        if (association.kind != S::kKind || association.outcome != Association::Outcome::created) {
            continue;
        }
        const Measurement& seen = measurements_.of<S>()[association.observed];
        const Matrix2 by_z = S::inverse_jacobian(pose, seen.z);
        const Eigen::Index at =
            state_.append(S::to_state(S::inverse(pose, seen.z)),
                          S::inverse_pose_jacobian(pose, seen.z), by_z * seen.r * by_z.transpose());
        association.landmark = static_cast<std::int32_t>(marks<S>().size());
        marks<S>().push_back({at, 1});
    }
}

void EkfSlam::normalize() {
    state_.set_heading(wrap_angle(state_.pose().theta));
    for_each_kind([&]<class S>() {
        for (const Mark& mark : marks<S>()) {
            auto landmark = S::from_state(state_.landmark(mark.at));
            if (S::normalize(landmark) < 0.0) state_.negate(mark.at);
            state_.set_landmark(mark.at, S::to_state(landmark));
        }
    });
}

void EkfSlam::point_into_map() {
    std::int32_t before = 0;  // landmarks of the kinds before, which come first in the map
    for_each_kind([&]<class S>() {
        for (Association& association : associations_) {
            if (association.kind == S::kKind && association.landmark >= 0) {
                association.landmark += before;
            }
        }
        before += static_cast<std::int32_t>(marks<S>().size());
    });
}

int EkfSlam::best_count(FeatureKind kind) const {
    std::size_t count = 0;
    for_each_kind([&]<class S>() {
        if (S::kKind == kind) count += marks<S>().size();
    });
    return static_cast<int>(count);
}

LandmarkMap EkfSlam::best_map() const {
    LandmarkMap map;
    for_each_kind([&]<class S>() {
        for (const Mark& mark : marks<S>()) {
            map.push_back({S::from_state(state_.landmark(mark.at)),
                           state_.landmark_covariance(mark.at), mark.observations});
        }
    });
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
