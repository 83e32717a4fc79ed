// SPDX-License-Identifier: GPL-3.0-or-later
// Occupancy grids as arrays.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bindings.hpp"
#include "hitos/base/geometry.hpp"
#include "hitos/services/grid/grid.hpp"
#include "hitos/services/grid/grid_tiles.hpp"

namespace hitos::python {

/// A grid in one piece, row by row from the lowest; immutable.
struct GridArray {
    int columns = 0;
    int rows = 0;
    Point2 origin;  ///< of the lower left corner [m]
    double resolution_m = 0.05;
    std::vector<std::uint8_t> grey;
    std::vector<float> log_odds;  ///< empty of a picture
};

std::shared_ptr<const GridArray> array_of(const Grid& grid);
std::shared_ptr<const GridArray> array_of(const GridTiles& tiles);

}  // namespace hitos::python
