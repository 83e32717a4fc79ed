// SPDX-License-Identifier: GPL-3.0-or-later
// What the wheels say of a step, how sure that is, and what the laser's mounting does to it.
#pragma once

#include <Eigen/Core>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Variances of an odometry step along it, across it and of its heading [m^2, m^2, rad^2].
/// Standard deviations: 2 cm + a tenth of the way, 1 cm + a twentieth of it, 30 mrad + 15 % of the
/// turn; a turn moves what is not on the axle by 5 cm a radian. `scale` multiplies all of them.
Eigen::Vector3d odometry_variances(const Pose& step, double scale);

/// Of a step that somebody calls a slip: a metre and a radian.
inline Eigen::Vector3d slip_variances() {
    return Eigen::Vector3d::Ones();
}

/// The information of a step with these variances in axes that are turned by `heading`.
Eigen::Matrix3d step_information(const Eigen::Vector3d& variances, double heading_rad);

/// `matrix`, a covariance or an information of (x, y, theta), in axes turned by -`heading`.
Eigen::Matrix3d turned(const Eigen::Matrix3d& matrix, double heading_rad);

/// Learns what the laser, as it is mounted, sees beside the direction of travel: the matched steps
/// drift across the odometry's by `skew` times the way, the laser's angle, and by `lever` times the
/// turn, its distance ahead of the axle. Uncorrected, the odometry pushes sideways, the walls push
/// back, and the heading turns. Recursive least squares from a prior of zero.
class LateralCalibration {
  public:
    Pose corrected(const Pose& step) const {
        return {step.x, step.y + skew_rad() * step.x + lever_m() * step.theta, step.theta};
    }
    /// The matched step lay `residual_m` to the left of the corrected one; `variance_m2` is the
    /// odometry's across the step. Residuals beyond three standard deviations teach nothing.
    void learn(const Pose& step, double residual_m, double variance_m2);

    double skew_rad() const { return value_(0); }
    double lever_m() const { return value_(1); }

  private:
    Eigen::Vector2d value_ = Eigen::Vector2d::Zero();
    /// Prior: 0.03 rad, 0.2 m.
    Eigen::Matrix2d covariance_ = Eigen::Vector2d(0.03 * 0.03, 0.2 * 0.2).asDiagonal();
};

}  // namespace hitos
