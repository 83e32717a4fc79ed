// SPDX-License-Identifier: GPL-3.0-or-later
// Matrices of many rows and few columns, for products that are limited by arithmetic alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "hitos/base/memory_need.hpp"
#include "hitos/base/vectorised.hpp"

namespace hitos {

/// 32 components of a column, on cache lines of their own.
struct alignas(64) Strip {
    static constexpr std::size_t kRows = 32;
    std::array<double, kRows> values{};
};

/// Panels of 32 rows, in each of which strip follows strip, column by column: all that a product
/// needs of a panel lies together.
class TallMatrix {
  public:
    static constexpr std::size_t kRows = Strip::kRows;

    std::size_t panels() const { return panels_; }
    std::size_t columns() const { return columns_; }
    double* panel(std::size_t place) { return strips_[place * columns_].values.data(); }
    const double* panel(std::size_t place) const { return strips_[place * columns_].values.data(); }
    double& operator()(std::size_t row, std::size_t column) {
        return strips_[row / kRows * columns_ + column].values[row % kRows];
    }
    double operator()(std::size_t row, std::size_t column) const {
        return strips_[row / kRows * columns_ + column].values[row % kRows];
    }
    std::size_t bytes() const { return strips_.capacity() * sizeof(Strip); }

    /// More panels, of zeros, or fewer.
    void set_panels(std::size_t panels) {
        const std::size_t strips = panels * columns_;
        if (strips > strips_.capacity()) {
            const std::size_t room = strips + strips / 4;
            require_memory(room * sizeof(Strip));
            strips_.reserve(room);
        }
        strips_.resize(strips);
        panels_ = panels;
    }
    /// Another shape. What it holds is of no use afterwards.
    void reshape(std::size_t panels, std::size_t columns) {
        columns_ = columns;
        set_panels(panels);
    }
    /// The same with more columns, of zeros, or fewer.
    void set_columns(std::size_t columns) {
        TallMatrix other;
        other.reshape(panels_, columns);
        for (std::size_t p = 0; p < panels_; ++p) {
            for (std::size_t c = 0; c < std::min(columns, columns_); ++c) {
                other.strips_[p * columns + c] = strips_[p * columns_ + c];
            }
        }
        *this = std::move(other);
    }

  private:
    std::vector<Strip> strips_;
    std::size_t panels_ = 0;
    std::size_t columns_ = 0;
};

/// How many terms subtract_products() takes for so many.
constexpr std::size_t whole_terms(std::size_t terms) {
    return (terms + 3) / 4 * 4;
}

/// Two columns of a panel less four terms each; both compilers keep the whole inner loop in
/// registers, of whatever width. Every element's terms are taken one after the other.
HITOS_INLINE void subtract_four_terms(double* to, const double* factors, const double* by,
                                      std::size_t stride) {
    constexpr std::size_t kRows = Strip::kRows;
    double* const second = to + kRows;
    const double a0 = by[0];
    const double a1 = by[stride];
    const double a2 = by[2 * stride];
    const double a3 = by[3 * stride];
    const double b0 = by[1];
    const double b1 = by[stride + 1];
    const double b2 = by[2 * stride + 1];
    const double b3 = by[3 * stride + 1];
    HITOS_LANES
    for (std::size_t i = 0; i < kRows; ++i) {
        const double f0 = factors[i];
        const double f1 = factors[kRows + i];
        const double f2 = factors[2 * kRows + i];
        const double f3 = factors[3 * kRows + i];
        to[i] = (((to[i] - f0 * a0) - f1 * a1) - f2 * a2) - f3 * a3;
        second[i] = (((second[i] - f0 * b0) - f1 * b1) - f2 * b2) - f3 * b3;
    }
}

/// to -= factors by, of one panel: `to` has an even number of columns, `factors` `terms` of them, a
/// multiple of four, and by(k, c) is by[k stride + c].
HITOS_INLINE void subtract_products(double* to, std::size_t columns, const double* factors,
                                    const double* by, std::size_t stride, std::size_t terms) {
    for (std::size_t c = 0; c < columns; c += 2) {
        for (std::size_t k = 0; k < terms; k += 4) {
            subtract_four_terms(to + c * Strip::kRows, factors + k * Strip::kRows,
                                by + k * stride + c, stride);
        }
    }
}

}  // namespace hitos
