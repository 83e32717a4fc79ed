// SPDX-License-Identifier: GPL-3.0-or-later
// The sparse linear system of a Gauss-Newton step over variables of several numbers each.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hitos {

class BlockFactor;

/// H x = -b with H = sum J' W J and b = sum J' W e over all errors e. Variables are added once;
/// errors anew at every iteration, in the same order: the pattern of H is analysed once, and by
/// blocks, of which it has several times fewer than numbers.
class NormalEquations {
  public:
    NormalEquations();
    NormalEquations(NormalEquations&&) noexcept;
    NormalEquations& operator=(NormalEquations&&) noexcept;
    ~NormalEquations();

    /// Adds a variable of `size` numbers; returns its place.
    std::size_t add_variable(int size);
    std::size_t variables() const { return variables_.size(); }

    /// Begins the next iteration's sums.
    void begin();
    /// Begins sums of b alone, H staying as it is: what solve_again() needs.
    void begin_gradient();
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
        add(first, j_first, weight, e);
        add(second, j_second, weight, e);
        const auto w_second = (weight * j_second).eval();
        add_block(second, first, w_second.transpose() * j_first);
    }
    /// Adds a number to the diagonal of a variable: holds it (great) or keeps H regular (small).
    void hold(std::size_t variable, double information);

    /// Whether the factor of what was added since the first begin() has at most so many numbers,
    /// each of 8 bytes. Before the first solve().
    bool factor_fits(std::uint64_t most);
    /// Solves; false where H is not positive definite. H is factored once after begin().
    bool solve();
    /// Solves for the sums of this iteration with H as it was at the last solve(), which costs a
    /// small part of it: where H hardly changes, steps become ever shorter all the same. False
    /// where there was none since begin().
    bool solve_again();
    /// The step of a variable after solve().
    auto step(std::size_t variable) const {
        return step_.segment(variables_[variable].at, variables_[variable].size);
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
    /// A block of H, in its lower half: numbers column by column.
    struct Place {
        double* first = nullptr;
        Eigen::Index stride = 0;
        bool across = false;  // the block lies there transposed
    };
    /// A variable: where it is in b as it was added, and in H as it is eliminated.
    struct Variable {
        Eigen::Index size;
        Eigen::Index added;
        Eigen::Index rank;  // of order_
        Eigen::Index at;
    };
    /// What the first iteration adds, before anything is laid out.
    struct Noted {
        std::size_t row;
        std::size_t column;
        std::size_t values;  // where they begin
    };

    /// Rows of j x, x in the order of elimination, from rows over one variable.
    void put_rows(Eigen::MatrixXd& y, std::size_t variable, const Eigen::MatrixXd& j) const {
        y.middleRows(variables_[variable].at, variables_[variable].size) += j.transpose();
    }
    /// y' H^-1 y.
    Eigen::MatrixXd covariance_along(Eigen::MatrixXd y) const;

    template <class Block>
    void add_block(std::size_t row, std::size_t column, const Block& block) {
        if (gradient_only_) return;
        if (!factor_) {
            noted_.push_back({row, column, noted_values_.size()});
            for (Eigen::Index j = 0; j < block.cols(); ++j) {
                for (Eigen::Index i = 0; i < block.rows(); ++i) {
                    noted_values_.push_back(block(i, j));
                }
            }
            return;
        }
        put(places_[next_place_++], block);
    }
    template <class Block>
    static void put(const Place& place, const Block& block) {
        const Eigen::Index columns = place.across ? block.rows() : block.cols();
        const Eigen::Index rows = place.across ? block.cols() : block.rows();
        for (Eigen::Index j = 0; j < columns; ++j) {
            double* const column = place.first + j * place.stride;
            for (Eigen::Index i = 0; i < rows; ++i)
                column[i] += place.across ? block(j, i) : block(i, j);
        }
    }
    template <class Block>
    void add_gradient(std::size_t variable, const Block& block) {
        gradient_.segment(variables_[variable].added, variables_[variable].size) += block;
    }
    void order_variables();
    void lay_out();
    Eigen::VectorXd reordered(const Eigen::VectorXd& as_added) const;

    std::vector<Variable> variables_;
    std::vector<std::size_t> order_;  // variables as they are eliminated
    Eigen::Index size_ = 0;
    Eigen::VectorXd gradient_;
    Eigen::VectorXd step_;
    // The first iteration notes blocks, the next ones add straight into H, of which its factor
    // takes the place.
    std::vector<Noted> noted_;
    std::vector<double> noted_values_;
    std::vector<Place> places_;  // of the n-th block of an iteration
    std::size_t next_place_ = 0;
    std::unique_ptr<BlockFactor> factor_;
    bool factored_ = false;
    bool gradient_only_ = false;
};

}  // namespace hitos
