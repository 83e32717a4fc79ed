// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_factor.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

constexpr auto kNone = std::numeric_limits<BlockFactor::Rank>::max();
constexpr auto kNowhere = std::numeric_limits<std::size_t>::max();

/// Rows of a panel, of as many columns as the variable has numbers.
struct Rows {
    const double* first;
    std::size_t stride;
    std::size_t count;
    std::size_t columns;
};

/// sum = rows * D * (their first `wide`)', `wide` columns of as many rows.
template <std::size_t kColumns>
HITOS_INLINE void multiply(const Rows& rows, const double* d, std::size_t wide,
                           double* __restrict sum) {
    const std::size_t columns = kColumns == 0 ? rows.columns : kColumns;
    for (std::size_t c = 0; c < wide; ++c) {
        double* const to = sum + c * rows.count;
        if constexpr (kColumns == 3) {
            const double* const x = rows.first;
            const double* const y = x + rows.stride;
            const double* const z = y + rows.stride;
            const double by_x = d[0] * x[c];
            const double by_y = d[1] * y[c];
            const double by_z = d[2] * z[c];
            HITOS_LANES
            for (std::size_t r = 0; r < rows.count; ++r)
                to[r] = x[r] * by_x + y[r] * by_y + z[r] * by_z;
        } else {
            std::fill_n(to, rows.count, 0.0);
            for (std::size_t a = 0; a < columns; ++a) {
                const double* const from = rows.first + a * rows.stride;
                const double by = d[a] * from[c];
                HITOS_LANES
                for (std::size_t r = 0; r < rows.count; ++r) to[r] += from[r] * by;
            }
        }
    }
}

/// Makes the first `wide` columns of a panel those of L. False where a number of D is not above 0.
HITOS_INLINE bool eliminate(double* panel, std::size_t height, std::size_t wide, double* d) {
    for (std::size_t c = 0; c < wide; ++c) {
        double* const column = panel + c * height;
        d[c] = column[c];
        if (!(d[c] > 0.0)) return false;
        for (std::size_t other = c + 1; other < wide; ++other) {
            double* const to = panel + other * height;
            const double by = column[other] / d[c];
            HITOS_LANES
            for (std::size_t r = other; r < height; ++r) to[r] -= column[r] * by;
        }
        const double by = 1.0 / d[c];
        HITOS_LANES
        for (std::size_t r = c + 1; r < height; ++r) column[r] *= by;
    }
    return true;
}

}  // namespace

BlockFactor::BlockFactor(std::vector<std::uint32_t> sizes, std::span<const Block> blocks)
    : sizes_(std::move(sizes)) {
    // Rows of a column are those of the matrix, and those of columns whose first row it is.
    std::vector<std::vector<Rank>> rows(count());
    for (const Block& block : blocks) {
        if (block.row != block.column) rows[block.column].push_back(block.row);
    }
    std::size_t at = 0;
    std::size_t numbers = 0;
    begins_.push_back(0);
    for (Rank column = 0; column < count(); ++column) {
        std::vector<Rank>& below = rows[column];
        std::ranges::sort(below);
        below.erase(std::ranges::unique(below).begin(), below.end());
        if (!below.empty()) {
            std::vector<Rank>& up = rows[below.front()];
            up.insert(up.end(), below.begin() + 1, below.end());
        }
        at_.push_back(at);
        at += sizes_[column];
        std::uint32_t height = sizes_[column];
        for (const Rank row : below) {
            rows_.push_back(row);
            offsets_.push_back(height);
            height += sizes_[row];
        }
        begins_.push_back(rows_.size());
        heights_.push_back(height);
        panels_.push_back(numbers);
        numbers += static_cast<std::size_t>(height) * sizes_[column];
        below = {};
    }
    values_.resize(numbers);
    d_.resize(static_cast<Eigen::Index>(at));
}

