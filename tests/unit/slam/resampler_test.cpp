// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/resampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "hitos/base/error.hpp"
#include "resampling/cumulated_weights.hpp"
#include "resampling/methods.hpp"

namespace hitos {
namespace {

TEST(LogWeights, NormaliseLikePlainWeightsAndSurviveUnderflow) {
    std::vector<double> weights;
    const std::vector<double> logs{std::log(0.1), std::log(0.3), std::log(0.6)};
    normalize_log_weights(logs, weights);
    EXPECT_NEAR(weights[0], 0.1, 1e-15);
    EXPECT_NEAR(weights[2], 0.6, 1e-15);
    // exp(-620) is 1e-270, exp(-5000) is 0: the differences count.
    const std::vector<double> tiny{-5000.0, -5000.0 + std::log(3.0)};
    normalize_log_weights(tiny, weights);
    EXPECT_NEAR(weights[0], 0.25, 1e-12);
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> broken{-infinity, std::nan(""), 0.0};
    normalize_log_weights(broken, weights);
    EXPECT_EQ(weights, (std::vector<double>{0.0, 0.0, 1.0}));
    const std::vector<double> overflown{infinity, 0.0, std::log(0.5)};
    normalize_log_weights(overflown, weights);
    EXPECT_EQ(weights[0], 0.0);
    EXPECT_NEAR(weights[1], 2.0 / 3.0, 1e-12);
    const std::vector<double> nothing{-infinity, -infinity};
    normalize_log_weights(nothing, weights);
    EXPECT_EQ(weights, (std::vector<double>{0.5, 0.5}));
}

TEST(Neff, KnownValues) {
    EXPECT_DOUBLE_EQ(effective_particles(std::vector<double>(50, 0.02)), 50.0);
    EXPECT_DOUBLE_EQ(effective_particles(std::vector<double>{1.0, 0.0, 0.0}), 1.0);
    EXPECT_DOUBLE_EQ(effective_particles(std::vector<double>{0.5, 0.5, 0.0}), 2.0);
}

/// [T table 6.2] word by word, searching from the start for every draw.
std::vector<std::uint32_t> slow_selection(const std::vector<double>& weights, double start) {
    std::vector<std::uint32_t> selected;
    const std::size_t count = weights.size();
    for (std::size_t m = 0; m < count; ++m) {
        const double u = (start + static_cast<double>(m)) / static_cast<double>(count);
        double cumulated = 0.0;
        std::size_t i = 0;
        for (; i < count; ++i) {
            cumulated += weights[i];
            if (u <= cumulated) break;
        }
        selected.push_back(static_cast<std::uint32_t>(std::min(i, count - 1)));
    }
    return selected;
}

TEST(LowVariance, EqualsTheSlowSearch) {
    std::mt19937 engine(31);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        std::vector<double> weights(static_cast<std::size_t>(1 + round % 97));
        double sum = 0.0;
        for (double& w : weights) sum += w = std::pow(uniform(engine), 4.0);
        for (double& w : weights) w /= sum;
        const double start = uniform(engine);
        std::vector<std::uint32_t> fast;
        low_variance_selection(weights, start, fast);
        EXPECT_EQ(fast, slow_selection(weights, start));
    }
}

TEST(LowVariance, CopiesAreTheExpectedNumberToWithinOne) {
    std::mt19937 engine(37);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> weights(500);
    double sum = 0.0;
    for (double& w : weights) sum += w = uniform(engine);
    for (double& w : weights) w /= sum;
    std::vector<std::uint32_t> selected;
    low_variance_selection(weights, uniform(engine), selected);
    std::vector<int> copies(weights.size(), 0);
    for (const auto i : selected) ++copies[i];
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double expected = weights[i] * 500.0;
        EXPECT_GE(copies[i], std::floor(expected - 1e-9));
        EXPECT_LE(copies[i], std::ceil(expected + 1e-9));
    }
}

TEST(LowVariance, EqualWeightsLoseNobodyAndZeroWeightsAreNeverDrawn) {
    std::vector<std::uint32_t> selected;
    low_variance_selection(std::vector<double>(10, 0.1), 0.5, selected);
    for (std::uint32_t i = 0; i < 10; ++i) EXPECT_EQ(selected[i], i);
    std::vector<double> weights(10, 0.0);
    weights[4] = 1.0 - 1e-12;  // rounding: the cumulated weight stays below 1
    low_variance_selection(weights, 0.999999999, selected);
    for (const auto i : selected) EXPECT_EQ(i, 4U);
}

