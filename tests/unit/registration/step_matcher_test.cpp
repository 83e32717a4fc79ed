// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_matcher.hpp"

#include <gtest/gtest.h>

#include "drawn_scan.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/registration_params.hpp"

namespace hitos {
namespace {

using test::drawn_points;

/// Steps against the map of a room unlike itself turned, seen from three places.
class Steps : public testing::Test {
  protected:
    Steps() {
        map_.begin({0.0, 0.0}, 40.0);
        for (const Pose& from : {Pose{0.0, 0.0, 0.3}, Pose{0.3, 0.2, 2.5}, Pose{0.2, 0.1, -2.0}}) {
            map_.add(drawn_points(room_, from), from, 0);
        }
        map_.build();
    }
    MatchedStep match(const Pose& odometry, double sigma_m, double sigma_rad,
                      bool search = true) const {
        RegistrationParams params;
        params.search = search;
        const StepMatcher matcher(params, ScanMatcher(params.point_sigma_m));
        Eigen::Matrix3d information = Eigen::Matrix3d::Identity() / (sigma_m * sigma_m);
        information(2, 2) = 1.0 / (sigma_rad * sigma_rad);
        return matcher.match(drawn_points(room_, truth_), map_, {odometry, information, false},
                             {sigma_m, sigma_rad});
    }
    void expect_truth(const MatchedStep& step) const {
        EXPECT_TRUE(step.matched);
        EXPECT_GT(step.score, 0.7);
        EXPECT_NEAR(step.pose.x, truth_.x, 0.03);
        EXPECT_NEAR(step.pose.y, truth_.y, 0.03);
        EXPECT_NEAR(step.pose.theta, truth_.theta, 0.01);
    }

    const Walls room_ = test::recess_room();
    const Pose truth_{0.4, -0.3, 0.7};
    PointMap map_;
};

TEST_F(Steps, ANearStartIsMatched) {
    expect_truth(match({0.45, -0.25, 0.72}, 0.1, 0.05));
}

TEST_F(Steps, OdometryThatSlippedInHeadingIsMatchedFromATurnedStart) {
    const auto scan = drawn_points(room_, truth_);
    const ScanMatcher matcher(RegistrationParams{}.point_sigma_m);
    int rescued = 0;
    for (int i = -12; i <= 12; ++i) {
        const Pose odometry{truth_.x, truth_.y, truth_.theta + 0.1 * i};
        const PosePrior prior{odometry, Eigen::Vector3d(100.0, 100.0, 11.0).asDiagonal()};
        const bool straight =
            match_score(scan, map_, matcher.fit(scan, map_, odometry, prior), 1) > 0.7;
        const MatchedStep step = match(odometry, 0.1, 0.3, false);
        if (straight) {
            expect_truth(step);
        } else if (step.score > 0.7) {
            expect_truth(step);
            ++rescued;
        }
    }
    EXPECT_GE(rescued, 2) << "slips too great for the fit from the odometry's own pose";
}

TEST_F(Steps, ASearchFindsWhatNoStartReaches) {
    const Pose far{truth_.x + 1.3, truth_.y - 1.0, truth_.theta - 0.4};
    EXPECT_LT(match(far, 0.6, 0.3, false).score, 0.5);
    expect_truth(match(far, 0.6, 0.3));
}

TEST_F(Steps, WhereNothingFitsItStaysWithTheOdometry) {
    const Pose outside{30.0, 30.0, 0.0};
    const MatchedStep step = match(outside, 0.1, 0.05);
    EXPECT_FALSE(step.matched);
    EXPECT_EQ(step.pose, outside);
}

TEST_F(Steps, WhatDepartsFromTheOdometryScoresLess) {
    // By a twentieth for each metre and radian: of places that fit alike the nearest is taken.
    const Pose odometry{0.7, -0.1, 0.85};
    const MatchedStep step = match(odometry, 0.3, 0.2);
    expect_truth(step);
    const double departs = std::hypot(step.pose.x - odometry.x, step.pose.y - odometry.y) +
                           std::abs(step.pose.theta - odometry.theta);
    EXPECT_GT(departs, 0.4);
    EXPECT_NEAR(step.score,
                match_score(drawn_points(room_, truth_), map_, step.pose, 2) - 0.05 * departs,
                1e-9);
}

}  // namespace
}  // namespace hitos
