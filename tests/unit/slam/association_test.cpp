// SPDX-License-Identifier: GPL-3.0-or-later
#include "association/association.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <random>

#include "models/map_store.hpp"
#include "own_landmarks.hpp"

namespace hitos {
namespace {

using Outcome = Association::Outcome;
using Reason = Association::Reason;

/// [T table 5.1] and the rule of SPEC §5 for ambiguity, word by word over all landmarks: no
/// rejection, plain likelihoods.
template <class S>
Decision slow_decision(const typename S::Columns& landmarks, const AssociationParams& params,
                       const Matrix2& r, const Pose& pose, const Vector2& z) {
    double best_score = -1.0;
    double best = 0.0;
    double second = 0.0;
    std::uint32_t index = 0;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const auto estimate = landmarks.get(i);
        const Innovation nu = S::innovation(z, pose, estimate.mean);
        const Matrix2 q = nu.jacobian * estimate.covariance * nu.jacobian.transpose() + r;
        const double d2 = nu.nu.dot(q.inverse() * nu.nu);
        const double likelihood = std::exp(-0.5 * d2) / (2.0 * kPi * std::sqrt(q.determinant()));
        const bool by_likelihood = params.method == AssociationMethod::maximum_likelihood;
        if (by_likelihood ? likelihood <= params.p0
                          : d2 > -2.0 * std::log(1.0 - params.gate_probability)) {
            continue;
        }
        const double score = by_likelihood ? likelihood : 1.0 / (1.0 + d2);
        if (score > best_score) {
            second = std::max(second, best);
            best_score = score;
            best = likelihood;
            index = static_cast<std::uint32_t>(i);
        } else {
            second = std::max(second, likelihood);
        }
    }
    if (best_score < 0.0) return {Outcome::created, Reason::fits_none, 0, std::log(params.p0)};
    if (params.ambiguity == AmbiguityRule::off || second <= params.p0 ||
        second <= params.ambiguity_ratio * best) {
        return {Outcome::matched, Reason::fits, index, std::log(best)};
    }
    const double factor = params.ambiguity == AmbiguityRule::neutral ? 1.0
                          : params.ambiguity == AmbiguityRule::new_landmark
                              ? params.p0
                              : std::max(best, second);
    return {Outcome::ignored, Reason::ambiguous, 0, std::log(factor)};
}

struct Draws {
    std::mt19937 engine{47};
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine); }
    double value() { return std::uniform_real_distribution<double>(-10.0, 10.0)(engine); }
    double angle() { return std::uniform_real_distribution<double>(-kPi, kPi)(engine); }
};

template <class S>
void add_landmark(typename S::Columns& columns, int i, bool crowded, int round, Draws& draws) {
    const double a = 1e-3 + 0.2 * draws.unit();
    const double b = 1e-4 + 0.02 * draws.unit();
    Matrix2 covariance;
    covariance << a, 0.5 * std::sqrt(a * b), 0.5 * std::sqrt(a * b), b;
    const std::size_t index = columns.append();
    if constexpr (std::is_same_v<S, SensorRecta>) {
        // Crowded: parallel walls a few decimetres apart, so that several are plausible.
        const double theta = crowded ? 0.5 * (round % 5) : draws.angle();
        const double rho = crowded ? 0.3 * i : std::abs(draws.value());
        columns.set(index, {{rho, wrap_angle(theta)}, covariance});
    } else {
        const double spread = crowded ? 0.1 : 1.0;
        const double x = spread * draws.value();
        columns.set(index, {{x, spread * draws.value()}, covariance});
    }
}

template <class S>
void compare_with_oracle(int landmarks, bool crowded) {
    Draws draws;
    std::array<int, 3> outcomes{};
    for (int round = 0; round < 3000; ++round) {
        AssociationParams params;
        params.method = round % 3 == 0 ? AssociationMethod::gated_nearest
                                       : AssociationMethod::maximum_likelihood;
        params.p0 = std::pow(10.0, -9.0 + 10.0 * draws.unit());
        params.ambiguity = static_cast<AmbiguityRule>(round % 4);
        const double var0 = 0.001 + 0.08 * draws.unit();
        const double var1 = 1e-4 + 3e-3 * draws.unit();
        const double both =
            round % 2 == 0 ? 0.0 : (1.6 * draws.unit() - 0.8) * std::sqrt(var0 * var1);
        Matrix2 r;
        r << var0, both, both, var1;
        const Pose pose{draws.value(), draws.value(), draws.angle()};

        OwnLandmarks<S> own;
        typename S::Columns columns = own.columns();
        for (int i = 0; i < landmarks; ++i) add_landmark<S>(columns, i, crowded, round, draws);
        // Mostly an observation of one of them, with an error.
        Vector2 z{std::abs(draws.value()), draws.angle()};
        if (landmarks > 0 && round % 5 != 0) {
            const auto observed = columns.get(static_cast<std::size_t>(round % landmarks)).mean;
            z = S::predict(pose, observed);
            if (z(0) < 0.0) z << -z(0), z(1) + kPi;
            z += Vector2{0.3 * (draws.unit() - 0.5), 0.1 * (draws.unit() - 0.5)};
            z << std::abs(z(0)), wrap_angle(z(1));
        }
        const Associator associator(params);
        const SeenFeature seen = associator.seen({z, r});
        const Decision fast = associator.decide<S>(columns, pose, prepare(seen, pose));
        const Decision slow = slow_decision<S>(columns, params, r, pose, z);
        ++outcomes[static_cast<std::size_t>(slow.outcome)];
        ASSERT_EQ(fast.outcome, slow.outcome) << "round " << round;
        ASSERT_EQ(fast.landmark, slow.landmark) << "round " << round;
        ASSERT_NEAR(fast.log_likelihood, slow.log_likelihood,
                    1e-7 * (1.0 + std::abs(slow.log_likelihood)));
    }
    if (landmarks > 1) {
        EXPECT_GT(outcomes[static_cast<std::size_t>(Outcome::matched)], 100);
        EXPECT_GT(outcomes[static_cast<std::size_t>(Outcome::created)], 100);
    }
    if (crowded) {
        EXPECT_GT(outcomes[static_cast<std::size_t>(Outcome::ignored)], 50);
    }
}

