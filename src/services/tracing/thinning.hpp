// SPDX-License-Identifier: GPL-3.0-or-later
// Masks of cells, and lines one cell thin through them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hitos {

/// Cells that are set or not; outside of it none is.
class CellMask {
  public:
    CellMask(int columns, int rows)
        : columns_(columns),
          rows_(rows),
          cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {}

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool inside(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns_ && row < rows_;
    }
    bool at(int column, int row) const {
        return inside(column, row) && cells_[index(column, row)] != 0;
    }
    void set(int column, int row, bool on) { cells_[index(column, row)] = on ? 1 : 0; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

  private:
    int columns_;
    int rows_;
    std::vector<std::uint8_t> cells_;
};

struct SkeletonCell {
    int column = 0;
    int row = 0;
};

/// Set where a set cell lies within `cells` columns and rows.
CellMask grown(const CellMask& mask, int cells);
/// Set where all cells within `cells` columns and rows are set, those outside too.
CellMask shrunk(const CellMask& mask, int cells);
/// Lines one cell thin through the middle of what is set, which hang together as it does: border
/// cells go from all four sides in turn.
CellMask thinned(CellMask mask);

/// A run of neighbouring cells of a thin mask, between ends, junctions or round a loop.
using CellChain = std::vector<SkeletonCell>;

/// The chains of a thin mask in a fixed order. Side branches of fewer than `spur` cells are taken
/// off the mask first.
std::vector<CellChain> chains_of(CellMask& thin, int spur);

}  // namespace hitos
