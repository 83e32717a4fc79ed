// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmarks of EKF-SLAM an observation cannot be of, at a glance.
#pragma once

#include <Eigen/LU>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hitos/base/vectorised.hpp"
#include "joint_state.hpp"

namespace hitos {

/// The landmarks of a kind as a known pose would see them: with A = H_m^-1 H_r, of the Jacobians of
/// h by landmark and pose, the covariance P' = P_mm + A P_rm + P_mr A' + A P_rr A' makes H_m P'
/// H_m' what H P H' is, so that the kind's quick rejection for known poses holds.
template <Sensor S>
class PairingSieve {
  public:
    /// For observations from the state as it is, of which no landmark is that lies further off than
    /// `gate`, a squared Mahalanobis distance. `places` are the landmarks' in the state.
    template <class Marks>
    void begin(const JointState& state, const Marks& marks, std::span<const Measurement> seen,
               double gate);
    /// Calls body(i) for every landmark that may be nearer than the gate, in their order. All
    /// others are further off, and their comparison is sound: S is positive and far from singular.
    template <class Body>
    void for_each_near(const Measurement& measured, const Body& body);

  private:
    using Lane = typename S::Lane;
    static constexpr std::size_t kLanes = 8;
    // What rounding may have made of a distance where S is no nearer to singular than that.
    static constexpr double kSlack = 1.0 + 1e-6;
    static constexpr double kSingular = 1e-8;
    static constexpr double kRounding = 1e-10;  // of what P' is the sum of

    LanePose pose_{};
    double gate_ = 0.0;
    std::size_t size_ = 0;
    std::vector<double> values_;       // lanes of eight landmarks, one after the other
    std::vector<std::uint8_t> doubt_;  // bits of landmarks that nothing can be said of
    std::vector<std::uint8_t> far_;    // bits of landmarks that it cannot be
};

template <Sensor S>
template <class Marks>
void PairingSieve<S>::begin(const JointState& state, const Marks& marks,
                            std::span<const Measurement> seen, double gate) {
    const Pose pose = state.pose();
    const Matrix3 pose_covariance = state.pose_covariance();
    pose_ = lane_of(pose);
    gate_ = kSlack * gate;
    size_ = marks.size();
    const std::size_t groups = (size_ + kLanes - 1) / kLanes;
    values_.assign(groups * kLanes * Lane::kSize, 0.0);
    doubt_.assign(groups, 0);
    far_.assign(groups, 0);
    Vector2 most = Vector2::Zero();  // of the variances of what is seen
    double least = std::numeric_limits<double>::infinity();
    for (const Measurement& measured : seen) {
        most = most.cwiseMax(measured.r.diagonal());
        const bool usable = measured.z.allFinite() && measured.r.allFinite() &&
                            measured.r.diagonal().minCoeff() > 0.0;
        least = std::min(least, usable ? measured.r.determinant() : 0.0);
    }
    for (std::size_t i = 0; i < size_; ++i) {
        const Eigen::Index at = marks[i].at;
        const auto landmark = S::from_state(state.landmark(at));
        const Matrix2 h = S::jacobian(pose, landmark);
        const Matrix23 a = h.inverse() * S::pose_jacobian(pose, landmark);
        const Matrix2 own = state.landmark_covariance(at);
        const Matrix2 poses = a * pose_covariance * a.transpose();
        const Matrix2 cross = a * state.cross_covariance(at).transpose();
        const Matrix2 rounding = kRounding * (own.trace() + poses.trace()) * Matrix2::Identity();
        const Matrix2 p = own + poses + cross + cross.transpose() + rounding;
        const Vector2 s = (h * p * h.transpose()).diagonal() + most;
        const bool sound = kSingular * s(0) * s(1) < least && p.allFinite();
        Lane::of(landmark, {p(0, 0), p(0, 1), p(1, 1)})
            .store(values_.data() + i / kLanes * kLanes * Lane::kSize + i % kLanes, kLanes);
        if (!sound) doubt_[i / kLanes] |= static_cast<std::uint8_t>(1U << (i % kLanes));
    }
}

template <Sensor S>
template <class Body>
void PairingSieve<S>::for_each_near(const Measurement& measured, const Body& body) {
    const auto [sine, cosine] = elementary::sine_cosine(measured.z(1) + pose_.theta);
    const NearQuery query{measured.z(0), cosine, sine, measured.r(0, 0), measured.r(1, 1), gate_};
    const LanePose pose = pose_;
    vectorised([&]() HITOS_INLINED {
        for (std::size_t group = 0; group < far_.size(); ++group) {
            const double* const lanes = values_.data() + group * kLanes * Lane::kSize;
            alignas(64) double margins[kLanes];  // NOLINT(*-avoid-c-arrays): one register
            HITOS_LANES
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                margins[lane] = -S::margin(Lane::load(lanes + lane, kLanes), pose, query);
            }
            far_[group] = static_cast<std::uint8_t>(positive_of_eight(margins));
        }
    });
    for (std::size_t group = 0; group < far_.size(); ++group) {
        const std::size_t there = std::min(kLanes, size_ - group * kLanes);
        const std::uint32_t all = (1U << there) - 1U;
        std::uint32_t near = (~static_cast<std::uint32_t>(far_[group]) | doubt_[group]) & all;
        for (; near != 0; near &= near - 1U) {
            body(group * kLanes + static_cast<std::size_t>(std::countr_zero(near)));
        }
    }
}

}  // namespace hitos
