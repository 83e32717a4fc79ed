// SPDX-License-Identifier: GPL-3.0-or-later
// A graph of poses and landmarks as a figure.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "hitos/services/drawing/vector_drawing.hpp"
#include "hitos/slam/planar_graph.hpp"

namespace hitos {

/// In millimetres: the path through the poses in the order of their ids, the edges between poses
/// that are no neighbours in it, those in `marked` (of graph.edges) in another colour, points,
/// lines as far as the poses that see them stand along them, what is fixed; below it a legend with
/// a scale bar.
VectorDrawing graph_figure(const std::string& title, const PlanarGraph& graph,
                           std::span<const std::size_t> marked);

}  // namespace hitos
