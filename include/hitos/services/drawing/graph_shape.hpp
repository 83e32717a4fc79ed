// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to see of a graph of poses and landmarks.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hitos/slam/planar_graph.hpp"

namespace hitos {

/// In metres of the world, apart by what it is.
struct GraphShape {
    using Segment = std::array<Point2, 2>;

    Bounds bounds;
    std::vector<Segment> path;       ///< steps between poses whose ids follow on each other
    std::vector<Segment> loops;      ///< the other ones
    std::vector<Segment> sightings;  ///< from poses to landmarks
    std::vector<Segment> priors;     ///< from where a vertex is said to be to where it is
    std::vector<Segment> marked;     ///< as they were asked for
    std::vector<Segment> lines;      ///< as far as the poses that see them stand along them
    std::vector<Point2> points;
    std::vector<Point2> fixed;
};

/// Of `edges` between `vertices`; `marked` are places in `edges`.
GraphShape graph_shape(std::span<const PlanarVertex> vertices, std::span<const PlanarEdge> edges,
                       std::span<const std::size_t> marked);

}  // namespace hitos