TEST(Association, EqualsTheOracleOnLines) {
    compare_with_oracle<SensorRecta>(20, false);
}
TEST(Association, EqualsTheOracleOnParallelWalls) {
    compare_with_oracle<SensorRecta>(12, true);
}
TEST(Association, EqualsTheOracleOnManyLines) {
    compare_with_oracle<SensorRecta>(150, false);
}
TEST(Association, EqualsTheOracleOnCorners) {
    compare_with_oracle<SensorEsquina>(20, false);
}
TEST(Association, EqualsTheOracleOnCrowdedCorners) {
    compare_with_oracle<SensorEsquina>(70, true);
}
TEST(Association, AnEmptyMapGivesANewLandmark) {
    compare_with_oracle<SensorRecta>(0, false);
    compare_with_oracle<SensorEsquina>(0, false);
}

TEST(BestTwo, TheSecondLikelihoodIsTheGreatestOfAllOthers) {
    BestTwo candidates;
    EXPECT_TRUE(candidates.none());
    EXPECT_TRUE(candidates.offer(4, -2.0, -5.0));  // near, but unlikely: its covariance is large
    EXPECT_EQ(candidates.second_log(), BestTwo::kNothing);
    EXPECT_TRUE(candidates.offer(5, -1.0, 0.5));
    EXPECT_FALSE(candidates.offer(6, -3.0, -1.0));  // farther than the first, yet more likely
    EXPECT_FALSE(candidates.offer(7, -1.0, -9.0));  // as near as the best: the first stays
    EXPECT_FALSE(candidates.none());
    EXPECT_EQ(candidates.best(), 5U);
    EXPECT_EQ(candidates.best_log(), 0.5);
    EXPECT_EQ(candidates.second_log(), -1.0);
    BestTwo overtaken;
    overtaken.offer(0, 1.0, 1.0);
    overtaken.offer(1, 2.0, 2.0);
    EXPECT_EQ(overtaken.second_log(), 1.0);
}

TEST(AssociationRule, IsAmbiguousFromTheRatioOnAndAboveALeastLikelihood) {
    AssociationParams params;
    params.ambiguity_ratio = 0.1;
    const AssociationRule rule(params);
    const auto pair = [](double second) {
        BestTwo candidates;
        candidates.offer(0, 0.0, std::log(1.0));
        candidates.offer(1, -1.0, std::log(second));
        return candidates;
    };
    EXPECT_TRUE(rule.ambiguous(pair(0.11)));
    EXPECT_FALSE(rule.ambiguous(pair(0.09)));
    EXPECT_TRUE(rule.ambiguous(pair(0.11), std::log(0.10)));
    EXPECT_FALSE(rule.ambiguous(pair(0.11), std::log(0.12)));
    params.ambiguity = AmbiguityRule::off;
    EXPECT_FALSE(AssociationRule(params).ambiguous(pair(0.9)));
    EXPECT_NEAR(rule.gate(), 5.991, 1e-3);  // chi-square, 2 degrees of freedom, 95 %
}

TEST(Association, AHighP0MakesEverythingNew) {
    AssociationParams params;
    params.p0 = 1000.0;  // above the greatest likelihood there is
    OwnLandmarks<SensorRecta> own;
    LineColumns lines = own.columns();
    lines.set(lines.append(), {{2.0, 0.0}, Matrix2::Zero()});
    const Associator associator(params);
    const SeenFeature seen = associator.seen({{2.0, 0.0}, Matrix2::Identity()});
    EXPECT_EQ(associator.decide<SensorRecta>(lines, Pose{}, {seen, 1.0, 0.0}).outcome,
              Outcome::created);
}

}  // namespace
}  // namespace hitos
