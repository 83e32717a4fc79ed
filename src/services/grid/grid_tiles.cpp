// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/grid/grid_tiles.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace hitos {
void GridTiler::note_change(const CellArea& area) {
    dirty_ = united(dirty_, area);
}

void GridTiler::clear() {
    tiles_ = {};
    dirty_ = {};
}

/// Makes room for tiles that hold the area; those that are there keep their place.
void GridTiler::cover(const CellArea& area) {
    GridTiles next;
    next.area = area;
    next.first_column = tile_of(area.first_column);
    next.first_row = tile_of(area.first_row);
    next.columns = static_cast<int>(tile_of(area.end_column - 1) - next.first_column + 1);
    next.rows = static_cast<int>(tile_of(area.end_row - 1) - next.first_row + 1);
    tiles_.area = area;
    if (next.first_column == tiles_.first_column && next.first_row == tiles_.first_row &&
        next.columns == tiles_.columns && next.rows == tiles_.rows) {
        return;
    }
    next.tiles.resize(static_cast<std::size_t>(next.columns) * static_cast<std::size_t>(next.rows));
    const std::int64_t column_shift = tiles_.first_column - next.first_column;
    const std::int64_t row_shift = tiles_.first_row - next.first_row;
    for (std::int64_t row = 0; row < tiles_.rows; ++row) {
        for (std::int64_t column = 0; column < tiles_.columns; ++column) {
            next.tiles[static_cast<std::size_t>((row + row_shift) * next.columns + column +
                                                column_shift)] =
                std::move(tiles_.tiles[static_cast<std::size_t>(row * tiles_.columns + column)]);
        }
    }
    tiles_ = std::move(next);
}

std::uint8_t GridTiler::grey(float log_odds) {
    const auto bits = std::bit_cast<std::uint32_t>(log_odds);
    Known& known = known_[(bits * 2654435761U) >> 24U];
    if (known.log_odds != log_odds) known = {log_odds, grey_of(log_odds)};
    return known.grey;
}

std::shared_ptr<const GridTile> GridTiler::drawn(const Grid& grid, std::int64_t column,
                                                 std::int64_t row) {
    auto tile = std::make_shared<GridTile>();
    tile->grey.fill(kUnknownGrey);
    const CellArea area = grid.area();
    const std::int64_t left = column * kTileSide;
    const std::int64_t bottom = row * kTileSide;
    const std::int64_t first = std::max(left, area.first_column);
    const std::int64_t end = std::min(left + kTileSide, area.end_column);
    for (std::int64_t y = std::max(bottom, area.first_row);
         y < std::min(bottom + kTileSide, area.end_row); ++y) {
        std::uint8_t* out = tile->grey.data() + (y - bottom) * kTileSide + (first - left);
        for (std::int64_t x = first; x < end; ++x) {
            *out++ = grey(grid.log_odds(static_cast<int>(x - area.first_column),
                                        static_cast<int>(y - area.first_row)));
        }
    }
    return tile;
}

const GridTiles& GridTiler::tiles(const Grid& grid) {
    if (grid.empty() || dirty_.empty()) return tiles_;
    cover(grid.area());
    tiles_.resolution_m = grid.resolution_m();
    for (std::int64_t row = tile_of(dirty_.first_row); row <= tile_of(dirty_.end_row - 1); ++row) {
        for (std::int64_t column = tile_of(dirty_.first_column);
             column <= tile_of(dirty_.end_column - 1); ++column) {
            auto& place = tiles_.tiles[static_cast<std::size_t>(
                (row - tiles_.first_row) * tiles_.columns + column - tiles_.first_column)];
            auto tile = drawn(grid, column, row);
            if (!place || place->grey != tile->grey) place = std::move(tile);
        }
    }
    dirty_ = {};
    return tiles_;
}

GridTiles tiles_of(const Grid& grid) {
    GridTiler tiler;
    tiler.note_change(grid.area());
    return tiler.tiles(grid);
}

}  // namespace hitos
