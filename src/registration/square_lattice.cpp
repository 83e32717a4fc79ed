// SPDX-License-Identifier: GPL-3.0-or-later
#include "square_lattice.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <span>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

// A loop over arrays gcc 12 takes apart again, number by number.
using Bytes = std::uint8_t __attribute__((vector_size(SquareLattice::kAcross)));
using Words = std::uint16_t __attribute__((vector_size(2 * SquareLattice::kAcross)));

}  // namespace

SquareLattice::SquareLattice(const CorrelationMap& map)
    : side_(1 << map.levels()),
      shift_(map.levels() - 2),
      rows_((map.rows() + side_ - 1) / kStep + 1),
      squares_((map.columns() + side_ - 1) / side_ + 1),
      length_(static_cast<std::size_t>(squares_) + 2 * kAcross) {
    assert(shift_ >= 0);
    static_assert(kStep == 1 << 2);
    const int steps = 1 << shift_;
    sorted_.resize(static_cast<std::size_t>(rows_ * steps) * length_);
    const std::span<const std::uint8_t> picture = map.coarsest();
    // A square that begins before the picture may reach into it.
    for (int row = 1 - side_; row < map.rows(); ++row) {
        const std::size_t from =
            static_cast<std::size_t>(std::max(0, row)) * static_cast<std::size_t>(map.columns());
        const int line = (row + side_) / kStep * steps;
        for (int column = 1 - side_; column < map.columns(); ++column) {
            const int place = (column + side_) / kStep;
            std::uint8_t& most = sorted_[static_cast<std::size_t>(line + place % steps) * length_ +
                                         kAcross + static_cast<std::size_t>(place >> shift_)];
            most = std::max(most, picture[from + static_cast<std::size_t>(std::max(0, column))]);
        }
    }
}

SquareLattice::Sums SquareLattice::bounds(const CorrelationMap::Pattern& pattern, int x,
                                          int y) const {
    assert(pattern.cells.size() <= kMostCells);
    const int steps = 1 << shift_;
    std::array<const std::uint8_t*, kMostCells> rows;  // what each cell meets
    std::size_t count = 0;
    for (const CorrelationMap::Cell& cell : pattern.cells) {
        // From where the lattice begins, beyond its left end too.
        const int row = cell.row + y + side_;
        const int column = cell.column + x + side_ * (1 + static_cast<int>(kAcross));
        if (row < 0 || row / kStep >= rows_ || column < 0) continue;
        const int place = column / kStep;
        const int square = place >> shift_;
        if (square >= squares_ + static_cast<int>(kAcross)) continue;
        rows[count++] =
            sorted_.data() +
            static_cast<std::size_t>(row / kStep * steps + (place & (steps - 1))) * length_ +
            static_cast<std::size_t>(square);
    }
    Sums sums{};
    vectorised([&]() HITOS_INLINED {
        Words own{};
        for (std::size_t i = 0; i < count; ++i) {
            Bytes row;
            std::memcpy(&row, rows[i], sizeof row);
            own += __builtin_convertvector(row, Words);
        }
        std::memcpy(sums.data(), &own, sizeof own);
    });
    return sums;
}

}  // namespace hitos
