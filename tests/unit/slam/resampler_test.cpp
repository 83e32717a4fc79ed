#include "hitos/slam/resampler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

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
