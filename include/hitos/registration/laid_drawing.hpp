// SPDX-License-Identifier: GPL-3.0-or-later
// Where a drawing lies on the map, of which its anchors tell.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/registration/pose_graph.hpp"

namespace hitos {

/// A drawing's frame in that of the map.
struct LaidDrawing {
    Pose pose;
    /// Whether the anchors say all of it, to better than a metre and a radian: one wall leaves it
    /// to slide, and one point to turn.
    bool firm = false;
    friend bool operator==(const LaidDrawing&, const LaidDrawing&) = default;
};

/// Where the anchors among the edges have the drawing as the keys lie: the least squares of their
/// errors over its pose. What they leave open is some value. Nothing where there are none.
std::optional<LaidDrawing> laid_drawing(std::span<const KeyPose> keys,
                                        std::span<const PoseEdge> edges);

/// The anchor of a drawing that lies there as an edge from the first key, for whoever knows of no
/// drawing.
PoseEdge edge_from_first(const PoseEdge& anchor, const KeyPose& first, const LaidDrawing& drawing);

}  // namespace hitos