BlockFactor::Place BlockFactor::place(Rank row, Rank column) {
    std::size_t offset = 0;
    if (row != column) {
        const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(begin(column));
        const auto last = rows_.begin() + static_cast<std::ptrdiff_t>(end(column));
        offset =
            offsets_[static_cast<std::size_t>(std::lower_bound(first, last, row) - rows_.begin())];
    }
    return {panel(column) + offset, heights_[column]};
}

void BlockFactor::clear() {
    std::ranges::fill(values_, 0.0);
}

bool BlockFactor::factorize() {
    // Of each row the columns that are eliminated and have not been used for it: the first, and
    // from each the next one; and of each such column the block in that row.
    std::vector<Rank> first(count(), kNone);
    std::vector<Rank> next(count(), kNone);
    std::vector<std::size_t> block(count());
    const auto waits_for_next_row = [&](Rank column) {
        if (block[column] == end(column)) return;
        next[column] = std::exchange(first[rows_[block[column]]], column);
    };
    std::vector<std::size_t> offset_of(count());  // of the rows of the panel at hand
    std::vector<double> sum;
    struct Run {
        std::size_t from;
        std::size_t to;
        std::size_t length;
    };
    std::vector<Run> run(count());
    bool positive = true;
    vectorised([&]() HITOS_INLINED {
        for (Rank column = 0; column < count(); ++column) {
            double* const to = panel(column);
            const std::size_t height = heights_[column];
            const std::size_t wide = sizes_[column];
            offset_of[column] = 0;
            for (std::size_t i = begin(column); i < end(column); ++i)
                offset_of[rows_[i]] = offsets_[i];
            for (Rank earlier = first[column]; earlier != kNone;) {
                const Rank other = next[earlier];
                const std::size_t begin_block = block[earlier]++;
                const std::size_t offset = offsets_[begin_block];
                const Rows rows{panel(earlier) + offset, heights_[earlier],
                                heights_[earlier] - offset, sizes_[earlier]};
                sum.resize(std::max(sum.size(), rows.count * wide));
                const double* const d = d_.data() + at_[earlier];
                if (rows.columns == 3) {
                    multiply<3>(rows, d, wide, sum.data());
                } else {
                    multiply<0>(rows, d, wide, sum.data());
                }
                std::size_t runs = 0;  // of rows that follow each other in both panels
                std::size_t behind = kNowhere;
                for (std::size_t i = begin_block; i < end(earlier); ++i) {
                    const std::size_t at = offset_of[rows_[i]];
                    if (at != behind) run[runs++] = {offsets_[i] - offset, at, 0};
                    run[runs - 1].length += sizes_[rows_[i]];
                    behind = at + sizes_[rows_[i]];
                }
                for (std::size_t c = 0; c < wide; ++c) {
                    for (std::size_t i = 0; i < runs; ++i) {
                        const double* const part = sum.data() + c * rows.count + run[i].from;
                        double* const into = to + c * height + run[i].to;
                        HITOS_LANES
                        for (std::size_t r = 0; r < run[i].length; ++r) into[r] -= part[r];
                    }
                }
                waits_for_next_row(earlier);
                earlier = other;
            }
            positive = eliminate(to, height, wide, d_.data() + at_[column]);
            if (!positive) return;
            block[column] = begin(column);
            waits_for_next_row(column);
        }
    });
    return positive;
}

template <class Body>
void BlockFactor::each_below(Rank column, std::size_t c, const Body& body) const {
    const double* const l = panel(column) + c * heights_[column];
    for (std::size_t r = c + 1; r < sizes_[column]; ++r) body(at_[column] + r, l[r]);
    for (std::size_t i = begin(column); i < end(column); ++i) {
        const std::size_t at = at_[rows_[i]];
        for (std::size_t r = 0; r < sizes_[rows_[i]]; ++r) body(at + r, l[offsets_[i] + r]);
    }
}

