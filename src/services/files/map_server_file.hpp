// SPDX-License-Identifier: GPL-3.0-or-later
// Occupancy grids as ROS's map_server reads them.
#pragma once

#include <string>

#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// Probabilities from which on, and below which, a cell counts as occupied and as free: those that
/// map_server's own maps state.
inline constexpr double kOccupiedFrom = 0.65;
inline constexpr double kFreeBelow = 0.196;

enum class CellState { unknown, free, occupied };

/// What is known of a cell of those log-odds. What is between both is unknown.
CellState state_of(float log_odds);

/// A binary PGM (P5) of a pixel a cell, row 0 at the top (greatest y): 0 occupied, 254 free, 205
/// unknown. Throws Error for an empty grid.
std::string map_server_pgm(const Grid& grid);

/// The YAML beside it: `image` is the name of the picture, `origin` the lower left corner of its
/// lower left pixel in the map's frame [m, m, rad].
std::string map_server_yaml(const Grid& grid, const std::string& image);

}  // namespace hitos
