// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::Log;
using ::testing::ElementsAre;

Log normalized(const std::string& text, const ReadOptions& options = {}) {
    return test::read_text("normalized", text, options);
}

TEST(ConversorNormalized, ReadsPointsAndVelocities) {
    const Log log = normalized(
        "ODOM 1.0 9 9\n"
        "ODOM 1.5 0.5 -0.25\n"
        "LASER 1.5 6 1 2 3 4 0 0 5 6 nan 7 8 9\n"
        "ODOM 2.0 0.5 -0.25 0.125\n"
        "LASER 2.0 0\n");
    EXPECT_EQ(log.report.skipped, 0U);
    ASSERT_EQ(log.scans.size(), 2U);
    EXPECT_THAT(log.scans[0].points,
                ElementsAre(Point2{1, 2}, Point2{3, 4}, Point2{5, 6}, Point2{8, 9}));
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0, 2, 3));
    EXPECT_TRUE(log.scans[0].rays.empty());
    EXPECT_EQ(log.scans[0].fan, Fan{});
    EXPECT_TRUE(log.scans[1].points.empty());
    EXPECT_TRUE(log.scans[1].run_starts.empty());
    ASSERT_EQ(log.odometry.size(), 3U);
    EXPECT_EQ(log.odometry[0].twist, Twist{});  // it only sets the clock
    EXPECT_EQ(log.odometry[1].twist, (Twist{0.5, 0, -0.25}));
    EXPECT_EQ(log.odometry[2].twist, (Twist{0.5, 0.125, -0.25}));
}

TEST(ConversorNormalized, ReadsLandmarksThatASensorTellsByThemselves) {
    const Log log = normalized(
        "ODOM 1.0 0 0\n"
        "LANDMARKS 1.5 3 7 2.5 -0.5 -1 3 0.25 0 60 1\n"
        "LANDMARKS 2 0\n",
        {50.0});
    EXPECT_EQ(log.report.skipped, 0U);
    ASSERT_EQ(log.scans.size(), 2U);
    EXPECT_THAT(log.scans[0].landmarks,
                ElementsAre(LandmarkSighting{2.5, -0.5, 7}, LandmarkSighting{3.0, 0.25, -1}));
    EXPECT_TRUE(log.scans[0].points.empty());
    EXPECT_FALSE(log.scans[0].empty());
    EXPECT_TRUE(log.scans[1].empty());
}

TEST(ConversorNormalized, LandmarksAreSeenFromWhereTheirSensorSits) {
    ReadOptions options;
    options.laser_pose = "0.5,0,90";
    const Log log = test::read_text("normalized", "LANDMARKS 1 1 4 1 0\n", options);
    const LandmarkSighting& seen = log.scans.at(0).landmarks.at(0);
    EXPECT_EQ(seen.identity, 4);
    EXPECT_NEAR(distance(seen.point(), {0.5, 1.0}), 0.0, 1e-12);
}

TEST(ConversorNormalized, DamagedLandmarks) {
    const Log log = normalized(
        "LANDMARKS 1 1 3 1 0\n"
        "LANDMARKS 2 1 -2 1 0\n"
        "LANDMARKS 2 1 2147483648 1 0\n"
        "LANDMARKS 2 1 a 1 0\n"
        "LANDMARKS 2 1 3 -1 0\n"
        "LANDMARKS 2 1 3 nan 0\n"
        "LANDMARKS 2 1 3 1\n"
        "LANDMARKS 2 1 3 1 0 0\n"
        "LANDMARKS 2 -1\n");
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.report.skipped, 8U);
}

TEST(ConversorNormalized, MaxRangeOptionCutsPoints) {
    const Log log = normalized("LASER 1 3 1 0 30 40 2 0\n", {50.0});
    EXPECT_THAT(log.scans.at(0).points, ElementsAre(Point2{1, 0}, Point2{2, 0}));
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0, 1));
}

TEST(ConversorNormalized, ReadingsThatNoSensorMakesAreNoPoints) {
    const Log log = normalized("LASER 1 4 1 0 1e250 0 -1e13 2 2 0\n");
    EXPECT_THAT(log.scans.at(0).points, ElementsAre(Point2{1, 0}, Point2{2, 0}));
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0, 1));
}

TEST(ConversorNormalized, APlaceOfTheLaserIsThatOfItsPointsOrigin) {
    ReadOptions options;
    options.laser_pose = "0.5,0,90,upside-down";
    const Log log = test::read_text("normalized", "LASER 1 2 1 0 1 2\n", options);
    const std::vector<Point2>& points = log.scans.at(0).points;
    EXPECT_TRUE(log.scans[0].fan.upside_down);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_NEAR(distance(points[0], {0.5, 1.0}), 0.0, 1e-12);
    EXPECT_NEAR(distance(points[1], {2.5, 1.0}), 0.0, 1e-12);
}

TEST(ConversorNormalized, DamagedLines) {
    const Log log = normalized(
        "LASER 1 1 1 1\n"
        "LASER 2 2 1 1\n"
        "LASER 2 1 1 1 2\n"
        "LASER 2 -1\n"
        "LASER 2 1 1 x\n"
        "LASER\n"
        "ODOM 1 2\n"
        "ODOM 1 2 3 4 5\n"
        "ODOM inf 2 3\n");
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.odometry.size(), 0U);
    EXPECT_EQ(log.report.skipped, 8U);
}

}  // namespace
}  // namespace hitos
