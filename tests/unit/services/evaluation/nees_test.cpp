// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/nees.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace hitos {
namespace {

TEST(Nees, IsTheSquaredErrorInUnitsOfItsDeviations) {
    const Eigen::Vector3d variances(0.01, 0.04, 0.0025);
    const Pose truth{1.0, 2.0, 0.5};
    // (0.3 / 0.1)^2 + (0.2 / 0.2)^2 + (0.1 / 0.05)^2
    EXPECT_NEAR(pose_nees({1.3, 1.8, 0.6}, variances.asDiagonal(), truth).value(), 14.0, 1e-9);
    EXPECT_EQ(pose_nees(truth, variances.asDiagonal(), truth).value(), 0.0);
}

TEST(Nees, HeedsCorrelations) {
    Eigen::Matrix3d covariance;
    covariance << 4.0, 2.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 1.0;
    // The inverse of the first block is [4 -2; -2 4] / 12.
    EXPECT_NEAR(pose_nees({2.0, 0.0, 1.0}, covariance, {}).value(), 16.0 / 12.0 + 1.0, 1e-9);
    EXPECT_NEAR(pose_nees({2.0, 2.0, 0.0}, covariance, {}).value(), 16.0 / 12.0, 1e-9);
    EXPECT_NEAR(pose_nees({2.0, -2.0, 0.0}, covariance, {}).value(), 48.0 / 12.0, 1e-9);
}

TEST(Nees, TheHeadingsErrorIsTheShortWayRound) {
    const Eigen::Vector3d variances(1.0, 1.0, 0.01);
    EXPECT_NEAR(
        pose_nees({0.0, 0.0, kPi - 0.1}, variances.asDiagonal(), {0.0, 0.0, -kPi + 0.1}).value(),
        4.0, 1e-9);
}

TEST(Nees, SaysNothingWhereThereIsNoInverse) {
    EXPECT_EQ(pose_nees({1.0, 0.0, 0.0}, Eigen::Matrix3d::Zero(), {}), std::nullopt);
    // Of two particles: all lies on one line.
    const Eigen::Vector3d away(0.3, -0.2, 0.1);
    EXPECT_EQ(pose_nees({1.0, 0.0, 0.0}, away * away.transpose(), {}), std::nullopt);
}

/// By its law: of errors drawn with the covariance that it is told, 95 % lie in the interval, and
/// the mean is 3; of a filter that believes in half the deviations it is 12.
TEST(Nees, OfHonestErrorsIsAChiSquareVariableOfThreeDegrees) {
    Eigen::Matrix3d root;
    root << 0.3, 0.0, 0.0, 0.1, 0.05, 0.0, -0.02, 0.01, 0.002;
    const Eigen::Matrix3d covariance = root * root.transpose();
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    constexpr int kDraws = 20000;
    int below = 0;
    int above = 0;
    double sum = 0.0;
    double sum_of_sure = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const Eigen::Vector3d e =
            root * Eigen::Vector3d(normal(engine), normal(engine), normal(engine));
        const Pose truth{-4.0, 2.0, 3.1};
        const Pose estimate{truth.x + e(0), truth.y + e(1), wrap_angle(truth.theta + e(2))};
        const double nees = pose_nees(estimate, covariance, truth).value();
        below += nees < kNeesLow ? 1 : 0;
        above += nees > kNeesHigh ? 1 : 0;
        sum += nees;
        sum_of_sure += pose_nees(estimate, covariance / 4.0, truth).value();
    }
    // Three deviations of the counts and of the mean.
    EXPECT_NEAR(below, 0.025 * kDraws, 66);
    EXPECT_NEAR(above, 0.025 * kDraws, 66);
    EXPECT_NEAR(sum / kDraws, kNeesMean, 0.06);
    EXPECT_NEAR(sum_of_sure / kDraws, 4.0 * kNeesMean, 0.24);
}

}  // namespace
}  // namespace hitos