void BlockFactor::solve(Eigen::VectorXd& x) const {
    double* const of = x.data();
    for (Rank column = 0; column < count(); ++column) {
        for (std::size_t c = 0; c < sizes_[column]; ++c) {
            const double known = of[at_[column] + c];
            each_below(column, c, [&](std::size_t row, double l) { of[row] -= l * known; });
        }
    }
    x = x.cwiseQuotient(d_);
    for (Rank column = static_cast<Rank>(count()); column-- > 0;) {
        for (std::size_t c = sizes_[column]; c-- > 0;) {
            double known = 0.0;
            each_below(column, c, [&](std::size_t row, double l) { known += l * of[row]; });
            of[at_[column] + c] -= known;
        }
    }
}

void BlockFactor::reduce(Eigen::MatrixXd& y) const {
    for (Rank column = 0; column < count(); ++column) {
        for (std::size_t c = 0; c < sizes_[column]; ++c) {
            const auto k = static_cast<Eigen::Index>(at_[column] + c);
            if ((y.row(k).array() == 0.0).all()) continue;
            each_below(column, c, [&](std::size_t row, double l) {
                y.row(static_cast<Eigen::Index>(row)) -= l * y.row(k);
            });
        }
    }
}

std::vector<Eigen::MatrixXd> BlockFactor::inverse_blocks() const {
    // With Z the inverse of L D L', Z L = L'^-1 D^-1 gives, for entries on and below the diagonal,
    // Z_jj = 1 / D_j - sum_k Z_kj L_kj and Z_ij = -sum_k Z_ik L_kj, k over the entries of column j
    // of L. Every Z_ik asked for lies where L has an entry.
    std::vector<std::size_t> begins{0};  // of columns
    std::vector<std::size_t> rows;
    std::vector<double> l;
    for (Rank column = 0; column < count(); ++column) {
        for (std::size_t c = 0; c < sizes_[column]; ++c) {
            each_below(column, c, [&](std::size_t row, double value) {
                rows.push_back(row);
                l.push_back(value);
            });
            begins.push_back(rows.size());
        }
    }
    constexpr auto kOutside = std::numeric_limits<std::size_t>::max();
    const auto size = static_cast<std::size_t>(d_.size());
    std::vector<double> z(l.size());
    std::vector<double> diagonal(size);
    std::vector<std::size_t> among(size, kOutside);  // place among j's entries
    std::vector<double> sums;
    for (std::size_t j = size; j-- > 0;) {
        const std::size_t first = begins[j];
        const std::size_t entries = begins[j + 1] - first;
        for (std::size_t a = 0; a < entries; ++a) among[rows[first + a]] = a;
        sums.assign(entries, 0.0);
        for (std::size_t a = 0; a < entries; ++a) {
            const std::size_t k = rows[first + a];
            const double l_a = l[first + a];
            sums[a] += diagonal[k] * l_a;
            for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) {
                const std::size_t b = among[rows[i]];
                if (b == kOutside) continue;
                sums[b] += z[i] * l_a;
                sums[a] += z[i] * l[first + b];
            }
        }
        double own = 1.0 / d_(static_cast<Eigen::Index>(j));
        for (std::size_t a = 0; a < entries; ++a) {
            z[first + a] = -sums[a];
            own += sums[a] * l[first + a];
            among[rows[first + a]] = kOutside;
        }
        diagonal[j] = own;
    }
    const auto entry = [&](std::size_t a, std::size_t b) {
        const auto [j, i] = std::minmax(a, b);
        if (i == j) return diagonal[i];
        return z[static_cast<std::size_t>(
            std::lower_bound(rows.begin() + static_cast<std::ptrdiff_t>(begins[j]),
                             rows.begin() + static_cast<std::ptrdiff_t>(begins[j + 1]), i) -
            rows.begin())];
    };
    std::vector<Eigen::MatrixXd> blocks;
    blocks.reserve(count());
    for (Rank of = 0; of < count(); ++of) {
        const auto wide = static_cast<Eigen::Index>(sizes_[of]);
        blocks.emplace_back(
            Eigen::MatrixXd::NullaryExpr(wide, wide, [&](Eigen::Index a, Eigen::Index b) {
                return entry(at_[of] + static_cast<std::size_t>(a),
                             at_[of] + static_cast<std::size_t>(b));
            }));
    }
    return blocks;
}

}  // namespace hitos
