// SPDX-License-Identifier: GPL-3.0-or-later
#include "ekf_slam.hpp"

#include <algorithm>

namespace hitos {
EkfSlam::EkfSlam(const FilterParams& params)
    : params_(params),
      robot_(make_robot(params.motion)),
      registered_(motion_models().find(params.motion.model).registered),
      rule_(params.association),
      twins_(params.association, false),
      new_gate_(chi_square_gate(params.association.new_probability)) {
    statistics_.neff = 1.0;
}

void EkfSlam::step(const SlamInput& input) {
    predict(motion_increment(input));
    measure(input.observation, params_.observation, measurements_, params_.association.known);
    if (registered_) note_reaches(input.observation, false, reaches_);
    associations_.clear();
    rows_.clear();
    if (input.record != nullptr) begin_record(*input.record);
    std::vector<RecordedFeature>* const recorded =
        input.record == nullptr ? nullptr : &input.record->hypotheses.front();
    associate(recorded);
    set_twins_aside();
    update();
    for_each_kind([&]<class S>() { add_new<S>(); });
    for_each_kind([&]<class S>() { update_new<S>(); });
    if (std::ranges::any_of(associations_, [](const Association& association) {
            return association.outcome == Association::Outcome::created;
        })) {
        normalize();
    }
    note_all_seen();
    point_into_map();
    if (input.record != nullptr) end_record(*input.record);
    history_.push_back(state_.pose());
}

void EkfSlam::predict(const MotionIncrement& increment) {
    const Pose before = state_.pose();
    // At the first scan there is no step to be uncertain about, as in the particle filter.
    const Matrix3 noise =
        steps() == 0 ? Matrix3(Matrix3::Zero()) : robot_->noise_covariance(before, increment);
    state_.move(robot_->mean(before, increment), robot_->jacobian(before, increment), noise);
}

void EkfSlam::begin_record(AssociationRecord& record) const {
    record = {};
    record.hypotheses.resize(1);
    record.gate = rule_.gate();
    record.new_gate = new_gate_;
}

void EkfSlam::update() {
    state_.update(rows_);
    if (rows_.empty()) {
        normalize_heading();
    } else {
        normalize();
    }
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
        marks<S>().push_back({at});
    }
}

void EkfSlam::set_twins_aside() {
    twins_.find(measurements_);
    second_of_.clear();
    const auto is_new = [&](std::size_t i) {
        return associations_[i].outcome == Association::Outcome::created;
    };
    for (std::size_t i = 0; i < associations_.size(); ++i) {
        const auto twin = is_new(i) ? twins_.of(i, is_new) : std::nullopt;
        if (!twin) continue;
        second_of_.emplace_back(i, *twin);
        associations_[i].outcome = Association::Outcome::ignored;
    }
}

template <Sensor S>
void EkfSlam::update_new() {
    rows_.clear();
    for (const auto& [second, first] : second_of_) {
        Association& association = associations_[second];
        if (association.kind != S::kKind) continue;
        association.outcome = Association::Outcome::matched;
        association.reason = Association::Reason::twin;
        association.landmark = associations_[first].landmark;
        const Mark& mark = marks<S>()[static_cast<std::size_t>(association.landmark)];
        const Measurement& seen = measurements_.of<S>()[association.observed];
        const JointInnovation innovation =
            S::joint_innovation(seen.z, state_.pose(), S::from_state(state_.landmark(mark.at)));
        rows_.push_back(
            {mark.at, innovation.nu, innovation.by_pose, innovation.by_landmark, seen.r});
    }
    state_.update(rows_);
}

void EkfSlam::normalize_heading() {
    state_.set_heading(wrap_angle(state_.pose().theta));
}

void EkfSlam::normalize() {
    normalize_heading();
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

void EkfSlam::end_record(AssociationRecord& record) const {
    std::vector<RecordedFeature>& features = record.hypotheses.front();
    for (std::size_t i = 0; i < associations_.size(); ++i) {
        features[i].decision = associations_[i];
        std::size_t before = 0;  // landmarks of the kinds before, which come first in the map
        for_each_kind([&]<class S>() {
            if (associations_[i].kind == S::kKind) {
                for (ComparedLandmark& compared : features[i].compared) {
                    compared.landmark += static_cast<std::int32_t>(before);
                }
            }
            before += marks<S>().size();
        });
    }
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
            const Extent kept = extent<S>(mark);
            map.push_back({S::from_state(state_.landmark(mark.at)),
                           state_.landmark_covariance(mark.at), mark.record.observations, kept.low,
                           kept.high, mark.record.first_seen, mark.record.last_seen,
                           mark.record.identity});
        }
    });
    return map;
}

Eigen::MatrixXd EkfSlam::joint_covariance() const {
    std::vector<Eigen::Index> order{0, 1, 2};
    for_each_kind([&]<class S>() {
        for (const Mark& mark : marks<S>()) order.insert(order.end(), {mark.at, mark.at + 1});
    });
    return state_.covariance()(order, order);
}

SlamAlgorithmEntry ekf_slam_algorithm() {
    SlamAlgorithmEntry entry;
    entry.word = "ekf-slam";
    entry.label = HITOS_TEXT("ParameterChoice", "EKF-SLAM");
    entry.purpose = "one extended Kalman filter over the pose and all landmarks";
    entry.reads = {"association.method", "association.gate_probability",
                   "association.joint_probability", "association.new_probability"};
    entry.make = [](const FilterParams& params, std::uint64_t /*seed*/, int /*threads*/) {
        return std::make_unique<EkfSlam>(params);
    };
    return entry;
}

}  // namespace hitos
