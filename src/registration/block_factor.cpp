// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_factor.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
constexpr auto kNowhere = std::numeric_limits<std::size_t>::max();

/// Rows of a panel, of all its columns.
struct Rows {
    const double* first;
    std::size_t stride;
    std::size_t count;
    std::size_t columns;
};

/// sum = rows * D * (their first `wide`)', `wide` columns of as many rows. A panel of variables of
/// three numbers has three columns, or six, or nine.
HITOS_INLINE void multiply(const Rows& rows, const double* d, std::size_t wide,
                           double* __restrict sum) {
    for (std::size_t c = 0; c < wide; ++c) {
        double* const to = sum + c * rows.count;
        std::fill_n(to, rows.count, 0.0);
        std::size_t a = 0;
        for (; a + 3 <= rows.columns; a += 3) {
            const double* const x = rows.first + a * rows.stride;
            const double* const y = x + rows.stride;
            const double* const z = y + rows.stride;
            const double by_x = d[a] * x[c];
            const double by_y = d[a + 1] * y[c];
            const double by_z = d[a + 2] * z[c];
            HITOS_LANES
            for (std::size_t r = 0; r < rows.count; ++r)
                to[r] += x[r] * by_x + y[r] * by_y + z[r] * by_z;
        }
        for (; a < rows.columns; ++a) {
            const double* const from = rows.first + a * rows.stride;
            const double by = d[a] * from[c];
            HITOS_LANES
            for (std::size_t r = 0; r < rows.count; ++r) to[r] += from[r] * by;
        }
    }
}

/// Makes the `wide` columns of a panel those of L. False where a number of D is not above 0.
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
    std::vector<std::vector<Rank>> rows(sizes_.size());
    for (const Block& block : blocks) {
        if (block.row != block.column) rows[block.column].push_back(block.row);
    }
    for (std::vector<Rank>& below : rows) {
        std::ranges::sort(below);
        below.erase(std::unique(below.begin(), below.end()), below.end());
        if (below.empty()) continue;
        std::vector<Rank>& up = rows[below.front()];
        up.insert(up.end(), below.begin() + 1, below.end());
    }
    lay_out(rows);
}

void BlockFactor::lay_out(std::span<const std::vector<Rank>> rows) {
    std::size_t at = 0;
    std::size_t numbers = 0;
    for (Rank first = 0; first < rows.size();) {
        Panel panel{first, at, 0, 0, rows_.size(), 0, numbers};
        Rank last = first;
        // The next one has the same rows but itself: it is one of them, and there are no more. A
        // panel keeps what is above its diagonal too, so it may not be of any width.
        constexpr std::size_t kWidest = 64;
        std::size_t wide = sizes_[first];
        while (!rows[last].empty() && rows[last].front() == last + 1 &&
               rows[last].size() == rows[last + 1].size() + 1 &&
               wide + sizes_[last + 1] <= kWidest) {
            wide += sizes_[++last];
        }
        for (; first <= last; ++first) {
            at_.push_back(at);
            panel_of_.push_back(static_cast<std::uint32_t>(panels_.size()));
            at += sizes_[first];
        }
        panel.wide = panel.height = at - panel.at;
        for (const Rank row : rows[last]) {
            rows_.push_back(row);
            offsets_.push_back(panel.height);
            panel.height += sizes_[row];
        }
        panel.rows_end = rows_.size();
        numbers += panel.height * panel.wide;
        panels_.push_back(panel);
    }
    values_.resize(numbers);
    d_.resize(static_cast<Eigen::Index>(at));
}

BlockFactor::Place BlockFactor::place(Rank row, Rank column) {
    const Panel& panel = panels_[panel_of_[column]];
    std::size_t offset = 0;
    if (panel_of_[row] == panel_of_[column]) {
        offset = own_offset(row);
    } else {
        const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(panel.rows);
        const auto last = rows_.begin() + static_cast<std::ptrdiff_t>(panel.rows_end);
        offset =
            offsets_[static_cast<std::size_t>(std::lower_bound(first, last, row) - rows_.begin())];
    }
    return {values(panel) + own_offset(column) * panel.height + offset,
            static_cast<Eigen::Index>(panel.height)};
}

void BlockFactor::clear() {
    std::ranges::fill(values_, 0.0);
}

