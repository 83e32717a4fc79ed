// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/normal_equations.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

#include "block_factor.hpp"

namespace hitos {

NormalEquations::NormalEquations() = default;
NormalEquations::NormalEquations(NormalEquations&&) noexcept = default;
NormalEquations& NormalEquations::operator=(NormalEquations&&) noexcept = default;
NormalEquations::~NormalEquations() = default;

std::size_t NormalEquations::add_variable(int size) {
    variables_.push_back({size, size_, 0, 0});
    size_ += size;
    factor_.reset();
    factored_ = false;
    return variables_.size() - 1;
}

void NormalEquations::begin() {
    begin_gradient();
    gradient_only_ = false;
    next_place_ = 0;
    noted_.clear();
    noted_values_.clear();
    factored_ = false;
    if (factor_) factor_->clear();
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
    Eigen::SparseMatrix<double> pattern(count, count);
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
    std::vector<std::uint32_t> sizes;
    for (const std::size_t eliminated : order_)
        sizes.push_back(static_cast<std::uint32_t>(variables_[eliminated].size));
    std::vector<BlockFactor::Block> blocks;  // of all that was noted
    for (const Noted& noted : noted_) {
        const auto [column, row] =
            std::minmax(variables_[noted.row].rank, variables_[noted.column].rank);
        blocks.push_back(
            {static_cast<BlockFactor::Rank>(column), static_cast<BlockFactor::Rank>(row)});
    }
    factor_ = std::make_unique<BlockFactor>(std::move(sizes), blocks);
    places_.clear();
    for (std::size_t i = 0; i < noted_.size(); ++i) {
        const Variable& row = variables_[noted_[i].row];
        const Variable& column = variables_[noted_[i].column];
        const auto [first, stride] = factor_->place(blocks[i].row, blocks[i].column);
        places_.push_back({first, stride, row.rank < column.rank});
        put(places_.back(), Eigen::Map<const Eigen::MatrixXd>(
                                noted_values_.data() + noted_[i].values, row.size, column.size));
    }
}

Eigen::VectorXd NormalEquations::reordered(const Eigen::VectorXd& as_added) const {
    Eigen::VectorXd eliminated(size_);
    for (const Variable& v : variables_) {
        eliminated.segment(v.at, v.size) = as_added.segment(v.added, v.size);
    }
    return eliminated;
}

bool NormalEquations::solve() {
    if (factored_) return solve_again();
    if (!factor_) lay_out();
    factored_ = factor_->factorize();
    return solve_again();
}

bool NormalEquations::solve_again() {
    if (!factored_) return false;
    step_ = reordered(gradient_);
    factor_->solve(step_);
    step_ = -step_;
    return step_.allFinite();
}

Eigen::MatrixXd NormalEquations::marginal(std::size_t variable) const {
    const Eigen::Index size = variables_[variable].size;
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(size_, size);
    put_rows(y, variable, Eigen::MatrixXd::Identity(size, size));
    return covariance_along(std::move(y));
}

Eigen::MatrixXd NormalEquations::covariance_along(Eigen::MatrixXd y) const {
    factor_->reduce(y);
    return y.transpose() * factor_->d().cwiseInverse().asDiagonal() * y;
}

std::vector<Eigen::MatrixXd> NormalEquations::marginals() const {
    std::vector<Eigen::MatrixXd> eliminated = factor_->inverse_blocks();
    std::vector<Eigen::MatrixXd> blocks;
    blocks.reserve(variables_.size());
    for (const Variable& variable : variables_)
        blocks.push_back(std::move(eliminated[static_cast<std::size_t>(variable.rank)]));
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
