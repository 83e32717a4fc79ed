// SPDX-License-Identifier: GPL-3.0-or-later
// Many squares of a map at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "correlation_map.hpp"

namespace hitos {

/// A map's coarsest picture, made coarser still and sorted so that what a cell meets in
/// neighbouring squares lies side by side: bounds of CorrelationMap::sum() for rows of squares,
/// many times as fast as one by one.
class SquareLattice {
  public:
    static constexpr std::size_t kAcross = 32;  // squares of a row
    /// Of a pattern's cells, so that their sum is a number of 16 bits.
    static constexpr std::size_t kMostCells = 257;
    using Sums = std::array<std::uint16_t, kAcross>;

    /// Of a map of two levels at least.
    explicit SquareLattice(const CorrelationMap& map);

    /// For each of the squares that begin at (x, y) and 1, 2, … sides beside it what the pattern's
    /// sum there is at most.
    Sums bounds(const CorrelationMap::Pattern& pattern, int x, int y) const;

  private:
    static constexpr int kStep = 4;  // cells of the picture that are one here, each way

    /// In sorted_, of a cell of the picture, counted from a square's side before it; to the left
    /// kAcross squares more.
    std::size_t place_of(int row, int column) const;

    int side_;            // of a square, in cells of the picture
    int shift_;           // 2^shift_ are so many here
    int rows_;            // here; the first ones begin a square's side before the picture
    int squares_;         // side by side
    std::size_t length_;  // of what is side by side, with what lies beyond on both sides
    std::vector<std::uint8_t> sorted_;  // by row, column within a square, square
};

}  // namespace hitos
