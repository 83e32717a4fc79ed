// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a growing grid in tiles that snapshots share, so that a view pays for what changed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// The greys of kTileSide x kTileSide cells, row by row from the LOWER left one.
struct GridTile {
    std::array<std::uint8_t, std::size_t{kTileSide} * kTileSide> grey;
};

/// A picture of a grid at one moment; immutable, and cheap to copy. Tile (column, row) covers the
/// cells from (column, row) * kTileSide on, counted from the world's origin, so a tile keeps its
/// place when the grid grows.
struct GridTiles {
    CellArea area;                  ///< cells that the grid holds
    std::int64_t first_column = 0;  ///< of the tiles
    std::int64_t first_row = 0;
    int columns = 0;
    int rows = 0;
    double resolution_m = 0.05;
    /// Row by row from the lower left one; null where nothing is known. A tile whose content did
    /// not change stays the same object from one picture to the next.
    std::vector<std::shared_ptr<const GridTile>> tiles;

    bool empty() const { return tiles.empty(); }
};

/// Keeps the tiles of one grid up to date.
class GridTiler {
  public:
    /// To be called after every Grid::add() with its last_change().
    void note_change(const CellArea& area);
    /// The picture of the grid as it is; draws only what changed since the last call.
    const GridTiles& tiles(const Grid& grid);
    /// The picture as it was at that call.
    const GridTiles& last() const { return tiles_; }
    /// Forgets everything, as Grid::clear() does.
    void clear();

  private:
    void cover(const CellArea& area);
    std::shared_ptr<const GridTile> drawn(const Grid& grid, std::int64_t column, std::int64_t row);
    std::uint8_t grey(float log_odds);

    struct Known {
        float log_odds = 0.0F;
        std::uint8_t grey = kUnknownGrey;
    };

    GridTiles tiles_;
    CellArea dirty_;
    std::array<Known, 256> known_{};  // the exponential is dear and its arguments few
};

/// The whole of a grid at once.
GridTiles tiles_of(const Grid& grid);

}  // namespace hitos
