// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/normal_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdint>
#include <random>

namespace hitos {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A system of poses and points of random errors, summed by NormalEquations and densely.
class RandomSystem {
  public:
    explicit RandomSystem(unsigned seed) : engine_(seed) {}

    void lay_out(int poses, int points) {
        for (int i = 0; i < poses; ++i) add_variable(3);
        for (int i = 0; i < points; ++i) add_variable(2);
        dense = MatrixXd::Zero(size_, size_);
        gradient = VectorXd::Zero(size_);
    }
    void begin() {
        equations.begin();
        dense.setZero();
        gradient.setZero();
    }
    void tie(std::size_t a) {
        const MatrixXd j = random(2, sizes[a]);
        const MatrixXd w = weight(2);
        const VectorXd e = random(2, 1);
        equations.add(a, j, w, e);
        sum(a, j, a, j, w);
        gradient.segment(at[a], sizes[a]) += j.transpose() * w * e;
    }
    void tie(std::size_t a, std::size_t b) {
        const MatrixXd j_a = random(2, sizes[a]);
        const MatrixXd j_b = random(2, sizes[b]);
        const MatrixXd w = weight(2);
        const VectorXd e = random(2, 1);
        equations.add(a, j_a, b, j_b, w, e);
        sum(a, j_a, a, j_a, w);
        sum(a, j_a, b, j_b, w);
        sum(b, j_b, a, j_a, w);
        sum(b, j_b, b, j_b, w);
        gradient.segment(at[a], sizes[a]) += j_a.transpose() * w * e;
        gradient.segment(at[b], sizes[b]) += j_b.transpose() * w * e;
    }
    void hold(std::size_t a, double information) {
        equations.hold(a, information);
        dense.diagonal().segment(at[a], sizes[a]).array() += information;
    }
    /// A chain of poses with points, some chords across.
    void tie_all(std::size_t poses, std::size_t points) {
        begin();
        hold(0, 1e3);
        for (std::size_t i = 1; i < poses + points; ++i) hold(i, 1e-3);
        for (std::size_t i = 0; i + 1 < poses; ++i) tie(i, i + 1);
        for (std::size_t i = 0; i + 7 < poses; i += 5) tie(i, i + 7);
        for (std::size_t i = 0; i < points; ++i) {
            for (std::size_t k = 0; k < 4; ++k) tie((3 * i + k) % poses, poses + i);
        }
        tie(poses / 2);
    }

    NormalEquations equations;
    MatrixXd dense;
    VectorXd gradient;
    std::vector<Eigen::Index> at;
    std::vector<Eigen::Index> sizes;

  private:
    void add_variable(int size) {
        EXPECT_EQ(equations.add_variable(size), at.size());
        at.push_back(size_);
        sizes.push_back(size);
        size_ += size;
    }
    void sum(std::size_t a, const MatrixXd& j_a, std::size_t b, const MatrixXd& j_b,
             const MatrixXd& w) {
        dense.block(at[a], at[b], sizes[a], sizes[b]) += j_a.transpose() * w * j_b;
    }
    MatrixXd random(Eigen::Index rows, Eigen::Index columns) {
        return MatrixXd::NullaryExpr(rows, columns, [&] { return normal_(engine_); });
    }
    MatrixXd weight(Eigen::Index size) {
        const MatrixXd half = random(size, size);
        return half * half.transpose() + 0.1 * MatrixXd::Identity(size, size);
    }

