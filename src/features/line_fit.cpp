// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/line_fit.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {

Recta fit_least_squares(std::span<const Point2> points) {
    const auto n = static_cast<double>(points.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const Point2& p : points) {
        mean_x += p.x;
        mean_y += p.y;
    }
    mean_x /= n;
    mean_y /= n;
    double sxx = 0.0;
    double sxy = 0.0;
    double syy = 0.0;
    for (const Point2& p : points) {
        const double dx = p.x - mean_x;
        const double dy = p.y - mean_y;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
    // The scatter's principal axis lies at half of atan2(2 sxy, sxx - syy); the normal is
    // perpendicular to it.
    const double theta = 0.5 * std::atan2(2.0 * sxy, sxx - syy) + kPi / 2.0;
    return normalized({mean_x * std::cos(theta) + mean_y * std::sin(theta), theta});
}

Eigen::Matrix2d line_covariance(const Recta& recta, std::span<const Point2> points,
                                const PointErrors& errors) {
    // A range error moves a point along its ray: across the line by the cosine of the angle
    // between ray and normal. Along the wall errors of the bearing, which the model leaves out,
    // take over; a tenth of sigma keeps the covariance from vanishing there.
    constexpr double kLeastCosine2 = 0.01;
    const PreparedRecta line(recta);
    const auto n = static_cast<double>(points.size());
    double mean = 0.0;
    for (const Point2& p : points) mean += line.along(p);
    mean /= n;
    double spread = 0.0;    // sum of (t - mean)^2
    double variance = 0.0;  // sums of the variances across the line, times 1, t - mean and its
    double lever = 0.0;     // square
    double lever2 = 0.0;
    double residual2 = 0.0;
    for (const Point2& p : points) {
        const double t = line.along(p) - mean;
        const Point2 ray{p.x - errors.laser.x, p.y - errors.laser.y};
        const double depth = ray.x * line.c + ray.y * line.s;
        const double range2 = ray.x * ray.x + ray.y * ray.y;
        const double away = line.signed_distance(p);
        const double across =
            errors.range_sigma_m * errors.range_sigma_m *
            (range2 > 0.0 ? std::max(depth * depth / range2, kLeastCosine2) : 1.0);
        spread += t * t;
        variance += across;
        lever += across * t;
        lever2 += across * t * t;
        residual2 += away * away;
    }
    const double excess = n > 2.0 ? std::max(1.0, residual2 / variance * n / (n - 2.0)) : 1.0;
    // What all points share moves the line's middle and tilts it, each as one more error.
    const double common = errors.common_sigma_m * errors.common_sigma_m;
    const double var_middle = excess * variance / (n * n) + common;
    const double var_theta = excess * lever2 / (spread * spread) + common * n / spread;
    const double cov_middle = -excess * lever / (n * spread);
    Eigen::Matrix2d covariance;
    covariance(0, 0) = var_middle + 2.0 * mean * cov_middle + mean * mean * var_theta;
    covariance(0, 1) = covariance(1, 0) = cov_middle + mean * var_theta;
    covariance(1, 1) = var_theta;
    return covariance;
}

Eigen::Matrix2d intersection_covariance(const Recta& a, const Eigen::Matrix2d& covariance_a,
                                        const Recta& b, const Eigen::Matrix2d& covariance_b,
                                        const Point2& meeting) {
    // n . p = rho moves by n . dp = d rho - (u . p) d theta, with u the direction of the line.
    const auto variance = [&](const Recta& line, const Eigen::Matrix2d& covariance) {
        const Eigen::Vector2d g(1.0, -PreparedRecta(line).along(meeting));
        return g.dot(covariance * g);
    };
    Eigen::Matrix2d normals;
    normals << std::cos(a.theta), std::sin(a.theta), std::cos(b.theta), std::sin(b.theta);
    const double det = normals(0, 0) * normals(1, 1) - normals(0, 1) * normals(1, 0);
    Eigen::Matrix2d inverse;
    inverse << normals(1, 1) / det, -normals(0, 1) / det, -normals(1, 0) / det, normals(0, 0) / det;
    const Eigen::Vector2d variances(variance(a, covariance_a), variance(b, covariance_b));
    return inverse * variances.asDiagonal() * inverse.transpose();
}

}  // namespace hitos
