// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/odometry_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace hitos {
namespace {

TEST(OdometryStep, InformationTurnsWithTheStep) {
    const Eigen::Vector3d variances(0.01, 0.04, 0.001);
    const Eigen::Matrix3d ahead = step_information(variances, 0.0);
    EXPECT_TRUE(ahead.isApprox(Eigen::Matrix3d(variances.cwiseInverse().asDiagonal())));
    // A quarter turn: what was along lies across.
    const Eigen::Matrix3d left = step_information(variances, kPi / 2.0);
    EXPECT_NEAR(left(0, 0), 1.0 / 0.04, 1e-9);
    EXPECT_NEAR(left(1, 1), 1.0 / 0.01, 1e-9);
    EXPECT_NEAR(left(2, 2), 1.0 / 0.001, 1e-9);
    EXPECT_TRUE(turned(left, -kPi / 2.0).isApprox(ahead, 1e-12));
}

TEST(OdometryStep, VariancesGrowWithTheWayAndTheScale) {
    const Eigen::Vector3d still = odometry_variances({}, 1.0);
    EXPECT_NEAR(std::sqrt(still(0)), 0.02, 1e-12);
    EXPECT_NEAR(std::sqrt(still(2)), 0.03, 1e-12);
    const Eigen::Vector3d far = odometry_variances({3.0, 4.0, -0.5}, 2.0);
    EXPECT_NEAR(far(0), 4.0 * (0.0004 + 0.25 + 0.000625), 1e-12);
    EXPECT_NEAR(far(1), 4.0 * (0.0001 + 0.0625 + 0.000625), 1e-12);
    EXPECT_NEAR(far(2), 4.0 * (0.0009 + 0.005625), 1e-12);
}

TEST(LateralCalibration, FindsTheMountingOfTheLaser) {
    // The laser looks 20 mrad to the left and sits 15 cm ahead of the axle.
    std::mt19937 engine(2);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::uniform_real_distribution<double> turn(-0.4, 0.4);
    LateralCalibration calibration;
    for (int i = 0; i < 600; ++i) {
        const Pose step{0.4, 0.0, turn(engine)};
        const double seen = 0.02 * step.x + 0.15 * step.theta + noise(engine);
        calibration.learn(step, seen - calibration.corrected(step).y, 0.01 * 0.01);
    }
    EXPECT_NEAR(calibration.skew_rad(), 0.02, 0.004);
    EXPECT_NEAR(calibration.lever_m(), 0.15, 0.01);
    // A slip teaches nothing.
    const double before = calibration.skew_rad();
    calibration.learn({0.4, 0.0, 0.0}, 1.0, 0.01 * 0.01);
    EXPECT_EQ(calibration.skew_rad(), before);
}

}  // namespace
}  // namespace hitos
