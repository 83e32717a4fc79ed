// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/elementary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/random_row.hpp"
#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

/// How far a value is from the exact one, in units of the exact one's last place.
double ulps(double value, long double exact) {
    const double rounded = std::abs(static_cast<double>(exact));
    const double unit = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
    return static_cast<double>(std::abs(static_cast<long double>(value) - exact) /
                               static_cast<long double>(unit));
}

/// Numbers of all sizes up to `most`, of both signs.
std::vector<double> numbers(double most) {
    std::vector<double> all{0.0, 1e-300, 1.0, kPi, kPi / 2.0, kPi / 4.0, most};
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 200000; ++i) {
        all.push_back(most * share(random) * std::pow(10.0, -static_cast<double>(i % 9)));
    }
    for (std::size_t i = all.size(); i-- > 0;) all.push_back(-all[i]);
    return all;
}

TEST(Elementary, SineAndCosineAreExactToAUnitOfTheLastPlace) {
    for (const double x : numbers(1e5)) {
        const auto [sine, cosine] = elementary::sine_cosine(x);
        ASSERT_LE(ulps(sine, std::sin(static_cast<long double>(x))), 1.0) << x;
        ASSERT_LE(ulps(cosine, std::cos(static_cast<long double>(x))), 1.0) << x;
    }
}

TEST(Elementary, LogarithmAndPowerAreExactToAUnitOfTheLastPlace) {
    for (const double x : numbers(700.0)) {
        if (x > -708.0) {
            ASSERT_LE(ulps(elementary::exp(x), std::exp(static_cast<long double>(x))), 1.0) << x;
        }
        const double positive = std::exp(x);
        if (positive < std::numeric_limits<double>::min()) continue;
        ASSERT_LE(ulps(elementary::log(positive), std::log(static_cast<long double>(positive))),
                  1.0)
            << positive;
    }
    EXPECT_EQ(elementary::exp(0.0), 1.0);
    EXPECT_EQ(elementary::exp(-1e9), 0.0);
    EXPECT_EQ(elementary::log(1.0), 0.0);
}

TEST(Elementary, AnglesAreExactToThreeUnitsOfTheLastPlace) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 400000; ++i) {
        const double scale = std::pow(10.0, static_cast<double>(i % 13 - 6));
        const double y = normal(random);
        const double x = scale * normal(random);
        const long double exact =
            std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        ASSERT_LE(ulps(elementary::angle_of(y, x), exact), 3.0) << y << " " << x;
    }
    EXPECT_EQ(elementary::angle_of(0.0, 0.0), 0.0);
    EXPECT_EQ(elementary::angle_of(0.0, 2.0), 0.0);
    EXPECT_EQ(elementary::angle_of(0.0, -2.0), kPi);
    EXPECT_EQ(elementary::angle_of(2.0, 0.0), kPi / 2.0);
    EXPECT_EQ(elementary::angle_of(-2.0, 0.0), -kPi / 2.0);
}

TEST(Elementary, WrapsAsWrapAngleDoes) {
    for (const double x : numbers(1e6)) {
        const double wrapped = elementary::wrap(x);
        ASSERT_GT(wrapped, -kPi);
        ASSERT_LE(wrapped, kPi);
        const double apart = std::abs(wrapped - wrap_angle(x));
        ASSERT_LT(std::min(apart, 2.0 * kPi - apart), 1e-9) << x;
    }
    for (const double x : {0.0, 1.0, -1.0, kPi, std::nextafter(-kPi, 0.0), 3.0 * kPi / 4.0}) {
        EXPECT_EQ(elementary::wrap(x), x);
    }
    EXPECT_EQ(elementary::wrap(-kPi), kPi);
    EXPECT_EQ(elementary::wrap(std::nextafter(kPi, 4.0)), wrap_angle(std::nextafter(kPi, 4.0)));
    EXPECT_TRUE(std::isnan(elementary::wrap(std::nan(""))));
}

TEST(Vectorised, PositiveNumbersAreBits) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const std::array numbers{1.0, 0.0, -1.0, kNaN, 1e-320, -0.0, -kNaN, 5.0};
    EXPECT_EQ(positive_of_eight(numbers.data()), 0b10010001U);
}

/// What the streams give one by one, to the last bit, whatever the vectors.
TEST(RandomRow, EqualsItsStreams) {
    for (const VectorTarget target :
         {VectorTarget::sse2, VectorTarget::avx2, VectorTarget::avx512}) {
        use_vectors(target);
        for (const std::size_t count : {std::size_t{1}, std::size_t{37}, NormalRow::kMost}) {
            const RandomRow row{0x123456789abcdefU, RandomPurpose::motion, 77, 4000000000U};
            NormalRow normals{};
            draw_normals(row, count, normals);
            for (std::size_t i = 0; i < count; ++i) {
                RandomStream stream = row.stream(i);
                const auto [n0, n1] = stream.normal_pair();
                EXPECT_EQ(normals.n0[i], n0);
                EXPECT_EQ(normals.n1[i], n1);
                EXPECT_EQ(normals.n2[i], stream.normal_pair()[0]);
            }
        }
    }
    use_vectors(VectorTarget::avx512);
}

}  // namespace
}  // namespace hitos
