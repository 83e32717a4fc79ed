// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/normal_equations.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <tuple>
#include <utility>

namespace hitos {

std::size_t NormalEquations::add_variable(int size) {
    variables_.push_back({size, size_, 0, 0, {}});
    size_ += size;
    laid_out_ = false;
    return variables_.size() - 1;
}

void NormalEquations::begin() {
    begin_gradient();
    gradient_only_ = false;
    next_place_ = 0;
    noted_.clear();
    noted_values_.clear();
    if (laid_out_) std::fill_n(h_.valuePtr(), h_.nonZeros(), 0.0);
}

void NormalEquations::begin_gradient() {
    gradient_ = Eigen::VectorXd::Zero(size_);
    gradient_only_ = true;
}

void NormalEquations::hold(std::size_t variable, double information) {
    const Eigen::Index size = variables_[variable].size;
    add_block(variable, variable, (information * Eigen::MatrixXd::Identity(size, size)).eval());
}

/// By approximate minimum degree of the blocks.
void NormalEquations::order_variables() {
    const auto count = static_cast<Eigen::Index>(variables_.size());
    std::vector<Eigen::Triplet<double>> ones;
    for (Eigen::Index i = 0; i < count; ++i) ones.emplace_back(i, i, 1.0);
    for (const Noted& noted : noted_) {
        if (noted.row == noted.column) continue;
        ones.emplace_back(noted.row, noted.column, 1.0);
        ones.emplace_back(noted.column, noted.row, 1.0);
    }
    Matrix pattern(count, count);
    pattern.setFromTriplets(ones.begin(), ones.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(pattern, order);
    order_.clear();
    Eigen::Index at = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        order_.push_back(static_cast<std::size_t>(order.indices()(i)));
        Variable& variable = variables_[order_.back()];
        variable.rank = i;
        variable.at = at;
        at += variable.size;
    }
}

bool NormalEquations::factor_fits(std::uint64_t most) {
    order_variables();
    const std::size_t count = order_.size();
    std::vector<std::vector<std::size_t>> before(count);  // ranks of what each is joined to
    for (const Noted& noted : noted_) {
        if (noted.row == noted.column) continue;
        const auto [first, second] =
            std::minmax(variables_[noted.row].rank, variables_[noted.column].rank);
        before[static_cast<std::size_t>(second)].push_back(static_cast<std::size_t>(first));
    }
    // Row by row up the elimination tree (Liu, 1990).
    std::vector<std::size_t> parent(count, count);
    std::vector<std::size_t> row_of(count, count);
    std::uint64_t numbers = 0;
    for (std::size_t row = 0; row < count; ++row) {
        const auto height = static_cast<std::uint64_t>(variables_[order_[row]].size);
        row_of[row] = row;
        numbers += height * height;
        for (std::size_t column : before[row]) {
            for (; row_of[column] != row; column = parent[column]) {
                row_of[column] = row;
                if (parent[column] == count) parent[column] = row;
                numbers += height * static_cast<std::uint64_t>(variables_[order_[column]].size);
            }
            if (numbers > most) return false;
        }
    }
    return true;
}

void NormalEquations::lay_out() {
    order_variables();
    // The blocks below the diagonal: column and row in the order of elimination, and which they
    // are.
    struct Block {
        Eigen::Index column;
        Eigen::Index row;
        std::size_t noted;
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < noted_.size(); ++i) {
        if (noted_[i].row == noted_[i].column) continue;
        const auto [first, second] =
            std::minmax(variables_[noted_[i].row].rank, variables_[noted_[i].column].rank);
        blocks.push_back({first, second, i});
    }
    std::sort(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) {
        return std::tie(a.column, a.row, a.noted) < std::tie(b.column, b.row, b.noted);
    });

    h_.resize(size_, size_);
    places_.assign(noted_.size(), {});
    std::vector<int> rows;
    std::vector<std::size_t> below;  // the variables of a column's rows
    std::size_t block = 0;
    for (const std::size_t eliminated : order_) {
        Variable& column = variables_[eliminated];
        const auto first = static_cast<Eigen::Index>(rows.size());
        below.assign(1, eliminated);
        Eigen::Index length = column.size;
        const std::size_t first_block = block;
        for (; block < blocks.size() && blocks[block].column == column.rank; ++block) {
            const std::size_t row = order_[static_cast<std::size_t>(blocks[block].row)];
            if (row != below.back()) {
                length += variables_[row].size;
                below.push_back(row);
            }
            places_[blocks[block].noted].first = first + length - variables_[row].size;
        }
        column.diagonal = {first, length, false};
        for (std::size_t b = first_block; b < block; ++b) {
            Place& place = places_[blocks[b].noted];
            place.length = length;
            place.across = noted_[blocks[b].noted].column != eliminated;
        }
        for (Eigen::Index j = 0; j < column.size; ++j) {
            h_.outerIndexPtr()[column.at + j] = static_cast<int>(rows.size());
            for (const std::size_t row : below) {
                const Variable& variable = variables_[row];
                for (Eigen::Index i = row == eliminated ? j : 0; i < variable.size; ++i) {
                    rows.push_back(static_cast<int>(variable.at + i));
                }
            }
        }
    }
    h_.outerIndexPtr()[size_] = static_cast<int>(rows.size());
    h_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::copy(rows.begin(), rows.end(), h_.innerIndexPtr());
    std::fill_n(h_.valuePtr(), rows.size(), 0.0);
    for (std::size_t i = 0; i < noted_.size(); ++i) {
        const Variable& row = variables_[noted_[i].row];
        const Variable& column = variables_[noted_[i].column];
        const bool diagonal = noted_[i].row == noted_[i].column;
        if (diagonal) places_[i] = row.diagonal;
        put(places_[i], diagonal,
            Eigen::Map<const Eigen::MatrixXd>(noted_values_.data() + noted_[i].values, row.size,
                                              column.size));
    }
    cholesky_ = std::make_unique<Cholesky>();
    cholesky_->analyzePattern(h_);
    laid_out_ = true;
}

