#include "hitos/registration/normal_equations.hpp"

#include <algorithm>

namespace hitos {

std::size_t NormalEquations::add_variable(int size) {
    offsets_.push_back(size_);
    sizes_.push_back(size);
    size_ += size;
    laid_out_ = false;
    places_.clear();
    return offsets_.size() - 1;
}

void NormalEquations::begin() {
    gradient_ = Eigen::VectorXd::Zero(size_);
    next_put_ = 0;
    triplets_.clear();
    if (laid_out_) std::fill_n(h_.valuePtr(), h_.nonZeros(), 0.0);
}

void NormalEquations::hold(std::size_t variable, double information) {
    for (Eigen::Index i = 0; i < sizes_[variable]; ++i) {
        put(offsets_[variable] + i, offsets_[variable] + i, information);
    }
}

void NormalEquations::put(Eigen::Index row, Eigen::Index column, double value) {
    if (laid_out_) {
        h_.valuePtr()[places_[next_put_++]] += value;
    } else {
        triplets_.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    }
}

void NormalEquations::lay_out() {
    h_.resize(size_, size_);
    h_.setFromTriplets(triplets_.begin(), triplets_.end());
    places_.resize(triplets_.size());
    for (std::size_t i = 0; i < triplets_.size(); ++i) {
        const int* const begin = h_.innerIndexPtr() + h_.outerIndexPtr()[triplets_[i].col()];
        const int* const end = h_.innerIndexPtr() + h_.outerIndexPtr()[triplets_[i].col() + 1];
        places_[i] = static_cast<std::size_t>(std::lower_bound(begin, end, triplets_[i].row()) -
                                              h_.innerIndexPtr());
    }
    cholesky_ = std::make_unique<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>>();
    cholesky_->analyzePattern(h_);
    laid_out_ = true;
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
    step_ = -cholesky_->solve(gradient_);
    return step_.allFinite();
}

Eigen::MatrixXd NormalEquations::marginal(std::size_t variable) const {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(size_, sizes_[variable]);
    unit.middleRows(offsets_[variable], sizes_[variable]).setIdentity();
    return covariance_along(unit);
}

Eigen::MatrixXd NormalEquations::covariance_along(const Eigen::MatrixXd& j) const {
    // J' H^-1 J = y' D^-1 y with y = L^-1 P J. Most of y is zero: column k of L matters only where
    // y has an entry by then.
    Eigen::MatrixXd y = cholesky_->permutationP() * j;
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
    const auto& place = cholesky_->permutationP().indices();
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
        const int i = std::max(place(a), place(b));
        const int j = std::min(place(a), place(b));
        if (i == j) return diagonal(i);
        const int* const found = std::lower_bound(row + begin[j], row + begin[j + 1], i);
        const bool there = found != row + begin[j + 1] && *found == i;
        return there ? z[static_cast<std::size_t>(found - row)] : 0.0;  // only held: no block
    };
    std::vector<Eigen::MatrixXd> blocks(offsets_.size());
    for (std::size_t v = 0; v < offsets_.size(); ++v) {
        blocks[v] =
            Eigen::MatrixXd::NullaryExpr(sizes_[v], sizes_[v], [&](Eigen::Index a, Eigen::Index b) {
                return entry(offsets_[v] + a, offsets_[v] + b);
            });
    }
    return blocks;
}

Eigen::MatrixXd NormalEquations::covariance(std::size_t first, const Eigen::MatrixXd& j_first,
                                            std::size_t second,
                                            const Eigen::MatrixXd& j_second) const {
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(size_, j_first.rows());
    j.middleRows(offsets_[first], sizes_[first]) += j_first.transpose();
    j.middleRows(offsets_[second], sizes_[second]) += j_second.transpose();
    return covariance_along(j);
}

}  // namespace hitos
