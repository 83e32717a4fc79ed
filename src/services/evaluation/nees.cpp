// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/nees.hpp"

#include <Eigen/Cholesky>

namespace hitos {

std::optional<double> pose_nees(const Pose& estimate, const Eigen::Matrix3d& covariance,
                                const Pose& truth) {
    if (!covariance.allFinite()) return std::nullopt;
    const Eigen::Vector3d sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    if (!(sigma.minCoeff() > 0.0)) return std::nullopt;
    // By correlations, so that metres and radians count alike. Below this pivot the inverse would
    // be of rounding: a few particles span no volume.
    constexpr double kLeastPivot = 1e-9;
    const Eigen::Vector3d by_sigma = sigma.cwiseInverse();
    const Eigen::LDLT<Eigen::Matrix3d> correlation(by_sigma.asDiagonal() * covariance *
                                                   by_sigma.asDiagonal());
    if (!(correlation.vectorD().minCoeff() > kLeastPivot)) return std::nullopt;
    const Eigen::Vector3d error = Eigen::Vector3d(estimate.x - truth.x, estimate.y - truth.y,
                                                  wrap_angle(estimate.theta - truth.theta))
                                      .cwiseProduct(by_sigma);
    return error.dot(correlation.solve(error));
}

}  // namespace hitos
