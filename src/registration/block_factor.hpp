// SPDX-License-Identifier: GPL-3.0-or-later
// The factor of a sparse symmetric matrix of blocks.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hitos {

/// L D L', with rows and columns in the order in which variables are eliminated. Variables that
/// follow each other and have the same rows below stand together as one dense panel, their own rows
/// first; each panel is made of those before that have rows in common with it (left-looking, with
/// dense updates of supernodes: Ng and Peyton, 1993). The same bits with any vectors.
class BlockFactor {
  public:
    using Rank = std::uint32_t;  // of a variable as it is eliminated
    /// A block of the matrix, on or below the diagonal.
    struct Block {
        Rank column;
        Rank row;
    };
    /// Numbers column by column, each `stride` behind the last.
    struct Place {
        double* first;
        Eigen::Index stride;
    };

    /// `sizes`: numbers of each variable; `blocks` in any order, some perhaps more than once.
    BlockFactor(std::vector<std::uint32_t> sizes, std::span<const Block> blocks);

    /// Where the matrix is to be written before factorize(), of a block that was told or one on the
    /// diagonal, of which the lower half counts.
    Place place(Rank row, Rank column);
    /// All 0.
    void clear();
    /// Makes the factor of what was written, in its place. False where it is not positive definite.
    bool factorize();

    /// x becomes the solution for x on the right.
    void solve(Eigen::VectorXd& x) const;
    /// y becomes L^-1 y, of which most is 0.
    void reduce(Eigen::MatrixXd& y) const;
    const Eigen::VectorXd& d() const { return d_; }
    /// Blocks on the diagonal of the inverse, by variable: H^-1 where L has entries, column by
    /// column from the last (Takahashi, Fagan and Chen, 1973).
    std::vector<Eigen::MatrixXd> inverse_blocks() const;

  private:
    /// Variables that stand together.
    struct Panel {
        Rank first;          // of its variables
        std::size_t at;      // their first row
        std::size_t wide;    // numbers of its variables
        std::size_t height;  // and of its rows
        std::size_t rows;    // where its blocks below begin in rows_ and offsets_
        std::size_t rows_end;
        std::size_t values;  // where it begins in values_
    };
    void lay_out(std::span<const std::vector<Rank>> rows);
    /// Calls body(row, number) for the entries of L below the diagonal in a column of a panel.
    template <class Body>
    void each_below(const Panel& panel, std::size_t c, const Body& body) const;
    double* values(const Panel& panel) { return values_.data() + panel.values; }
    const double* values(const Panel& panel) const { return values_.data() + panel.values; }
    std::size_t own_offset(Rank variable) const {
        return at_[variable] - panels_[panel_of_[variable]].at;
    }

    std::vector<std::uint32_t> sizes_;
    std::vector<std::size_t> at_;          // first row of each variable
    std::vector<std::uint32_t> panel_of_;  // each variable
    std::vector<Panel> panels_;
    std::vector<Rank> rows_;            // variables below the diagonal, panel by panel
    std::vector<std::size_t> offsets_;  // the first row of each in its panel
    std::vector<double> values_;
    Eigen::VectorXd d_;
};

}  // namespace hitos
