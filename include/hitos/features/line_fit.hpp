// SPDX-License-Identifier: GPL-3.0-or-later
// Straight lines through many points, and how sure they are.
#pragma once

#include <Eigen/Core>
#include <span>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// Total least squares: the line that minimises the sum of squared perpendicular distances (its
/// normal is the eigenvector of the smaller eigenvalue of the points' scatter) [P 2]. Normal form;
/// needs two points or more.
Recta fit_least_squares(std::span<const Point2> points);

/// How far measured points are from where they should be.
struct PointErrors {
    double range_sigma_m = 0.01;  ///< of each range by itself
    double common_sigma_m = 0.0;  ///< of errors of a line's middle and tilt that no number of
                                  ///< points averages out
    Point2 laser;                 ///< where the ranges are measured from, in the points' frame
};

/// The covariance of (rho, theta) [m, rad] of the total-least-squares line through the points, to
/// first order: derived in docs/algorithm.md. With two points it is that of the line through them.
/// Where the points scatter more about the line than range_sigma explains, its part grows in
/// proportion.
Eigen::Matrix2d line_covariance(const Recta& recta, std::span<const Point2> points,
                                const PointErrors& errors);

/// The covariance of (x, y) [m] of the intersection of two independent lines that are not parallel.
Eigen::Matrix2d intersection_covariance(const Recta& a, const Eigen::Matrix2d& covariance_a,
                                        const Recta& b, const Eigen::Matrix2d& covariance_b,
                                        const Point2& meeting);

}  // namespace hitos
