// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/odometry_step.hpp"

#include <cmath>

#include "hitos/registration/pose_algebra.hpp"

namespace hitos {
namespace {

double square(double value) {
    return value * value;
}

}  // namespace

Eigen::Vector3d odometry_variances(const Pose& step, double scale) {
    const double way = std::hypot(step.x, step.y);
    const double turn = std::abs(step.theta);
    return square(scale) * Eigen::Vector3d(square(0.02) + square(0.1 * way) + square(0.05 * turn),
                                           square(0.01) + square(0.05 * way) + square(0.05 * turn),
                                           square(0.03) + square(0.15 * turn));
}

Eigen::Matrix3d turned(const Eigen::Matrix3d& matrix, double heading_rad) {
    const Eigen::Matrix3d rotation = turn_of(heading_rad);
    return rotation * matrix * rotation.transpose();
}

Eigen::Matrix3d step_information(const Eigen::Vector3d& variances, double heading_rad) {
    return turned(Eigen::Matrix3d(variances.cwiseInverse().asDiagonal()), heading_rad);
}

void LateralCalibration::learn(const Pose& step, double residual_m, double variance_m2) {
    constexpr double kDrift = 1e-8;  // of both variances, each time: mountings are knocked
    const Eigen::Vector2d h(step.x, step.theta);
    const Eigen::Vector2d ph = covariance_ * h;
    const double s = h.dot(ph) + variance_m2;
    if (!(residual_m * residual_m < 9.0 * s)) return;
    value_ += ph * (residual_m / s);
    covariance_ -= ph * ph.transpose() / s;
    covariance_.diagonal().array() += kDrift;
}

}  // namespace hitos
