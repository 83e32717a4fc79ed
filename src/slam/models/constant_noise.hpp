// Motion noise of the same size in every step.
#pragma once

#include <Eigen/Core>
#include <span>

#include "hitos/base/geometry.hpp"
#include "hitos/base/random_row.hpp"
#include "hitos/base/vectorised.hpp"
#include "hitos/slam/params.hpp"
#include "pose_lanes.hpp"

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
    /// Carries the poses on by the step and adds noise to them.
    void add_row(std::span<Pose> poses, const Pose& step, const RandomRow& row) const {
        NormalRow normals;
        draw_normals(row, poses.size(), normals);
        PoseLanes lanes;
        lanes.load(poses);
        vectorised([&]()
                       HITOS_INLINED { add(lanes, poses.size(), lane_of(step), sigma_, normals); });
        lanes.store(poses);
    }
    Eigen::Matrix3d covariance() const { return sigma_.cwiseAbs2().asDiagonal(); }

  private:
    HITOS_INLINE static void add(PoseLanes& lanes, std::size_t count, LanePose step,
                                 const Eigen::Vector3d& sigma, const NormalRow& normals) {
        const double sx = sigma(0);
        const double sy = sigma(1);
        const double st = sigma(2);
        HITOS_LANES
        for (std::size_t i = 0; i < count; ++i) {
            const auto [sine, cosine] = elementary::sine_cosine(lanes.theta[i]);
            lanes.x[i] += cosine * step.x - sine * step.y + sx * normals.n0[i];
            lanes.y[i] += sine * step.x + cosine * step.y + sy * normals.n1[i];
            lanes.theta[i] = elementary::wrap(lanes.theta[i] + step.theta + st * normals.n2[i]);
        }
    }

    Eigen::Vector3d sigma_;
};

}  // namespace hitos