TEST(LowVariance, FrequenciesFollowTheWeights) {
    const std::vector<double> weights{0.05, 0.15, 0.8};
    std::mt19937 engine(41);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> mean(3, 0.0);
    constexpr int kRounds = 20000;
    std::vector<std::uint32_t> selected;
    for (int round = 0; round < kRounds; ++round) {
        low_variance_selection(weights, uniform(engine), selected);
        for (const auto i : selected) mean[i] += 1.0 / (3.0 * kRounds);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(mean[i], weights[i], 5.0 * std::sqrt(0.25 / kRounds));
    }
}

TEST(CumulatedWeights, RoundingNeverLeadsToOneThatWeighsNothing) {
    // Ten tenths add up to a little less than 1.
    const auto weight = [](std::size_t i) { return i < 10 ? 0.1 : 0.0; };
    CumulatedWeights walk(12, weight);
    EXPECT_EQ(walk.at(0.95), 9U);
    EXPECT_EQ(walk.at(1.0), 9U);
}

class EveryMethod : public testing::TestWithParam<std::string> {
  protected:
    std::vector<std::uint32_t> select(const std::vector<double>& weights, std::uint64_t draw) {
        RandomStream random(43, RandomPurpose::resampling, draw, 0);
        method_->select(weights, random, selected_);
        return selected_;
    }
    /// How often each particle is copied.
    std::vector<int> copies(const std::vector<double>& weights, std::uint64_t draw) {
        std::vector<int> counts(weights.size(), 0);
        for (const std::uint32_t i : select(weights, draw)) ++counts.at(i);
        return counts;
    }

  private:
    std::unique_ptr<ResamplingMethod> method_ = resampling_methods().find(GetParam()).make({});
    std::vector<std::uint32_t> selected_{99};  // what it held before does not matter
};

