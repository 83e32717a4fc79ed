// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <random>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A positive definite matrix of blocks at random, most of which are 0, and its factor.
class RandomMatrix {
  public:
    RandomMatrix(std::size_t count, unsigned seed) : engine_(seed) {
        std::vector<std::uint32_t> numbers;
        for (std::size_t i = 0; i < count; ++i) {
            at.push_back(size);
            numbers.push_back(i % 3 == 2 ? 1 + static_cast<std::uint32_t>(i % 4) : 3);
            size += numbers.back();
        }
        sizes.assign(numbers.begin(), numbers.end());
        for (BlockFactor::Rank i = 0; i < count; ++i) {
            blocks.push_back({i, i});
            for (int k = 0; k < 2; ++k) {
                const auto other = static_cast<BlockFactor::Rank>(
                    std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_));
                if (other != i) blocks.push_back({std::min(i, other), std::max(i, other)});
            }
        }
        dense = 20.0 * MatrixXd::Identity(size, size);
        for (const BlockFactor::Block& block : blocks) {
            const MatrixXd of = MatrixXd::NullaryExpr(sizes[block.row], sizes[block.column],
                                                      [&] { return normal_(engine_); });
            if (block.row == block.column) {
                block_of(dense, block) += of * of.transpose();
            } else {
                block_of(dense, block) = of;
                block_of(dense, {block.row, block.column}) = of.transpose();
            }
        }
        factor = std::make_unique<BlockFactor>(numbers, blocks);
    }
    void write() {
        factor->clear();
        for (const BlockFactor::Block& block : blocks) {
            const auto [first, stride] = factor->place(block.row, block.column);
            for (Eigen::Index j = 0; j < sizes[block.column]; ++j) {
                for (Eigen::Index i = 0; i < sizes[block.row]; ++i)
                    first[j * stride + i] = block_of(dense, block)(i, j);
            }
        }
    }
    Eigen::Block<MatrixXd> block_of(MatrixXd& of, const BlockFactor::Block& block) const {
        return of.block(at[block.row], at[block.column], sizes[block.row], sizes[block.column]);
    }

    Eigen::Index size = 0;
    std::vector<Eigen::Index> at;
    std::vector<Eigen::Index> sizes;
    std::vector<BlockFactor::Block> blocks;
    MatrixXd dense;
    std::unique_ptr<BlockFactor> factor;

  private:
    std::mt19937 engine_;
    std::normal_distribution<double> normal_{0.0, 0.7};
};

TEST(BlockFactor, SolvesAndInvertsAsADenseFactorDoes) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        RandomMatrix matrix(60, seed);
        matrix.write();
        ASSERT_TRUE(matrix.factor->factorize());
        const VectorXd right = VectorXd::LinSpaced(matrix.size, -1.0, 2.0);
        VectorXd solution = right;
        matrix.factor->solve(solution);
        EXPECT_LT((matrix.dense * solution - right).norm(), 1e-11);
        const MatrixXd inverse = matrix.dense.inverse();
        const auto blocks = matrix.factor->inverse_blocks();
        for (BlockFactor::Rank i = 0; i < blocks.size(); ++i) {
            MatrixXd all = inverse;
            EXPECT_LT((blocks[i] - matrix.block_of(all, {i, i})).norm(), 1e-12) << i;
        }
        MatrixXd y = MatrixXd::Zero(matrix.size, 1);
        y(7, 0) = 1.0;
        matrix.factor->reduce(y);
        const double along =
            (y.transpose() * matrix.factor->d().cwiseInverse().asDiagonal() * y).value();
        EXPECT_NEAR(along, inverse(7, 7), 1e-12);
    }
}

TEST(BlockFactor, SameBitsWithAnyVectorsAndWhenWrittenAgain) {
    RandomMatrix matrix(60, 4);
    std::vector<VectorXd> solutions;
    for (const VectorTarget target :
         {VectorTarget::sse2, VectorTarget::avx2, VectorTarget::avx512}) {
        use_vectors(target);
        matrix.write();
        ASSERT_TRUE(matrix.factor->factorize());
        solutions.emplace_back(VectorXd::LinSpaced(matrix.size, -1.0, 2.0));
        matrix.factor->solve(solutions.back());
    }
    use_vectors(VectorTarget::avx512);
    EXPECT_EQ(solutions[0], solutions[1]);
    EXPECT_EQ(solutions[0], solutions[2]);
}

TEST(BlockFactor, SaysWhereAMatrixIsNotPositiveDefinite) {
    RandomMatrix matrix(60, 5);
    matrix.dense(40, 40) = -1.0;
    matrix.write();
    EXPECT_FALSE(matrix.factor->factorize());
    matrix.dense(40, 40) = std::nan("");
    matrix.write();
    EXPECT_FALSE(matrix.factor->factorize());
}

}  // namespace
}  // namespace hitos
