// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a filter is as sure as it may be.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// The normalised estimation error squared of a pose, e' P^-1 e with e = estimate - truth in (x, y,
/// theta), of which the heading is wrapped, and its covariance P [m, m, rad]. Where P tells the
/// truth and the errors are Gaussian it is a chi-square variable with 3 degrees of freedom
/// (Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and Navigation, 2001,
/// section 5.4). Nothing where P has no inverse, as at the start, where the pose is certain.
std::optional<double> pose_nees(const Pose& estimate, const Eigen::Matrix3d& covariance,
                                const Pose& truth);

/// Its mean, and between which 95 % of the values lie, 2.5 % on either side.
inline constexpr double kNeesMean = 3.0;
inline constexpr double kNeesLow = 0.21579528;
inline constexpr double kNeesHigh = 9.3484036;

}  // namespace hitos
