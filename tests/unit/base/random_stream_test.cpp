// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/random_stream.hpp"

#include <gtest/gtest.h>

#include <set>

namespace hitos {
namespace {

TEST(RandomStream, SameAddressSameDraws) {
    RandomStream a(42, RandomPurpose::motion, 7, 3);
    RandomStream b(42, RandomPurpose::motion, 7, 3);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
}

TEST(RandomStream, EveryPartOfTheAddressMatters) {
    std::set<std::uint32_t> firsts;
    const std::uint64_t far = std::uint64_t{1} << 32;
    for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}, far}) {
        for (const auto purpose : {RandomPurpose::motion, RandomPurpose::resampling}) {
            for (const std::uint64_t step : {std::uint64_t{0}, std::uint64_t{1}, far}) {
                for (const std::uint32_t index : {0U, 1U, 1000U}) {
                    firsts.insert(RandomStream(seed, purpose, step, index).next());
                }
            }
        }
    }
    EXPECT_EQ(firsts.size(), 3U * 2U * 3U * 3U);
}

TEST(RandomStream, KnownAnswer) {
    // Philox4x32-10 with key (0, 0) and counter 0: the vector of the authors' kat_vectors file.
    // Purpose cannot be 0, so the counter is checked with the library itself one word away.
    const r123::Philox4x32::ctr_type zero{{0, 0, 0, 0}};
    const auto block = r123::Philox4x32{}(zero, r123::Philox4x32::key_type{{0, 0}});
    EXPECT_EQ(block[0], 0x6627e8d5U);
    EXPECT_EQ(block[1], 0xe169c58dU);
    EXPECT_EQ(block[2], 0xbc57ac4cU);
    EXPECT_EQ(block[3], 0x9b00dbd8U);
}

TEST(RandomStream, MomentsOfUniformAndNormal) {
    constexpr int kDraws = 100000;
    double sum_u = 0.0;
    double sum_n = 0.0;
    double sum_n2 = 0.0;
    double sum_n4 = 0.0;
    double sum_product = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        RandomStream random(5, RandomPurpose::laser_noise, static_cast<std::uint64_t>(i), 0);
        const double u = random.uniform();
        ASSERT_GT(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum_u += u;
        const auto [a, b] = random.normal_pair();
        sum_n += a;
        sum_n2 += a * a;
        sum_n4 += a * a * a * a;
        sum_product += a * b;
    }
    // Five standard errors of each mean: 1/sqrt(12 n), 1/sqrt(n), sqrt(2/n), sqrt(96/n), 1/sqrt(n).
    const double n = kDraws;
    EXPECT_NEAR(sum_u / n, 0.5, 5.0 / std::sqrt(12.0 * n));
    EXPECT_NEAR(sum_n / n, 0.0, 5.0 / std::sqrt(n));
    EXPECT_NEAR(sum_n2 / n, 1.0, 5.0 * std::sqrt(2.0 / n));
    EXPECT_NEAR(sum_n4 / n, 3.0, 5.0 * std::sqrt(96.0 / n));
    EXPECT_NEAR(sum_product / n, 0.0, 5.0 / std::sqrt(n));
}

}  // namespace
}  // namespace hitos
