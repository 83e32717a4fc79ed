// SPDX-License-Identifier: GPL-3.0-or-later
// Odometry that begins anew while nothing is recorded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hitos/capture/tour_examination.hpp"

namespace hitos {
namespace {

using ::testing::HasSubstr;

/// What a laser sees all round, in a room of 16 m by 9 m with a pillar from (6, 3) to (7, 4); 30 m
/// and more are too far away.
Scan scan_at(double time_s, const Pose& robot, double length_m) {
    Scan scan;
    scan.time_s = time_s;
    scan.line = static_cast<std::uint64_t>(std::lround(10.0 * time_s));
    scan.fan.count = 360;
    scan.fan.min_angle_rad = -kPi;
    scan.fan.max_angle_rad = kPi - kRadiansPerDegree;
    const auto hits = [&](double angle, double x0, double y0, double x1, double y1, bool inside) {
        // The slab method: the far side of a box that holds the laser, the near one of another.
        const double dx = std::cos(angle);
        const double dy = std::sin(angle);
        const auto [nx, fx] = std::minmax({(x0 - robot.x) / dx, (x1 - robot.x) / dx});
        const auto [ny, fy] = std::minmax({(y0 - robot.y) / dy, (y1 - robot.y) / dy});
        const double near = std::max(nx, ny);
        const double far = std::min(fx, fy);
        if (inside) return far;
        return near > 0.0 && near < far ? near : std::numeric_limits<double>::infinity();
    };
    for (std::uint32_t ray = 0; ray < 360; ++ray) {
        const double angle = robot.theta + scan.fan.angle_rad(ray) + 1e-4;
        double range = hits(angle, 0, 0, length_m, 9, true);
        if (length_m < 100.0) range = std::min(range, hits(angle, 6, 3, 7, 4, false));
        if (range > 30.0) continue;
        const double seen = angle - robot.theta;
        scan.points.push_back({range * std::cos(seen), range * std::sin(seen)});
        scan.rays.push_back(ray);
    }
    return scan;
}

/// A robot that drives along at 0.3 m/s, is not recorded for 40 s after ten, `drives` meanwhile, by
/// its odometry with a step of `logged`, and goes on.
std::vector<TourFinding> told(const Pose& drives, const Pose& logged, double length_m = 16.0) {
    TourExamination examination{ReadOptions{}};
    Pose robot{length_m / 2.0 - 5.0, 2.0, 0.1};
    double time_s = 0.0;
    for (int i = 0; i < 200; ++i) {
        Pose step{0.03, 0.0, 0.005};
        Pose by_odometry = step;
        double seconds = 0.1;
        if (i == 100) {
            seconds = 40.0;
            step = drives;
            by_odometry = logged;
        }
        time_s += seconds;
        robot = compose(robot, step);
        examination.note(Odometria{time_s, twist_between(by_odometry, seconds), 0});
        examination.note(scan_at(time_s, robot, length_m));
    }
    return examination.findings();
}

TEST(TourPauses, OdometryThatBeginsAnewMeanwhileIsTold) {
    const std::vector<TourFinding> found = told({}, {3.0, -4.0, 0.5});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().kind, TourFinding::Kind::leaping_odometry);
    EXPECT_NEAR(found.front().value, 5.0, 0.1);
    EXPECT_THAT(
        found.front().what.english(),
        HasSubstr("after a pause of 40 s the odometry is 5.0 m and 29 degrees off (line 500)"));
    // It may have moved a little.
    EXPECT_EQ(told({0.2, 0.0, 0.1}, {3.0, -4.0, 0.5}).size(), 1U);
    EXPECT_EQ(told({}, {0.0, 0.0, 3.0}).size(), 1U);
}

TEST(TourPauses, NothingIsToldOfARobotThatRestsOrIsDriven) {
    EXPECT_TRUE(told({}, {}).empty());
    EXPECT_TRUE(told({}, {0.1, 0.0, 0.02}).empty());
    EXPECT_TRUE(told({3.0, 2.0, 0.5}, {3.0, 2.0, 0.5}).empty());
    EXPECT_TRUE(told({0.0, 0.0, kPi}, {0.0, 0.0, kPi}).empty());
    // Where it looks alike all along.
    EXPECT_TRUE(told({5.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, 1000.0).empty());
}

TEST(TourPauses, ARobotThatWasCarriedMeanwhileIsTold) {
    const std::vector<TourFinding> found = told({5.0, 3.0, 2.0}, {0.1, 0.0, 0.0});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().kind, TourFinding::Kind::unfit_odometry);
    EXPECT_LT(found.front().value, 0.3);
    EXPECT_THAT(found.front().what.english(),
                HasSubstr("for 40 s there is no scan, and what is seen then (line 500) is not what "
                          "was seen before, though by the odometry it is 0.1 m from there"));
    EXPECT_THAT(advice_of(found.front()).english(), HasSubstr("cut the log at that line"));
}

TEST(TourPauses, AWayThatNobodySawIsTold) {
    // Two rooms: what is seen in the second tells nothing of how the robot came there.
    const std::vector<TourFinding> found = told({5.0, 4.0, 2.0}, {9.0, -8.0, 1.0});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(
        found.front().what.english(),
        HasSubstr("for 40 s there is no scan (line 500), while the robot drives to 12.0 m"));
    EXPECT_TRUE(found.front().remedies.empty());
}

TEST(TourExamination, OfHardlyAnythingNothingIsSaid) {
    TourExamination examination{ReadOptions{}};
    EXPECT_TRUE(examination.findings().empty());
    examination.note(Odometria{0.0, {0.5, 0.0}, 1});
    examination.note(Odometria{0.1, {0.5, 0.0}, 2});
    Scan scan;
    scan.time_s = 0.05;
    scan.points = {{1, 0}, {1, 1}};
    scan.run_starts = {0};
    examination.note(scan);
    EXPECT_TRUE(examination.findings().empty());
}

}  // namespace
}  // namespace hitos
