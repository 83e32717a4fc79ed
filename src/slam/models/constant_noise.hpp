// Motion noise of the same size in every step.
#pragma once

#include <Eigen/Core>

#include "hitos/base/geometry.hpp"
#include "hitos/base/random_stream.hpp"
#include "hitos/slam/params.hpp"

namespace hitos {

/// N(0, sigma_x^2), N(0, sigma_y^2), N(0, sigma_theta^2) on x, y [m] and theta [rad] in world axes
/// [T eq 7.18].
class ConstantNoise {
  public:
    explicit ConstantNoise(const MotionParams& params)
        : sigma_(params.sigma_x_m, params.sigma_y_m, params.sigma_theta_rad) {
        if (params.unit == MotionUnit::variance) sigma_ = sigma_.cwiseSqrt().eval();
    }

    Pose added_to(const Pose& pose, RandomStream& random) const {
        const auto [n0, n1] = random.normal_pair();
        const double n2 = random.normal_pair()[0];
        return {pose.x + sigma_(0) * n0, pose.y + sigma_(1) * n1,
                wrap_angle(pose.theta + sigma_(2) * n2)};
    }
    Eigen::Matrix3d covariance() const { return sigma_.cwiseAbs2().asDiagonal(); }

  private:
    Eigen::Vector3d sigma_;
};

}  // namespace hitos