INSTANTIATE_TEST_SUITE_P(All, EveryMethod,
                         testing::Values("low-variance", "stratified", "residual", "multinomial"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

std::vector<double> uneven_weights(std::size_t count) {
    std::mt19937 engine(47);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> weights(count);
    double sum = 0.0;
    for (double& w : weights) sum += w = std::pow(uniform(engine), 6.0);
    for (double& w : weights) w /= sum;
    return weights;
}

TEST_P(EveryMethod, CopiesEachParticleInTheMeanAsItsWeightSays) {
    constexpr int kDraws = 20000;
    for (const std::vector<double>& weights :
         {std::vector<double>{0.05, 0.15, 0.8}, uneven_weights(20)}) {
        const auto count = static_cast<double>(weights.size());
        std::vector<double> mean(weights.size(), 0.0);
        for (int draw = 0; draw < kDraws; ++draw) {
            const std::vector<int> counts = copies(weights, static_cast<std::uint64_t>(draw));
            for (std::size_t i = 0; i < counts.size(); ++i) mean[i] += counts[i] / double{kDraws};
        }
        for (std::size_t i = 0; i < weights.size(); ++i) {
            // No method's copies vary more than independent draws: M w (1 - w).
            const double sigma = std::sqrt(count * weights[i] * (1.0 - weights[i]) / kDraws);
            EXPECT_NEAR(mean[i], count * weights[i], 5.0 * sigma) << i;
        }
    }
}

TEST_P(EveryMethod, SelectsAsManyAsThereAreInAscendingOrder) {
    for (const std::size_t count : {2U, 3U, 17U, 500U}) {
        const std::vector<double> weights = uneven_weights(count);
        for (std::uint64_t draw = 0; draw < 50; ++draw) {
            const auto selected = select(weights, draw);
            EXPECT_EQ(selected.size(), count);
            EXPECT_TRUE(std::ranges::is_sorted(selected));
        }
    }
}

TEST_P(EveryMethod, NeverSelectsWhatWeighsNothing) {
    std::vector<double> weights(10, 0.0);
    weights[3] = 0.7;
    weights[6] = 0.3 - 1e-12;  // rounding: the sum stays below 1
    for (std::uint64_t draw = 0; draw < 500; ++draw) {
        for (const std::uint32_t i : select(weights, draw)) EXPECT_TRUE(i == 3 || i == 6) << i;
    }
}

TEST_P(EveryMethod, OneParticleOrOneThatHasAllTheWeightIsCopiedAlone) {
    EXPECT_EQ(select({1.0}, 1), std::vector<std::uint32_t>{0});
    EXPECT_EQ(select({0.0, 0.0, 1.0, 0.0}, 1), (std::vector<std::uint32_t>{2, 2, 2, 2}));
    EXPECT_EQ(select({1.0, 0.0, 0.0}, 1), (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST_P(EveryMethod, EqualWeightsLoseNobodyButByIndependentDraws) {
    for (const std::size_t count : {10U, 49U, 100U}) {  // 49 * (1 / 49) is less than 1
        const std::vector<double> weights(count, 1.0 / static_cast<double>(count));
        const std::vector<int> counts = copies(weights, 5);
        const auto lost = std::ranges::count(counts, 0);
        if (GetParam() == "multinomial") {
            EXPECT_GT(lost, 0);  // e^-1 of them
        } else {
            EXPECT_EQ(lost, 0);
        }
    }
}

/// Least and greatest number of copies and their variance over many draws.
TEST_P(EveryMethod, VariesAsMuchAsItsSchemeAllows) {
    const std::vector<double> weights{0.15, 0.25, 0.6};  // expected: 0.45, 0.75 and 1.8 of 3
    constexpr int kDraws = 20000;
    std::array<int, 4> seen{};  // how often the last is copied 0, 1, 2, 3 times
    for (int draw = 0; draw < kDraws; ++draw) {
        ++seen.at(static_cast<std::size_t>(copies(weights, static_cast<std::uint64_t>(draw))[2]));
    }
    const auto near = [&](double probability, int count) {
        const double sigma = std::sqrt(probability * (1.0 - probability) * kDraws);
        EXPECT_NEAR(count, probability * kDraws, 5.0 * sigma + 1e-9) << GetParam();
    };
    // Low variance: 1 or 2. Stratified: its stretch holds 0.8 of the second third.
    if (GetParam() == "low-variance" || GetParam() == "stratified") {
        near(0.0, seen[0]);
        near(0.2, seen[1]);
        near(0.0, seen[3]);
    } else if (GetParam() == "residual") {  // 1, and 2 draws of chance 0.8 / 2
        near(0.0, seen[0]);
        near(0.6 * 0.6, seen[1]);
        near(0.4 * 0.4, seen[3]);
    } else {  // 3 draws of chance 0.6
        near(0.4 * 0.4 * 0.4, seen[0]);
        near(3.0 * 0.6 * 0.4 * 0.4, seen[1]);
        near(0.6 * 0.6 * 0.6, seen[3]);
    }
}

TEST(Stratified, DrawsInEachPartByItself) {
    // Half of the stretch of the first lies in the first part, and half of the second in the next:
    // one draw for both parts gives one copy of each, two draws also give other numbers.
    const std::vector<double> weights{0.25, 0.5, 0.25};
    const auto outcomes = [&](const char* word) {
        const auto method = resampling_methods().find(word).make({});
        std::set<std::vector<std::uint32_t>> different;
        std::vector<std::uint32_t> selected;
        for (std::uint64_t draw = 0; draw < 200; ++draw) {
            RandomStream random(1, RandomPurpose::resampling, draw, 0);
            method->select(weights, random, selected);
            different.insert(selected);
        }
        return different.size();
    };
    EXPECT_EQ(outcomes("low-variance"), 3U);
    EXPECT_EQ(outcomes("stratified"), 4U);
}

TEST(LowVariance, TakesTheStreamsFirstDraw) {
    const std::vector<double> weights = uneven_weights(50);
    RandomStream random(1, RandomPurpose::resampling, 2, 0);
    RandomStream again = random;
    std::vector<std::uint32_t> selected;
    std::vector<std::uint32_t> expected;
    resampling_methods().find("low-variance").make({})->select(weights, random, selected);
    low_variance_selection(weights, again.uniform(), expected);
    EXPECT_EQ(selected, expected);
}

TEST(ResamplingMethods, AnUnknownWordIsToldWithThoseThereAre) {
    try {
        resampling_methods().find("wheel");
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_EQ(error.key(), "resampling.method");
        EXPECT_NE(
            std::string(error.what()).find("low-variance, stratified, residual or multinomial"),
            std::string::npos);
    }
}

TEST(Resampler, WantsWhatItsRuleSays) {
    ResamplingParams params;
    params.rule = ResamplingRule::always;
    EXPECT_TRUE(make_resampler(params)->wants(100.0));
    params.rule = ResamplingRule::neff;
    params.neff_threshold = 40.0;
    EXPECT_TRUE(make_resampler(params)->wants(39.9));
    EXPECT_FALSE(make_resampler(params)->wants(40.0));
}

}  // namespace
}  // namespace hitos
