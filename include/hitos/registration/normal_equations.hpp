// The sparse linear system of a Gauss-Newton step over variables of several numbers each.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace hitos {

/// H x = -b with H = sum J' W J and b = sum J' W e over all errors e. Variables are added once;
/// errors anew at every iteration, in the same order: the pattern of H is analysed once.
class NormalEquations {
  public:
    /// Adds a variable of `size` numbers; returns its place.
    std::size_t add_variable(int size);
    std::size_t variables() const { return offsets_.size(); }

    /// Begins the next iteration's sums.
    void begin();
    /// Adds an error that depends on one variable. `weight` is its information.
    template <class Jacobian, class Weight, class Error>
    void add(std::size_t variable, const Jacobian& j, const Weight& weight, const Error& e) {
        const auto jw = (j.transpose() * weight).eval();
        add_block(variable, variable, jw * j);
        add_gradient(variable, jw * e);
    }
    /// Adds one that depends on two, the first before the second.
    template <class First, class Second, class Weight, class Error>
    void add(std::size_t first, const First& j_first, std::size_t second, const Second& j_second,
             const Weight& weight, const Error& e) {
        const auto w_second = (weight * j_second).eval();
        add(first, j_first, weight, e);
        add(second, j_second, weight, e);
        add_block(second, first, w_second.transpose() * j_first);
    }
    /// Adds a number to the diagonal of a variable: holds it (great) or keeps H regular (small).
    void hold(std::size_t variable, double information);

    /// Solves; false where H is not positive definite.
    bool solve();
    /// Solves for the sums of this iteration with H as it was at the last solve(), which costs a
    /// small part of it: where H hardly changes, steps become ever shorter all the same.
    bool solve_again();
    /// The step of a variable after solve().
    auto step(std::size_t variable) const {
        return step_.segment(offsets_[variable], sizes_[variable]);
    }
    /// Its block of H^-1, after solve(): the covariance of the variable.
    Eigen::MatrixXd marginal(std::size_t variable) const;
    /// Those of all variables, each as of marginal(), in about the time of two factorisations:
    /// H^-1 where the factor L has entries, column by column from the last (Takahashi, Fagan and
    /// Chen, 1973).
    std::vector<Eigen::MatrixXd> marginals() const;
    /// The covariance of j_first x_first + j_second x_second, after solve().
    Eigen::MatrixXd covariance(std::size_t first, const Eigen::MatrixXd& j_first,
                               std::size_t second, const Eigen::MatrixXd& j_second) const;

  private:
    using Matrix = Eigen::SparseMatrix<double>;

    /// J' H^-1 J.
    Eigen::MatrixXd covariance_along(const Eigen::MatrixXd& j) const;

    /// `block` of the lower half: row variable not before the column's.
    template <class Block>
    void add_block(std::size_t row, std::size_t column, const Block& block) {
        const Eigen::Index r = offsets_[row];
        const Eigen::Index c = offsets_[column];
        for (Eigen::Index j = 0; j < block.cols(); ++j) {
            for (Eigen::Index i = row == column ? j : 0; i < block.rows(); ++i) {
                put(r + i, c + j, block(i, j));
            }
        }
    }
    template <class Block>
    void add_gradient(std::size_t variable, const Block& block) {
        gradient_.segment(offsets_[variable], sizes_[variable]) += block;
    }
    /// Adds to an entry of H; the n-th call of an iteration is of the same entry every time.
    void put(Eigen::Index row, Eigen::Index column, double value);
    void lay_out();

    std::vector<Eigen::Index> offsets_;
    std::vector<Eigen::Index> sizes_;
    Eigen::Index size_ = 0;
    Eigen::VectorXd gradient_;
    Eigen::VectorXd step_;
    // The first iteration notes where entries go, the next ones add straight into H.
    std::vector<Eigen::Triplet<double>> triplets_;
    std::vector<std::size_t> places_;  // in H's values, of the n-th put()
    std::size_t next_put_ = 0;
    Matrix h_;
    std::unique_ptr<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>> cholesky_;
    bool laid_out_ = false;
};

}  // namespace hitos
