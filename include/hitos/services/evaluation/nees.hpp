// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a filter is as sure as it may be.
#pragma once

#include <Eigen/Core>
#include <array>
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

/// Between which the mean of so many independent values, of so many degrees of freedom each, lies
/// in 95 of 100 cases where the covariances tell the truth, 2.5 on either side: `values` times it
/// is a chi-square variable of values * degrees degrees of freedom (the same book, section 5.4.2,
/// for Monte Carlo runs). Both numbers are at least 1.
struct NeesInterval {
    double low = 0.0;
    double high = 0.0;
};
NeesInterval nees_interval(int values, int degrees);

/// The probabilities of the regions that a filter's calibration is told by.
inline constexpr std::array kRegions{0.5, 0.68, 0.95, 0.99};

}  // namespace hitos
