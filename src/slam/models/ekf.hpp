// SPDX-License-Identifier: GPL-3.0-or-later
// The extended Kalman filter of one landmark under a known pose [T 7.3, table 3.2].
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "sensor.hpp"

namespace hitos {

inline Likelihood likelihood_of(const Vector2& nu, const Matrix2& q) {
    const double det = q.determinant();
    // nu' adj(Q) nu / det: with Q^-1 the filter's innermost line would be slower and of other bits.
    const double n0 = nu(0);
    const double n1 = nu(1);
    const double d2 = (q(1, 1) * n0 * n0 - (q(0, 1) + q(1, 0)) * n0 * n1 + q(0, 0) * n1 * n1) / det;
    return {-std::log(2.0 * kPi) - 0.5 * std::log(det) - 0.5 * d2, d2};
}

/// Brings an estimate to its kind's normal form.
template <Sensor S>
void normalize(LandmarkEstimate<S>& estimate) {
    const double sign = S::normalize(estimate.mean);
    estimate.covariance(0, 1) *= sign;
    estimate.covariance(1, 0) *= sign;
}

/// The filter for one kind of landmark with observation covariance R.
template <Sensor S>
class EKF {
  public:
    explicit EKF(Matrix2 observation_covariance) : r_(std::move(observation_covariance)) {}

    /// Covariance of the innovation, Q = H P H' + R.
    Matrix2 innovation_covariance(const Matrix2& jacobian, const Matrix2& covariance) const {
        return jacobian * covariance * jacobian.transpose() + r_;
    }

    /// Of the innovation, with Q as above.
    Likelihood likelihood(const Innovation& innovation, const Matrix2& covariance) const {
        return likelihood_of(innovation.nu, innovation_covariance(innovation.jacobian, covariance));
    }

    /// A landmark seen for the first time: mean g^-1(z, pose), covariance G R G' with
    /// G = d(g^-1)/dz [T table 3.2].
    LandmarkEstimate<S> first(const Pose& pose, const Vector2& z) const {
        const Matrix2 g = S::inverse_jacobian(pose, z);
        LandmarkEstimate<S> estimate{S::inverse(pose, z), g * r_ * g.transpose()};
        normalize(estimate);
        return estimate;
    }

    /// The landmark seen again: K = P H' Q^-1, mean += K nu, P -= K Q K' (equal to (I - K H) P
    /// [T table 3.2] but symmetric to the last bit).
    void update(LandmarkEstimate<S>& estimate, const Innovation& innovation) const {
        const Matrix2 q = innovation_covariance(innovation.jacobian, estimate.covariance);
        const double det = q.determinant();
        Matrix2 q_inverse;  // symmetric to the last bit, as Eigen's inverse of a rounded Q is not
        q_inverse << q(1, 1) / det, -q(0, 1) / det, -q(0, 1) / det, q(0, 0) / det;
        const Matrix2 ph = estimate.covariance * innovation.jacobian.transpose();
        estimate.mean =
            S::from_state(S::to_state(estimate.mean) + ph * (q_inverse * innovation.nu));
        Matrix2 reduced = estimate.covariance - ph * q_inverse * ph.transpose();
        reduced(1, 0) = reduced(0, 1) = 0.5 * (reduced(0, 1) + reduced(1, 0));
        estimate.covariance = reduced;
        normalize(estimate);
    }

  private:
    Matrix2 r_;
};

}  // namespace hitos
