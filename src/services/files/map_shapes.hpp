// SPDX-License-Identifier: GPL-3.0-or-later
// What drawings of a map consist of, before a format is thought of.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "hitos/services/files/line_extents.hpp"

namespace hitos {

/// Whether a landmark's covariance says something.
inline bool is_known(const Eigen::Matrix2d& covariance) {
    return covariance.allFinite() && !covariance.isZero(0.0);
}

/// A region that a corner is in.
struct MapEllipse {
    Point2 centre;
    Point2 major;        ///< half the longer axis
    double ratio = 1.0;  ///< of the shorter axis to the longer one
};

/// Everything that is drawn of a map, in its frame [m].
struct MapShapes {
    std::vector<std::pair<Point2, Point2>> lines;  ///< the segments
    std::vector<Point2> corners;
    /// One for each tour, a point for each place; without those of one place only.
    std::vector<std::vector<Point2>> paths;
    std::vector<MapEllipse> ellipses;
    std::vector<std::vector<Point2>> bands;  ///< closed
    Bounds box;                              ///< that holds all of them
};

/// The regions hold what is within `sigmas` standard deviations: an ellipse for each corner; for
/// each segment the band of the points that far off the line on both sides. At t along the line
/// from its foot the line's place across has the variance
/// C_rho,rho - 2 t C_rho,theta + t^2 C_theta,theta. A landmark whose covariance is not known has
/// no region. Throws Error for a landmark, segment or pose that is not finite or beyond 1e9 m, and
/// for a segment of a landmark that is no line of the map.
MapShapes map_shapes(const LandmarkMap& map, std::span<const LineExtent> segments,
                     const Trajectory& path, double sigmas);

}  // namespace hitos
