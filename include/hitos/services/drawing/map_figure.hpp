// SPDX-License-Identifier: GPL-3.0-or-later
// A map as a figure for papers.
#pragma once

#include <span>
#include <string>

#include "hitos/registration/changed_place.hpp"
#include "hitos/services/drawing/vector_drawing.hpp"
#include "hitos/services/files/line_extents.hpp"

namespace hitos {

/// What of a figure is drawn, and how large.
struct MapFigureStyle {
    double width_mm = 85.0;  ///< at most, and a map that is no taller than it is broad has it
    bool landmarks = true;
    bool uncertainty = true;  ///< of landmarks
    bool path = true;
    bool odometry = true;
    bool axes = true;
    bool legend = true;        ///< with a scale bar
    std::string heading = {};  ///< above it; empty: none
};

/// What a figure shows of a run, all in the map's frame.
struct MapFigureContent {
    std::string title;  ///< for programs, not drawn
    const LandmarkMap& map;
    std::span<const LineExtent> segments;  ///< of the map's lines
    const Trajectory& path;
    const Trajectory& odometry;
    std::span<const ChangedPlace> changes = {};
    MapFigureStyle style = {};
};

/// How many standard deviations the uncertainty of a figure holds.
inline constexpr double kFigureSigmas = 2.0;

/// A figure of at most 85 mm unless its style says otherwise, the width of a column, with letters
/// of 7 points: segments, corners, the regions that hold kFigureSigmas of each (map_shapes()), the
/// path with its two ends, the odometry as far as it is in the frame, what of two tours is gone and
/// what is new; axes in metres, a legend below them and a scale bar. Throws Error for what
/// map_shapes() does.
VectorDrawing map_figure(const MapFigureContent& content);

}  // namespace hitos
