// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric matrix of which one half is stored.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "tall_matrix.hpp"

namespace hitos {

/// The lower triangle in square tiles of 32 rows and columns, each row of tiles in memory of its
/// own, so that the matrix grows without being copied; tiles on the diagonal are whole.
class HalfMatrix {
  public:
    static constexpr std::size_t kTile = Strip::kRows;

    std::size_t size() const { return size_; }
    /// More rows and columns, of zeros, or fewer.
    void resize(std::size_t size);

    double operator()(std::size_t i, std::size_t j) const {
        const std::size_t row = std::max(i, j);
        const std::size_t column = std::min(i, j);
        return tile(row / kTile, column / kTile).values[column % kTile * kTile + row % kTile];
    }
    void set(std::size_t i, std::size_t j, double value);

    /// Column `column` of the matrix into one of `out`, which has the panels for it.
    void read_column(std::size_t column, TallMatrix& out, std::size_t to) const;
    /// Makes that column, and the row of that number, what the column of `in` says.
    void write_column(std::size_t column, const TallMatrix& in, std::size_t from);

    /// A -= U U', of the first `terms` columns of U, a multiple of four: one pass over the tiles,
    /// each of which meets two panels of U.
    void subtract_square(const TallMatrix& u, std::size_t terms);

    /// Turns the sign of row and column; what stands in both stays.
    void negate(std::size_t at);
    /// Takes rows and columns [first, first + count) out.
    void remove(std::size_t first, std::size_t count);

    std::size_t bytes() const;

  private:
    struct alignas(64) Tile {
        std::array<double, kTile * kTile> values{};  // column by column
    };
    Tile& tile(std::size_t row, std::size_t column) { return tiles_[row][column]; }
    const Tile& tile(std::size_t row, std::size_t column) const { return tiles_[row][column]; }

    std::size_t size_ = 0;
    std::vector<std::vector<Tile>> tiles_;  // row by row, the last of each on the diagonal
};

}  // namespace hitos
