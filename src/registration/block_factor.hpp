// SPDX-License-Identifier: GPL-3.0-or-later
// The factor of a sparse symmetric matrix of blocks.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hitos {

/// L D L', with rows and columns in the order in which variables are eliminated. Where blocks of L
/// are not 0 the columns of a variable stand together as one dense panel, its own rows first; each
/// is made of those before that have rows in common with it (left-looking, with dense updates: Ng
/// and Peyton, 1993). The same bits with any vectors.
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
    /// Calls body(row, number) for the entries of L below the diagonal in a column of a variable.
    template <class Body>
    void each_below(Rank column, std::size_t c, const Body& body) const;
    std::size_t count() const { return sizes_.size(); }
    double* panel(Rank column) { return values_.data() + panels_[column]; }
    const double* panel(Rank column) const { return values_.data() + panels_[column]; }
    /// Blocks below the diagonal, as places in rows_ and offsets_.
    std::size_t begin(Rank column) const { return begins_[column]; }
    std::size_t end(Rank column) const { return begins_[column + 1]; }

    std::vector<std::uint32_t> sizes_;
    std::vector<std::size_t> at_;         // first row of each variable
    std::vector<std::size_t> begins_;     // of each column's blocks in rows_
    std::vector<Rank> rows_;              // of L's blocks below the diagonal, column by column
    std::vector<std::uint32_t> offsets_;  // the first row of each in its panel
    std::vector<std::uint32_t> heights_;  // of panels
    std::vector<std::size_t> panels_;     // where they begin in values_
    std::vector<double> values_;
    Eigen::VectorXd d_;
};

}  // namespace hitos
