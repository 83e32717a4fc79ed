// SPDX-License-Identifier: GPL-3.0-or-later
// Scans that are not of one laser in one place: the odometry is not blamed for it, nor is advised
// what makes the map worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "integration/wrong_tours.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using test::read;
using test::Readings;

bool advises_scans(const Readings& tour) {
    return std::ranges::any_of(tour.findings(), [](const TourFinding& finding) {
        return advice_of(finding).english().find("source.odometry=scans") != std::string::npos;
    });
}

double range_of(const Scan& scan, std::size_t point) {
    const Point2 laser{scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y};
    return hitos::distance(laser, scan.points[point]);
}

/// The same rays with other ranges.
Scan with_ranges(const Scan& scan, const std::vector<double>& ranges) {
    Scan other = scan;
    other.points.clear();
    other.rays.clear();
    for (std::size_t i = 0; i < ranges.size(); ++i)
        test::add_reading(other, scan.rays[i], ranges[i]);
    return other;
}

std::vector<double> ranges_of(const Scan& scan) {
    std::vector<double> ranges;
    for (std::size_t i = 0; i < scan.points.size(); ++i) ranges.push_back(range_of(scan, i));
    return ranges;
}

class ScansOf : public testing::TestWithParam<const char*> {
  protected:
    Readings tour_ = read(source_named(GetParam()));
};

TEST_P(ScansOf, ASecondRobotBetweenThemIsTold) {
    Readings two = tour_;
    two.scans.clear();
    const std::size_t count = tour_.scans.size();
    for (std::size_t i = 0; i < count; ++i) {
        two.scans.push_back(tour_.scans[i]);
        Scan other = tour_.scans[(i + count / 2) % count];
        other.time_s = tour_.scans[i].time_s + 0.01;
        other.line = tour_.scans[i].line;
        two.scans.push_back(std::move(other));
    }
    const auto found = two.of_kind(Kind::foreign_scans);
    ASSERT_TRUE(found) << two.said();
    EXPECT_GT(found->value, 0.1);
    EXPECT_FALSE(advises_scans(two)) << two.said();
}

TEST_P(ScansOf, EmptyScansBetweenThemAreOfNoOtherRobot) {
    Readings gaps = tour_;
    for (std::size_t i = 0; i < gaps.scans.size(); i += 20) {
        gaps.scans[i].points.clear();
        gaps.scans[i].rays.clear();
    }
    EXPECT_FALSE(gaps.of_kind(Kind::foreign_scans)) << gaps.said();
}

/// As of two lasers whose scans are joined, where that of one did not come.
TEST_P(ScansOf, HalvesOfAFanAreOfNoOtherRobot) {
    Readings halves = tour_;
    for (std::size_t i = 0; i < halves.scans.size(); i += 7) {
        Scan& scan = halves.scans[i];
        const std::uint32_t first = scan.fan.count / 2;
        Scan left = scan;
        left.points.clear();
        left.rays.clear();
        left.fan.min_angle_rad = scan.fan.angle_rad(first);
        left.fan.count -= first;
        for (std::size_t p = 0; p < scan.points.size(); ++p) {
            if (scan.rays[p] < first) continue;
            left.points.push_back(scan.points[p]);
            left.rays.push_back(scan.rays[p] - first);
        }
        scan = std::move(left);
    }
    EXPECT_FALSE(halves.of_kind(Kind::foreign_scans)) << halves.said();
}

TEST_P(ScansOf, RaysInAnyOrderAreNoFaultOfTheOdometry) {
    Readings shuffled = tour_;
    std::mt19937 random(1);
    for (Scan& scan : shuffled.scans) {
        std::vector<double> ranges = ranges_of(scan);
        std::ranges::shuffle(ranges, random);
        scan = with_ranges(scan, ranges);
    }
    const auto found = shuffled.of_kind(Kind::foreign_scans);
    ASSERT_TRUE(found) << shuffled.said();
    EXPECT_LT(found->value, 0.4);
    EXPECT_FALSE(shuffled.of_kind(Kind::unfit_odometry));
    EXPECT_FALSE(advises_scans(shuffled)) << shuffled.said();
}

TEST_P(ScansOf, ReadingsInStepsAreToldFromAFifthOfAMetreOn) {
    const auto in_steps = [this](double step) {
        Readings coarse = tour_;
        for (Scan& scan : coarse.scans) {
            std::vector<double> ranges = ranges_of(scan);
            for (double& range : ranges) range = std::max(1.0, std::round(range / step)) * step;
            scan = with_ranges(scan, ranges);
        }
        return coarse;
    };
    for (const double step : {0.2, 0.5}) {
        const auto found = in_steps(step).of_kind(Kind::laser_units);
        ASSERT_TRUE(found) << step;
        EXPECT_NE(found->what.english().find(step == 0.5 ? "steps of 0.5 m" : "steps of 0.2 m"),
                  std::string::npos);
    }
    EXPECT_FALSE(in_steps(0.05).of_kind(Kind::laser_units));
}

TEST_P(ScansOf, ALaserThatHungFromTheBeginIsNoClock) {
    Readings hung = tour_;
    for (Scan& scan : hung.scans) {
        scan.points = tour_.scans.front().points;
        scan.rays = tour_.scans.front().rays;
    }
    ASSERT_TRUE(hung.of_kind(Kind::frozen_laser)) << hung.said();
    for (const Kind clock : {Kind::clock_speed, Kind::clock_set, Kind::scan_delay})
        EXPECT_FALSE(hung.of_kind(clock)) << hung.said();
}

INSTANTIATE_TEST_SUITE_P(Worlds, ScansOf, testing::Values("bigloop", "complex", "park"));

// Long walls say nothing of the way along them: who takes how the robot moved from such scans gets
// lost, though they lie on each other well.
TEST(TourScans, AreNotAdvisedWhereTheyDoNotShowHowTheRobotMoved) {
    const auto unfit = [](const char* world) {
        Readings tour = read(source_named(world));
        const double middle = tour.odometry[tour.odometry.size() / 2].time_s;
        for (Odometria& reading : tour.odometry) {
            // The way of the tour's other half, as of another robot.
            const double twice = reading.time_s < middle ? 1.0 : -1.0;
            reading.twist.w = 0.4 * twice - reading.twist.w;
            reading.twist.v = 0.3;
        }
        return tour;
    };
    const Readings long_walls = unfit("bigloop");
    EXPECT_NE(long_walls.said(), "");
    EXPECT_FALSE(advises_scans(long_walls)) << long_walls.said();
    const Readings recesses = unfit("park");
    EXPECT_TRUE(advises_scans(recesses)) << recesses.said();
}

}  // namespace
}  // namespace hitos
