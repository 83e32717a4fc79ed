// SPDX-License-Identifier: GPL-3.0-or-later
// From the cells of an occupancy picture to straight walls.
#pragma once

#include "hitos/base/geometry.hpp"
#include "hitos/services/tracing/occupancy_picture.hpp"

namespace hitos {

/// How the walls of a picture are found.
struct TracingOptions {
    /// How far cells may lie from the straight wall that stands for them [m]; 0: two cells.
    double tolerance_m = 0.0;
    /// Shorter walls are left out [m]; 0: six cells.
    double shortest_m = 0.0;
    /// What is thicker than this is no wall but a block, whose outline is traced [m].
    double thickest_m = 0.5;
};

/// The walls of the picture, in the frame of its origin: walls of several cells are thinned to
/// their middle, straight runs fitted by least squares, ends that meet joined in corners. The same
/// picture gives the same walls, bit by bit. Openings of more than four cells and twice the
/// tolerance stay open. Throws ConfigError for options below 0 or not finite.
Walls trace_walls(const OccupancyPicture& picture, const TracingOptions& options = {});

}  // namespace hitos
