#include "hitos/simulation/odometry_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hitos/capture/error.hpp"

namespace hitos {
namespace {

struct Moments {
    double mean_v = 0.0, var_v = 0.0, mean_w = 0.0, var_w = 0.0, covariance = 0.0;
};

Moments moments(OdometryNoiseKind kind, const Twist& twist) {
    constexpr int kDraws = 100000;
    OdometryNoise noise(0.1, kind, 11);
    Moments m;
    for (int i = 0; i < kDraws; ++i) {
        const Odometria noisy = noise({0.1 * i, twist, 0});
        const double v = noisy.twist.v - twist.v;
        const double w = noisy.twist.w - twist.w;
        m.mean_v += v / kDraws;
        m.mean_w += w / kDraws;
        m.var_v += v * v / kDraws;
        m.var_w += w * w / kDraws;
        m.covariance += v * w / kDraws;
    }
    return m;
}

/// Five standard errors over 100,000 draws: of a mean sigma / sqrt(n), of a variance
/// sigma^2 sqrt(2 / n), of the covariance of independent draws sigma_v sigma_w / sqrt(n).
void expect_moments(const Moments& m, double sigma_v, double sigma_w) {
    const double root = std::sqrt(100000.0);
    EXPECT_NEAR(m.mean_v, 0.0, 5.0 * sigma_v / root);
    EXPECT_NEAR(m.mean_w, 0.0, 5.0 * sigma_w / root);
    EXPECT_NEAR(m.var_v, sigma_v * sigma_v, 5.0 * std::sqrt(2.0) * sigma_v * sigma_v / root);
    EXPECT_NEAR(m.var_w, sigma_w * sigma_w, 5.0 * std::sqrt(2.0) * sigma_w * sigma_w / root);
    EXPECT_NEAR(m.covariance, 0.0, 5.0 * sigma_v * sigma_w / root);
}

TEST(OdometryNoise, RelativeSigma) {
    expect_moments(moments(OdometryNoiseKind::relative_sigma, {0.5, 0.0, -0.8}), 0.05, 0.08);
}

TEST(OdometryNoise, Variance) {
    expect_moments(moments(OdometryNoiseKind::variance, {0.5, 0.0, -0.8}), std::sqrt(0.05),
                   std::sqrt(0.08));
}

TEST(OdometryNoise, RestStaysRestAndTheLateralPartScalesWithV) {
    OdometryNoise noise(0.1, OdometryNoiseKind::relative_sigma, 1);
    EXPECT_EQ(noise({1.0, {}, 0}).twist, Twist{});
    const Odometria noisy = noise({1.1, {0.5, 0.05, 0.1}, 0});
    EXPECT_NEAR(noisy.twist.v_lateral / noisy.twist.v, 0.1, 1e-12);
}

TEST(OdometryNoise, LevelZeroChangesNothing) {
    OdometryNoise noise(0.0, OdometryNoiseKind::variance, 1);
    const Twist twist{0.5, 0.01, 0.1};
    EXPECT_EQ(noise({1.0, twist, 0}).twist, twist);
}

TEST(OdometryNoise, RefusesImpossibleLevels) {
    EXPECT_THROW(OdometryNoise(-0.1, OdometryNoiseKind::variance, 1), ConfigError);
    EXPECT_THROW(OdometryNoise(std::nan(""), OdometryNoiseKind::variance, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
