// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/worlds/odometry_noise.hpp"

#include <cmath>

#include "hitos/base/error.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

constexpr int kDraws = 100'000;

struct Moments {
    double mean_v = 0.0;
    double mean_w = 0.0;
    double sigma_v = 0.0;
    double sigma_w = 0.0;
    double correlation = 0.0;
};

Moments moments(OdometryNoiseKind kind, double v, double w, double level) {
    OdometryNoise noise(level, kind, 42);
    double sum_v = 0.0, sum_w = 0.0, sum_vv = 0.0, sum_ww = 0.0, sum_vw = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        Odometria reading;
        reading.twist = {v, 0.0, w};
        const Twist noisy = noise(reading).twist;
        const double dv = noisy.v - v;
        const double dw = noisy.w - w;
        sum_v += dv;
        sum_w += dw;
        sum_vv += dv * dv;
        sum_ww += dw * dw;
        sum_vw += dv * dw;
    }
    Moments m;
    m.mean_v = sum_v / kDraws;
    m.mean_w = sum_w / kDraws;
    m.sigma_v = std::sqrt(sum_vv / kDraws);
    m.sigma_w = std::sqrt(sum_ww / kDraws);
    m.correlation = sum_vw / kDraws / (m.sigma_v * m.sigma_w);
    return m;
}

// The standard error of a mean is sigma / sqrt(n), that of a sigma is sigma / sqrt(2 n); five of
// them are allowed.
void expect_moments(const Moments& m, double sigma_v, double sigma_w) {
    EXPECT_NEAR(m.mean_v, 0.0, 5.0 * sigma_v / std::sqrt(kDraws));
    EXPECT_NEAR(m.mean_w, 0.0, 5.0 * sigma_w / std::sqrt(kDraws));
    EXPECT_NEAR(m.sigma_v, sigma_v, 5.0 * sigma_v / std::sqrt(2.0 * kDraws));
    EXPECT_NEAR(m.sigma_w, sigma_w, 5.0 * sigma_w / std::sqrt(2.0 * kDraws));
    EXPECT_NEAR(m.correlation, 0.0, 5.0 / std::sqrt(kDraws));
}

TEST(OdometryNoise, HasASigmaRelativeToTheVelocity) {
    expect_moments(moments(OdometryNoiseKind::relative_sigma, 0.5, -0.3, 0.1), 0.05, 0.03);
}

TEST(OdometryNoise, HasAVarianceRelativeToTheVelocity) {
    expect_moments(moments(OdometryNoiseKind::variance, 0.5, -0.3, 0.1), std::sqrt(0.05),
                   std::sqrt(0.03));
}

TEST(OdometryNoise, LeavesARobotAtRestAndLevel0Alone) {
    OdometryNoise noise(0.1, OdometryNoiseKind::variance, 1);
    OdometryNoise none(0.0, OdometryNoiseKind::relative_sigma, 1);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(noise(Odometria{}).twist, Twist{});
        Odometria moving;
        moving.twist = {0.4, 0.01, 0.2};
        EXPECT_EQ(none(moving).twist, moving.twist);
    }
}

TEST(OdometryNoise, RefusesANegativeOrInfiniteLevel) {
    for (const double level : {-0.1, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(OdometryNoise(level, OdometryNoiseKind::variance, 1), ConfigError);
    }
}

}  // namespace
}  // namespace hitos
