// SPDX-License-Identifier: GPL-3.0-or-later
#include "association/measurement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace hitos {
namespace {

TEST(Measurements, TakeTheFixedVariancesWhereTheFeaturesHaveNone) {
    Observation seen;
    seen.lines.push_back({{2.0, 0.3}, 0, 0});
    seen.corners.push_back({3.0, 4.0});
    Measurements measurements;
    measure(seen, {0.04, 0.00122}, measurements);
    ASSERT_EQ(measurements.size(), 2U);
    for (const Measurement& m : {measurements[0], measurements[1]}) {
        EXPECT_EQ(m.r(0, 0), 0.04);
        EXPECT_EQ(m.r(1, 1), 0.00122);
        EXPECT_EQ(m.r(0, 1), 0.0);
    }
    EXPECT_EQ(measurements.of<SensorRecta>()[0].z, Vector2(2.0, 0.3));
    EXPECT_NEAR(measurements.of<SensorEsquina>()[0].z(0), 5.0, 1e-12);
}

TEST(Measurements, IdentitiesGoAlongWhereTheyAreBelieved) {
    Observation seen;
    seen.lines.push_back({{2.0, 0.3}, 0, 0});
    seen.corners = {{3.0, 4.0}, {1.0, 0.0}};
    seen.identities = {kNameless, 7};
    seen.line_covariances.emplace_back(1e-4 * Matrix2::Identity());
    seen.corner_covariances.emplace_back(1e-4 * Matrix2::Identity());  // the second one has none
    Measurements measurements;
    measure(seen, {0.04, 0.00122}, measurements);
    EXPECT_EQ(measurements[0].identity, kNameless);
    EXPECT_EQ(measurements[1].identity, kNameless);
    EXPECT_EQ(measurements[2].identity, 7);
    EXPECT_EQ(measurements[2].r(0, 0), 0.04);
    measure(seen, {}, measurements, false);
    EXPECT_EQ(measurements[2].identity, kNameless);
}

TEST(Measurements, ACornerRightAtTheRobotTakesTheFixedVariances) {
    // Its bearing means nothing, whatever its own covariance makes of it.
    Observation seen;
    seen.corners.push_back({0.5e-3, 0.0});
    seen.corner_covariances.emplace_back(1e-4 * Matrix2::Identity());
    ObservationParams params;
    Measurements measurements;
    measure(seen, params, measurements);
    const Matrix2 r = measurements.of<SensorEsquina>()[0].r;
    seen.corner_covariances.clear();
    measure(seen, params, measurements);
    EXPECT_EQ(r, measurements.of<SensorEsquina>()[0].r);
}

TEST(Measurements, ACornersCovarianceIsThatOfRangeAndBearing) {
    Matrix2 covariance;
    covariance << 4e-4, 1e-4, 1e-4, 9e-4;
    Observation seen;
    seen.corners.push_back({3.0, -4.0});
    seen.corner_covariances.push_back(covariance);
    Measurements measurements;
    measure(seen, {}, measurements);
    // Against draws.
    const Matrix2 root = covariance.llt().matrixL();
    std::mt19937 engine(61);
    std::normal_distribution<double> normal(0.0, 1.0);
    Matrix2 sampled = Matrix2::Zero();
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
        const Vector2 p = Vector2(3.0, -4.0) + root * Vector2(normal(engine), normal(engine));
        const Vector2 away =
            SensorEsquina::measurement({p(0), p(1)}) - measurements.of<SensorEsquina>()[0].z;
        sampled += away * away.transpose() / kDraws;
    }
    // The standard error of a sampled variance is sqrt(2 / n), 0.7 %.
    const double scale0 = std::sqrt(sampled(0, 0));
    const double scale1 = std::sqrt(sampled(1, 1));
    EXPECT_NEAR(measurements.of<SensorEsquina>()[0].r(0, 0) / sampled(0, 0), 1.0, 0.04);
    EXPECT_NEAR(measurements.of<SensorEsquina>()[0].r(1, 1) / sampled(1, 1), 1.0, 0.04);
    EXPECT_NEAR(measurements.of<SensorEsquina>()[0].r(0, 1) / (scale0 * scale1),
                sampled(0, 1) / (scale0 * scale1), 0.03);
}

}  // namespace
}  // namespace hitos
