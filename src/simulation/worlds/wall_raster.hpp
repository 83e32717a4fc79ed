// SPDX-License-Identifier: GPL-3.0-or-later
// A world's walls as the cells of a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// Cells of the plane, each free or occupied; everything outside is free. A cell is occupied where
/// any part of a drawn wall lies in it: a rectangle of the wall's thickness along its segment,
/// which goes on for half the thickness beyond the ends, so that corners are full.
class WallRaster {
  public:
    /// Throws ConfigError ("raster.cell") where the cells would be too many.
    WallRaster(const std::vector<WallSegment>& walls, const RasterParams& params);

    double cell_m() const { return cell_m_; }
    /// The cell of column x and row y, which spans [x, x + 1] * cell_m() in the world frame.
    bool occupied(std::int64_t x, std::int64_t y) const {
        const std::int64_t column = x - left_;
        const std::int64_t row = y - bottom_;
        if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return false;
        return cells_[static_cast<std::size_t>(row * columns_ + column)] != 0;
    }

  private:
    double cell_m_;
    std::int64_t left_ = 0;
    std::int64_t bottom_ = 0;
    std::int64_t columns_ = 0;
    std::int64_t rows_ = 0;
    std::vector<std::uint8_t> cells_;
};

/// Throws ConfigError ("raster.cell") where a raster of these walls would have too many cells.
void check_raster(const std::vector<WallSegment>& walls, const RasterParams& params);

}  // namespace hitos