bool BlockFactor::factorize() {
    // Of each panel those that are eliminated and have not been used for it: the first, and from
    // each the next one; and of each such panel the block that comes next.
    std::vector<std::uint32_t> first(panels_.size(), kNone);
    std::vector<std::uint32_t> next(panels_.size(), kNone);
    std::vector<std::size_t> block(panels_.size());
    const auto waits_for_next_rows = [&](std::uint32_t panel) {
        if (block[panel] == panels_[panel].rows_end) return;
        next[panel] = std::exchange(first[panel_of_[rows_[block[panel]]]], panel);
    };
    std::vector<std::size_t> offset_of(sizes_.size());  // of the rows of the panel at hand
    std::vector<double> sum;
    struct Run {
        std::size_t from;
        std::size_t to;
        std::size_t length;
    };
    std::vector<Run> run(sizes_.size());
    bool positive = true;
    vectorised([&]() HITOS_INLINED {
        for (std::uint32_t number = 0; number < panels_.size(); ++number) {
            const Panel& panel = panels_[number];
            double* const to = values(panel);
            for (Rank own = panel.first; own < sizes_.size() && panel_of_[own] == number; ++own)
                offset_of[own] = own_offset(own);
            for (std::size_t i = panel.rows; i < panel.rows_end; ++i)
                offset_of[rows_[i]] = offsets_[i];
            for (std::uint32_t other = first[number]; other != kNone;) {
                const Panel& earlier = panels_[other];
                const std::size_t begin = block[other];
                const std::size_t offset = offsets_[begin];
                std::size_t runs = 0;  // of rows that follow each other in both panels
                std::size_t behind = kNowhere;
                std::size_t wide = 0;  // numbers of the variables of this panel among them
                for (std::size_t i = begin; i < earlier.rows_end; ++i) {
                    const std::size_t size = sizes_[rows_[i]];
                    const std::size_t at = offset_of[rows_[i]];
                    if (at != behind) run[runs++] = {offsets_[i] - offset, at, 0};
                    run[runs - 1].length += size;
                    behind = at + size;
                    if (panel_of_[rows_[i]] != number) continue;
                    wide += size;
                    ++block[other];
                }
                const Rows rows{values(earlier) + offset, earlier.height, earlier.height - offset,
                                earlier.wide};
                sum.resize(std::max(sum.size(), rows.count * wide));
                multiply(rows, d_.data() + earlier.at, wide, sum.data());
                // The first rows say which columns these are.
                for (std::size_t i = 0, c = 0; c < wide; ++i) {
                    for (std::size_t k = 0; k < run[i].length && c < wide; ++k, ++c) {
                        double* const column = to + (run[i].to + k) * panel.height;
                        for (std::size_t j = 0; j < runs; ++j) {
                            const double* const part = sum.data() + c * rows.count + run[j].from;
                            double* const into = column + run[j].to;
                            HITOS_LANES
                            for (std::size_t r = 0; r < run[j].length; ++r) into[r] -= part[r];
                        }
                    }
                }
                const std::uint32_t following = next[other];
                waits_for_next_rows(other);
                other = following;
            }
            positive = eliminate(to, panel.height, panel.wide, d_.data() + panel.at);
            if (!positive) return;
            block[number] = panel.rows;
            waits_for_next_rows(number);
        }
    });
    return positive;
}

template <class Body>
void BlockFactor::each_below(const Panel& panel, std::size_t c, const Body& body) const {
    const double* const l = values(panel) + c * panel.height;
    for (std::size_t r = c + 1; r < panel.wide; ++r) body(panel.at + r, l[r]);
    for (std::size_t i = panel.rows; i < panel.rows_end; ++i) {
        const std::size_t at = at_[rows_[i]];
        for (std::size_t r = 0; r < sizes_[rows_[i]]; ++r) body(at + r, l[offsets_[i] + r]);
    }
}

void BlockFactor::solve(Eigen::VectorXd& x) const {
    double* const of = x.data();
    for (const Panel& panel : panels_) {
        for (std::size_t c = 0; c < panel.wide; ++c) {
            const double known = of[panel.at + c];
            each_below(panel, c, [&](std::size_t row, double l) { of[row] -= l * known; });
        }
    }
    x = x.cwiseQuotient(d_);
    for (std::size_t i = panels_.size(); i-- > 0;) {
        for (std::size_t c = panels_[i].wide; c-- > 0;) {
            double known = 0.0;
            each_below(panels_[i], c, [&](std::size_t row, double l) { known += l * of[row]; });
            of[panels_[i].at + c] -= known;
        }
    }
}

void BlockFactor::reduce(Eigen::MatrixXd& y) const {
    for (const Panel& panel : panels_) {
        for (std::size_t c = 0; c < panel.wide; ++c) {
            const auto k = static_cast<Eigen::Index>(panel.at + c);
            if ((y.row(k).array() == 0.0).all()) continue;
            each_below(panel, c, [&](std::size_t row, double l) {
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
    std::vector<std::uint32_t> rows;
    std::vector<double> l;
    for (const Panel& panel : panels_) {
        for (std::size_t c = 0; c < panel.wide; ++c) {
            each_below(panel, c, [&](std::size_t row, double value) {
                rows.push_back(static_cast<std::uint32_t>(row));
                l.push_back(value);
            });
            begins.push_back(rows.size());
        }
    }
    const auto size = static_cast<std::size_t>(d_.size());
    std::vector<double> z(l.size());
    std::vector<double> diagonal(size);
    std::vector<std::size_t> among(size, kNowhere);  // place among j's entries
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
                if (b == kNowhere) continue;
                sums[b] += z[i] * l_a;
                sums[a] += z[i] * l[first + b];
            }
        }
        double own = 1.0 / d_(static_cast<Eigen::Index>(j));
        for (std::size_t a = 0; a < entries; ++a) {
            z[first + a] = -sums[a];
            own += sums[a] * l[first + a];
            among[rows[first + a]] = kNowhere;
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
    blocks.reserve(sizes_.size());
    for (Rank of = 0; of < sizes_.size(); ++of) {
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
