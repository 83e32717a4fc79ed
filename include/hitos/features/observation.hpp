// SPDX-License-Identifier: GPL-3.0-or-later
// What one scan shows: lines and corners with what supports them [T 9.2.3].
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// A detected line with the scan points that support it, in scan order: an index range into
/// Observation::support.
struct DetectedLine {
    Recta recta;              ///< robot frame
    std::uint32_t first = 0;  ///< first supporting point in `support`
    std::uint32_t count = 0;
};

/// What one scan shows, in the robot frame. Reused from scan to scan, so that a steady stream of
/// scans allocates nothing.
struct Observation {
    double time_s = 0.0;
    std::vector<DetectedLine> lines;
    std::vector<Esquina> corners;
    std::vector<Point2> support;  ///< points of all lines, line by line
    /// Of (rho, theta) [m, rad] of each line and of (x, y) [m] of each corner; both empty where
    /// the observation model's fixed variances are asked for. The last corners may have none:
    /// landmarks that a sensor told by themselves, or all but circles.
    std::vector<Eigen::Matrix2d> line_covariances;
    std::vector<Eigen::Matrix2d> corner_covariances;
    /// Which landmark each corner is, -1 where that is not known; empty where none is.
    std::vector<std::int32_t> identities;
    /// Of the first corners, which are the centres of circles: trees and posts.
    std::vector<double> circle_radii_m;

    bool empty() const { return lines.empty() && corners.empty(); }
    void clear() {
        lines.clear();
        corners.clear();
        support.clear();
        line_covariances.clear();
        corner_covariances.clear();
        identities.clear();
        circle_radii_m.clear();
    }
    std::int32_t identity(std::size_t corner) const {
        return corner < identities.size() ? identities[corner] : LandmarkSighting::kNameless;
    }
    std::span<const Point2> support_of(const DetectedLine& line) const {
        return std::span(support).subspan(line.first, line.count);
    }
};

}  // namespace hitos
