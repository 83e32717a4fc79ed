// SPDX-License-Identifier: GPL-3.0-or-later
// A map as pictures, coarser and coarser, that points are laid on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "point_map.hpp"

namespace hitos {

/// A map as a picture of blurred points with coarser pictures over it, each cell of which holds the
/// greatest value of a square of cells (Olson, 2009; Hess et al., 2016).
class CorrelationMap {
  public:
    static constexpr double kCell = 0.1;  // [m]
    static constexpr int kMost = 255;     // of a cell

    /// Points further than `half_m` from the map's centre are left out. The coarsest of `levels`
    /// pictures over the finest joins 2^levels cells a side.
    CorrelationMap(const PointMap& map, double half_m, int levels);

    int levels() const { return static_cast<int>(pictures_.size()) - 1; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    /// Row by row.
    std::span<const std::uint8_t> coarsest() const { return pictures_.back(); }
    struct Cell {
        int column;
        int row;
    };
    /// Cells that are moved together, and the least rectangle that holds them.
    struct Pattern {
        std::vector<Cell> cells;
        Cell low;
        Cell high;
        /// Of one cell at least.
        explicit Pattern(std::vector<Cell> all);
    };
    /// That of a point of the world.
    Cell cell(double x, double y) const;
    /// Sum over cells moved by (x, y), of the greatest value in the square of 2^level cells that
    /// begins there. Of a sum below `least` it is only told that it is.
    int sum(const Pattern& pattern, int x, int y, int level, int least = 0) const;
    /// Those of the four squares of 2^level cells that a square of twice the side is made of, which
    /// begins at (x, y): the first column's two, then the second's.
    std::array<int, 4> quarters(const Pattern& pattern, int x, int y, int level, int least) const;

  private:
    using Picture = std::vector<std::uint8_t>;
    /// sum() at several places, all or none of them below `least` by what is left.
    template <std::size_t kPlaces>
    std::array<int, kPlaces> sums(const Pattern& pattern, const std::array<Cell, kPlaces>& places,
                                  int level, int least) const;

    void blur(const PointMap& map, double half_m);
    Picture coarser(const Picture& fine, std::size_t half) const;

    int columns_ = 0;
    int rows_ = 0;
    double x0_ = 0.0;  // of the world
    double y0_ = 0.0;
    std::vector<Picture> pictures_;
};

}  // namespace hitos
