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
    step_ = -cholesky_->solve(gradient_);
    return step_.allFinite();
}

Eigen::MatrixXd NormalEquations::marginal(std::size_t variable) const {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(size_, sizes_[variable]);
    unit.middleRows(offsets_[variable], sizes_[variable]).setIdentity();
    return cholesky_->solve(unit).middleRows(offsets_[variable], sizes_[variable]);
}

}  // namespace hitos
