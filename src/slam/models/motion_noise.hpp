// SPDX-License-Identifier: GPL-3.0-or-later
// Motion with noise, of one particle or many at once.
#pragma once

#include <Eigen/Core>
#include <span>

#include "hitos/base/geometry.hpp"
#include "hitos/base/random_row.hpp"
#include "hitos/base/vectorised.hpp"
#include "hitos/slam/params.hpp"
#include "pose_lanes.hpp"

namespace hitos {

/// A step in the robot's frame with noise of three independent standard normal draws n: M (n0, n1)
/// on the step itself [m], sigma_x n0 and sigma_y n1 on the place in the world [m], sigma_theta n2
/// on the heading [rad].
struct StepWithNoise {
    LanePose step{};
    double m00 = 0.0;
    double m01 = 0.0;
    double m10 = 0.0;
    double m11 = 0.0;
    double sigma_x = 0.0;
    double sigma_y = 0.0;
    double sigma_theta = 0.0;

    HITOS_INLINE LanePose moved(const LanePose& pose, double n0, double n1, double n2) const {
        const auto [sine, cosine] = elementary::sine_cosine(pose.theta);
        const double ahead = step.x + (m00 * n0 + m01 * n1);
        const double aside = step.y + (m10 * n0 + m11 * n1);
        return {pose.x + (cosine * ahead - sine * aside + sigma_x * n0),
                pose.y + (sine * ahead + cosine * aside + sigma_y * n1),
                elementary::wrap(pose.theta + step.theta + sigma_theta * n2)};
    }
};

/// N(0, sigma_x^2), N(0, sigma_y^2), N(0, sigma_theta^2) on x, y [m] and theta [rad] in world axes
/// [T eq 7.18].
inline StepWithNoise constant_noise(const MotionParams& params, const Pose& step) {
    Eigen::Array3d sigma(params.sigma_x_m, params.sigma_y_m, params.sigma_theta_rad);
    if (params.unit == MotionUnit::variance) sigma = sigma.sqrt().eval();
    StepWithNoise motion{lane_of(step)};
    motion.sigma_x = sigma(0);
    motion.sigma_y = sigma(1);
    motion.sigma_theta = sigma(2);
    return motion;
}
/// Its covariance.
inline Eigen::Matrix3d constant_covariance(const MotionParams& params) {
    const StepWithNoise noise = constant_noise(params, {});
    const Eigen::Array3d sigma(noise.sigma_x, noise.sigma_y, noise.sigma_theta);
    return sigma.square().matrix().asDiagonal();
}

/// The pose after a motion, which is what gives moved().
template <class Motion>
Pose moved(const Motion& motion, const Pose& pose, RandomStream& random) {
    const auto [n0, n1] = random.normal_pair();
    const LanePose after = motion.moved(lane_of(pose), n0, n1, random.normal_pair()[0]);
    return {after.x, after.y, after.theta};
}

template <class Motion>
HITOS_INLINE void move_lanes(Motion motion, PoseLanes& lanes, std::size_t count,
                             const NormalRow& normals) {
    HITOS_LANES
    for (std::size_t i = 0; i < count; ++i) {
        const LanePose after = motion.moved(LanePose{lanes.x[i], lanes.y[i], lanes.theta[i]},
                                            normals.n0[i], normals.n1[i], normals.n2[i]);
        lanes.x[i] = after.x;
        lanes.y[i] = after.y;
        lanes.theta[i] = after.theta;
    }
}
/// The same for at most NormalRow::kMost poses, each with its stream.
template <class Motion>
void move_row(const Motion& motion, std::span<Pose> poses, const RandomRow& row) {
    NormalRow normals;
    draw_normals(row, poses.size(), normals);
    PoseLanes lanes;
    lanes.load(poses);
    vectorised([&]() HITOS_INLINED { move_lanes(motion, lanes, poses.size(), normals); });
    lanes.store(poses);
}

}  // namespace hitos
