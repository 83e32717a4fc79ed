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

constexpr int kBefore = SquareLattice::kAcross + 1;  // squares to the left of the picture

}  // namespace

SquareLattice::SquareLattice(const CorrelationMap& map)
    : side_(1 << map.levels()),
      shift_(map.levels() - 2),
      rows_((map.rows() + side_ - 1) / kStep + 1),
      squares_((map.columns() + side_ - 1) / side_ + 1),
      length_(static_cast<std::size_t>(squares_) + 2 * kAcross) {
    assert(shift_ >= 0);
    static_assert(kStep == 1 << 2);
    sorted_.resize(static_cast<std::size_t>(rows_ << shift_) * length_);
    const std::span<const std::uint8_t> picture = map.coarsest();
    // A square that begins before the picture may reach into it.
    for (int row = 1 - side_; row < map.rows(); ++row) {
        const std::size_t from =
            static_cast<std::size_t>(std::max(0, row)) * static_cast<std::size_t>(map.columns());
        for (int column = 1 - side_; column < map.columns(); ++column) {
            std::uint8_t& most = sorted_[place_of(row + side_, column + kBefore * side_)];
            most = std::max(most, picture[from + static_cast<std::size_t>(std::max(0, column))]);
        }
    }
}

std::size_t SquareLattice::place_of(int row, int column) const {
    const int place = column / kStep;
    const int line = (row / kStep << shift_) + (place & ((1 << shift_) - 1));
    return static_cast<std::size_t>(line) * length_ + static_cast<std::size_t>(place >> shift_);
}

SquareLattice::Sums SquareLattice::bounds(const CorrelationMap::Pattern& pattern, int x,
                                          int y) const {
    assert(pattern.cells.size() <= kMostCells);
    std::array<const std::uint8_t*, kMostCells> rows;  // what each cell meets
    std::size_t count = 0;
    for (const CorrelationMap::Cell& cell : pattern.cells) {
        const int row = cell.row + y + side_;
        const int column = cell.column + x + kBefore * side_;
        if (row < 0 || row / kStep >= rows_) continue;
        if (column < 0 || column >= (squares_ + kBefore - 1) * side_) continue;
        rows[count++] = sorted_.data() + place_of(row, column);
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