Eigen::VectorXd NormalEquations::reordered(const Eigen::VectorXd& as_added) const {
    Eigen::VectorXd eliminated(size_);
    for (const Variable& v : variables_) {
        eliminated.segment(v.at, v.size) = as_added.segment(v.added, v.size);
    }
    return eliminated;
}

bool NormalEquations::solve() {
    if (!laid_out_) lay_out();
    cholesky_->factorize(h_);
    if (cholesky_->info() != Eigen::Success || (cholesky_->vectorD().array() <= 0.0).any()) {
        return false;
    }
    return solve_again();
}

bool NormalEquations::solve_again() {
    if (!laid_out_) return false;
    step_ = -cholesky_->solve(reordered(gradient_));
    return step_.allFinite();
}

Eigen::MatrixXd NormalEquations::marginal(std::size_t variable) const {
    const Eigen::Index size = variables_[variable].size;
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(size_, size);
    put_rows(y, variable, Eigen::MatrixXd::Identity(size, size));
    return covariance_along(std::move(y));
}

Eigen::MatrixXd NormalEquations::covariance_along(Eigen::MatrixXd y) const {
    // y' H^-1 y = z' D^-1 z with z = L^-1 y. Most of z is zero: column k of L matters only where z
    // has an entry by then.
    const Matrix& l = cholesky_->matrixL().nestedExpression();
    for (Eigen::Index k = 0; k < size_; ++k) {
        if ((y.row(k).array() == 0.0).all()) continue;
        for (Matrix::InnerIterator entry(l, k); entry; ++entry) {
            y.row(entry.row()) -= entry.value() * y.row(k);
        }
    }
    return y.transpose() * cholesky_->vectorD().cwiseInverse().asDiagonal() * y;
}

std::vector<Eigen::MatrixXd> NormalEquations::marginals() const {
    // H = P' L D L' P. With Z the inverse of L D L', Z L = L'^-1 D^-1 gives, for entries on and
    // below the diagonal, Z_jj = 1 / D_j - sum_k Z_kj L_kj and Z_ij = -sum_k Z_ik L_kj, k over the
    // entries of column j of L. Every Z_ik asked for lies where L has an entry.
    const Matrix& l = cholesky_->matrixL().nestedExpression();
    const int* const begin = l.outerIndexPtr();
    const int* const row = l.innerIndexPtr();
    std::vector<double> z(static_cast<std::size_t>(l.nonZeros()));
    Eigen::VectorXd diagonal(size_);
    std::vector<int> among(static_cast<std::size_t>(size_), -1);  // place among j's entries
    Eigen::VectorXd sums(size_);
    for (Eigen::Index j = size_; j-- > 0;) {
        const int first = begin[j];
        const int count = begin[j + 1] - first;
        const Eigen::Map<const Eigen::VectorXd> l_j(l.valuePtr() + first, count);
        for (int a = 0; a < count; ++a) among[static_cast<std::size_t>(row[first + a])] = a;
        auto sum = sums.head(count);
        sum.setZero();
        for (int a = 0; a < count; ++a) {
            const int k = row[first + a];
            sum(a) += diagonal(k) * l_j(a);
            for (int at = begin[k]; at < begin[k + 1]; ++at) {
                const int b = among[static_cast<std::size_t>(row[at])];
                if (b < 0) continue;
                sum(b) += z[static_cast<std::size_t>(at)] * l_j(a);
                sum(a) += z[static_cast<std::size_t>(at)] * l_j(b);
            }
        }
        for (int a = 0; a < count; ++a) {
            const auto at = first + a;
            z[static_cast<std::size_t>(at)] = -sum(a);
            among[static_cast<std::size_t>(row[first + a])] = -1;
        }
        diagonal(j) = 1.0 / cholesky_->vectorD()(j) + sum.dot(l_j);
    }
    const auto entry = [&](Eigen::Index a, Eigen::Index b) {
        const Eigen::Index i = std::max(a, b);
        const Eigen::Index j = std::min(a, b);
        if (i == j) return diagonal(i);
        const int* const found = std::lower_bound(row + begin[j], row + begin[j + 1], i);
        const bool there = found != row + begin[j + 1] && *found == i;
        return there ? z[static_cast<std::size_t>(found - row)] : 0.0;  // only held: no block
    };
    std::vector<Eigen::MatrixXd> blocks;
    for (const Variable& v : variables_) {
        blocks.emplace_back(Eigen::MatrixXd::NullaryExpr(
            v.size, v.size,
            [&](Eigen::Index a, Eigen::Index b) { return entry(v.at + a, v.at + b); }));
    }
    return blocks;
}

Eigen::MatrixXd NormalEquations::covariance(std::size_t first, const Eigen::MatrixXd& j_first,
                                            std::size_t second,
                                            const Eigen::MatrixXd& j_second) const {
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(size_, j_first.rows());
    put_rows(y, first, j_first);
    put_rows(y, second, j_second);
    return covariance_along(std::move(y));
}

}  // namespace hitos
