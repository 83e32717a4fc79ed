// SPDX-License-Identifier: GPL-3.0-or-later
#include "ekf/half_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <random>
#include <vector>

namespace hitos {
namespace {

using Eigen::MatrixXd;

constexpr std::array<std::size_t, 11> kSizes{3, 5, 31, 32, 33, 63, 64, 65, 66, 67, 130};

MatrixXd random_symmetric(std::size_t size, std::mt19937& engine) {
    std::normal_distribution<double> normal;
    const auto n = static_cast<Eigen::Index>(size);
    MatrixXd a(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = j; i < n; ++i) a(i, j) = a(j, i) = normal(engine);
    }
    return a;
}

HalfMatrix half_of(const MatrixXd& whole) {
    HalfMatrix half;
    half.resize(static_cast<std::size_t>(whole.rows()));
    for (std::size_t i = 0; i < half.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            half.set(i, j, whole(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
        }
    }
    return half;
}

MatrixXd whole_of(const HalfMatrix& half) {
    const auto n = static_cast<Eigen::Index>(half.size());
    MatrixXd whole(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            whole(i, j) = half(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        }
    }
    return whole;
}

TallMatrix random_tall(std::size_t rows, std::size_t columns, std::mt19937& engine) {
    std::normal_distribution<double> normal;
    TallMatrix tall;
    tall.reshape((rows + TallMatrix::kRows - 1) / TallMatrix::kRows, columns);
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) tall(i, j) = normal(engine);
    }
    return tall;
}

TEST(HalfMatrix, IsTheSymmetricMatrixThatWasSet) {
    std::mt19937 engine(5);
    for (const std::size_t size : kSizes) {
        const MatrixXd whole = random_symmetric(size, engine);
        EXPECT_EQ(whole_of(half_of(whole)), whole) << size;
    }
}

TEST(HalfMatrix, LessASquareEqualsThePlainProduct) {
    std::mt19937 engine(7);
    for (const std::size_t size : kSizes) {
        for (const std::size_t terms : {4U, 20U, 64U}) {
            const MatrixXd whole = random_symmetric(size, engine);
            const TallMatrix u = random_tall(size, terms + 4, engine);
            MatrixXd plain(whole.rows(), static_cast<Eigen::Index>(terms));
            for (std::size_t i = 0; i < size; ++i) {
                for (std::size_t k = 0; k < terms; ++k) {
                    plain(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = u(i, k);
                }
            }
            const MatrixXd expected = whole - plain * plain.transpose();
            MatrixXd first;
            for (const VectorTarget target :
                 {VectorTarget::sse2, VectorTarget::avx2, VectorTarget::avx512}) {
                use_vectors(target);
                HalfMatrix half = half_of(whole);
                half.subtract_square(u, terms);
                const MatrixXd result = whole_of(half);
                EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), 1e-12 * 64.0) << size;
                if (first.size() == 0) first = result;
                EXPECT_EQ(result, first) << size;
            }
        }
    }
    use_vectors(widest_vectors());
}

TEST(HalfMatrix, ReadsAndWritesColumns) {
    std::mt19937 engine(11);
    for (const std::size_t size : kSizes) {
        MatrixXd whole = random_symmetric(size, engine);
        HalfMatrix half = half_of(whole);
        TallMatrix columns = random_tall(size, 2, engine);
        for (const std::size_t at : {std::size_t{0}, size / 2, size - 1}) {
            half.write_column(at, columns, 1);
            for (std::size_t i = 0; i < size; ++i) {
                whole(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(at)) = columns(i, 1);
                whole(static_cast<Eigen::Index>(at), static_cast<Eigen::Index>(i)) = columns(i, 1);
            }
            ASSERT_EQ(whole_of(half), whole) << size << " " << at;
            half.read_column(at, columns, 0);
            for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(columns(i, 0), columns(i, 1));
        }
    }
}

TEST(HalfMatrix, GrowsByZerosAndLosesRowsFromWithin) {
    std::mt19937 engine(13);
    for (const std::size_t size : kSizes) {
        const MatrixXd whole = random_symmetric(size, engine);
        HalfMatrix half = half_of(whole);
        half.remove(1, 2);
        std::vector<Eigen::Index> left;
        for (std::size_t i = 0; i < size; ++i) {
            if (i < 1 || i > 2) left.push_back(static_cast<Eigen::Index>(i));
        }
        const MatrixXd rest = whole(left, left);
        ASSERT_EQ(whole_of(half), rest) << size;
        half.resize(size + 40);
        MatrixXd grown = MatrixXd::Zero(whole.rows() + 40, whole.rows() + 40);
        grown.topLeftCorner(rest.rows(), rest.rows()) = rest;
        EXPECT_EQ(whole_of(half), grown) << size;
    }
}

TEST(HalfMatrix, NegatesARowAndItsColumn) {
    std::mt19937 engine(17);
    const MatrixXd whole = random_symmetric(67, engine);
    for (const Eigen::Index at : {0, 33, 66}) {
        HalfMatrix half = half_of(whole);
        half.negate(static_cast<std::size_t>(at));
        MatrixXd expected = whole;
        expected.row(at) *= -1.0;
        expected.col(at) *= -1.0;
        EXPECT_EQ(whole_of(half), expected);
    }
}

TEST(HalfMatrix, TakesHardlyMoreThanHalfTheMemory) {
    HalfMatrix half;
    half.resize(2004);
    EXPECT_LT(half.bytes(), 0.52 * 2004.0 * 2004.0 * sizeof(double));
}

}  // namespace
}  // namespace hitos
