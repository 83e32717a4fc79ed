// Graphs of poses and landmarks as g2o's text files.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// The pose `to` as seen from the pose `from`; the information of (x, y, theta) in the axes of z
/// [1/m^2, 1/m^2, 1/rad^2].
struct GraphStep {
    std::size_t from = 0;
    std::size_t to = 0;
    Pose z;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// A landmark as the robot saw it from a pose, in its frame, with the covariance of (rho, theta)
/// or (x, y) [m, rad]. A line has the normal that points as the landmark's does.
struct GraphSighting {
    std::size_t pose = 0;
    std::size_t landmark = 0;
    ICaracteristica seen;
};

struct LandmarkGraphFile {
    std::vector<Pose> poses;
    LandmarkMap map;
    std::vector<GraphStep> steps;
    std::vector<GraphSighting> sightings;
};

/// The text of a graph: VERTEX_SE2 of every pose, by its number; then VERTEX_XY of corners and
/// VERTEX_LINE2D of lines, by the number of poses and their own in the map; EDGE_SE2, EDGE_SE2_XY
/// and EDGE_SE2_LINE2D; the first pose is fixed. Throws Error for a number that is not finite.
std::string g2o_text(const LandmarkGraphFile& graph);

}  // namespace hitos