    Eigen::Index size_ = 0;
    std::mt19937 engine_;
    std::normal_distribution<double> normal_;
};

double apart(const MatrixXd& a, const MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST(NormalEquations, SolvesWhatADenseSolverDoes) {
    RandomSystem system(3);
    system.lay_out(20, 9);
    for (int iteration = 0; iteration < 3; ++iteration) {  // the later ones reuse the pattern
        system.tie_all(20, 9);
        ASSERT_TRUE(system.equations.solve());
        const VectorXd step = -system.dense.ldlt().solve(system.gradient);
        for (std::size_t i = 0; i < system.at.size(); ++i) {
            EXPECT_LT(apart(system.equations.step(i), step.segment(system.at[i], system.sizes[i])),
                      1e-8)
                << "variable " << i << ", iteration " << iteration;
        }
    }
}

TEST(NormalEquations, SolvesAgainWhereTheMatrixStays) {
    RandomSystem system(23);
    system.lay_out(12, 4);
    system.tie_all(12, 4);
    ASSERT_TRUE(system.equations.solve());
    const MatrixXd before = system.dense;
    system.equations.begin_gradient();
    system.gradient.setZero();
    for (std::size_t i = 0; i + 1 < 12; ++i) system.tie(i, i + 1);
    ASSERT_TRUE(system.equations.solve_again());
    const VectorXd step = -before.ldlt().solve(system.gradient);
    for (std::size_t i = 0; i < system.at.size(); ++i) {
        EXPECT_LT((system.equations.step(i) - step.segment(system.at[i], system.sizes[i])).norm(),
                  1e-8)
            << "variable " << i;
    }
    ASSERT_TRUE(system.equations.solve());  // the factor is there
    for (std::size_t i = 0; i < system.at.size(); ++i) {
        EXPECT_LT((system.equations.step(i) - step.segment(system.at[i], system.sizes[i])).norm(),
                  1e-8);
    }
    system.equations.begin();  // sums of another matrix
    EXPECT_FALSE(system.equations.solve_again());
    system.tie_all(12, 4);
    ASSERT_TRUE(system.equations.solve());
    system.equations.add_variable(1);
    EXPECT_FALSE(system.equations.solve_again());
}

TEST(NormalEquations, MarginalsAreBlocksOfTheInverse) {
    RandomSystem system(5);
    system.lay_out(30, 12);
    system.tie_all(30, 12);
    ASSERT_TRUE(system.equations.solve());
    const MatrixXd inverse = system.dense.inverse();
    const std::vector<MatrixXd> all = system.equations.marginals();
    ASSERT_EQ(all.size(), system.at.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const MatrixXd block =
            inverse.block(system.at[i], system.at[i], system.sizes[i], system.sizes[i]);
        EXPECT_LT(apart(system.equations.marginal(i), block), 1e-8) << "variable " << i;
        EXPECT_LT(apart(all[i], block), 1e-8) << "variable " << i;
    }
}

TEST(NormalEquations, CovarianceOfACombinationIsThatOfTheInverse) {
    RandomSystem system(7);
    system.lay_out(15, 6);
    system.tie_all(15, 6);
    ASSERT_TRUE(system.equations.solve());
    MatrixXd j_a(2, 2);
    j_a << 1.0, -2.0, 0.5, 1.5;
    MatrixXd j_b(2, 3);
    j_b << -1.0, 0.3, 0.0, 0.0, 1.0, 2.0;
    MatrixXd j = MatrixXd::Zero(2, system.dense.cols());
    j.middleCols(system.at[17], 2) = j_a;
    j.middleCols(system.at[4], 3) = j_b;
    EXPECT_LT(apart(system.equations.covariance(17, j_a, 4, j_b),
                    j * system.dense.inverse() * j.transpose()),
              1e-8);
}

TEST(NormalEquations, CountsTheNumbersOfTheFactorBeforeItIsMade) {
    // In blocks of nine: each pose's own, and one for each two that are joined by elimination.
    const auto fits = [](bool all, std::uint64_t most) {
        RandomSystem system(1);
        system.lay_out(6, 0);
        system.begin();
        for (std::size_t a = 0; a < 6; ++a) {
            for (std::size_t b = a + 1; b < 6; ++b) {
                if (all || b == a + 1) system.tie(a, b);
            }
        }
        return system.equations.factor_fits(most);
    };
    EXPECT_TRUE(fits(false, std::uint64_t{9} * 11));
    EXPECT_FALSE(fits(false, std::uint64_t{9} * 11 - 1));
    EXPECT_TRUE(fits(true, std::uint64_t{9} * 21));
    EXPECT_FALSE(fits(true, std::uint64_t{9} * 21 - 1));
}

TEST(NormalEquations, AVariableThatIsHeldStaysAndOneThatNothingHoldsIsTold) {
    RandomSystem system(11);
    system.lay_out(3, 0);
    system.begin();
    system.hold(0, 1e12);
    system.tie(0, 1);
    system.tie(0, 1);
    system.hold(2, 1.0);  // nothing else is known of it
    ASSERT_TRUE(system.equations.solve());
    EXPECT_LT(system.equations.step(0).norm(), 1e-9);
    EXPECT_GT(system.equations.step(1).norm(), 1e-3);
    EXPECT_LT(apart(system.equations.marginals()[2], MatrixXd::Identity(3, 3)), 1e-12);

    RandomSystem open(13);
    open.lay_out(2, 0);
    open.begin();
    open.hold(0, 1.0);
    open.hold(1, 0.0);
    EXPECT_FALSE(open.equations.solve());
}

}  // namespace
}  // namespace hitos
