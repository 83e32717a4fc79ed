// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_matrix.hpp"

namespace hitos {

void HalfMatrix::resize(std::size_t size) {
    for (std::size_t i = size; i < size_; ++i) {  // they may come again
        for (std::size_t j = 0; j <= i; ++j) set(i, j, 0.0);
    }
    const std::size_t rows = (size + kTile - 1) / kTile;
    if (rows > tiles_.size()) require_memory(rows * (rows + 1) / 2 * sizeof(Tile));
    while (tiles_.size() > rows) tiles_.pop_back();
    while (tiles_.size() < rows) tiles_.emplace_back(tiles_.size() + 1);
    size_ = size;
}

void HalfMatrix::set(std::size_t i, std::size_t j, double value) {
    const std::size_t row = std::max(i, j);
    const std::size_t column = std::min(i, j);
    Tile& there = tile(row / kTile, column / kTile);
    there.values[column % kTile * kTile + row % kTile] = value;
    if (row / kTile == column / kTile) there.values[row % kTile * kTile + column % kTile] = value;
}

void HalfMatrix::read_column(std::size_t column, TallMatrix& out, std::size_t to) const {
    const std::size_t own = column / kTile;
    const std::size_t within = column % kTile;
    for (std::size_t p = 0; p < out.panels(); ++p) {
        double* const strip = out.panel(p) + to * kTile;
        if (p >= own) {
            std::copy_n(tile(p, own).values.begin() + within * kTile, kTile, strip);
        } else {
            const Tile& across = tile(own, p);
            for (std::size_t i = 0; i < kTile; ++i) strip[i] = across.values[i * kTile + within];
        }
    }
}

void HalfMatrix::write_column(std::size_t column, const TallMatrix& in, std::size_t from) {
    const std::size_t own = column / kTile;
    const std::size_t within = column % kTile;
    for (std::size_t p = 0; p < in.panels(); ++p) {
        const double* const strip = in.panel(p) + from * kTile;
        if (p >= own) {
            std::copy_n(strip, kTile, tile(p, own).values.begin() + within * kTile);
        }
        if (p <= own) {
            Tile& across = tile(own, p);
            for (std::size_t i = 0; i < kTile; ++i) across.values[i * kTile + within] = strip[i];
        }
    }
}

void HalfMatrix::subtract_square(const TallMatrix& u, std::size_t terms) {
    vectorised([&]() HITOS_INLINED {
        for (std::size_t row = 0; row < tiles_.size(); ++row) {
            for (std::size_t column = 0; column <= row; ++column) {
                subtract_products(tile(row, column).values.data(), kTile, u.panel(row),
                                  u.panel(column), kTile, terms);
            }
        }
    });
}

void HalfMatrix::negate(std::size_t at) {
    for (std::size_t i = 0; i < size_; ++i) {
        if (i != at) set(i, at, -(*this)(i, at));
    }
}

void HalfMatrix::remove(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i + count < size_; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            set(i, j, (*this)(i + count, j < first ? j : j + count));
        }
    }
    resize(size_ - count);
}

std::size_t HalfMatrix::bytes() const {
    std::size_t tiles = 0;
    for (const std::vector<Tile>& row : tiles_) tiles += row.capacity();
    return tiles * sizeof(Tile);
}

}  // namespace hitos
