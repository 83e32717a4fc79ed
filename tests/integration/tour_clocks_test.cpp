// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks that do not stay as they are, fans of other angles and odometry that wavers: told with
// their numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/scan_clock.hpp"
#include "integration/wrong_tours.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using test::Readings;

class OfClocks : public testing::TestWithParam<std::string> {
  protected:
    Readings tour_ = test::read(source_named(GetParam()));
    double begin_s_ = tour_.scans.front().time_s;
    double seconds_ = tour_.scans.back().time_s - begin_s_;

    static std::string clock_of(const TourFinding& found) {
        const SourceSetting& set = found.remedies.at(0).settings.at(0);
        EXPECT_EQ(set.key, kScanClockKey);
        return set.value;
    }

    /// As is advised.
    static void add(const TourFinding& found, Readings& tour) {
        EXPECT_NE(advice_of(found).english().find("--scan-delay " + clock_of(found)),
                  std::string::npos);
        ScanClock clock(clock_of(found));
        for (Scan& scan : tour.scans) scan.time_s += clock.added(scan.time_s);
    }
};

TEST_P(OfClocks, AClockThatRunsAtAnotherSpeedIsTold) {
    for (const double seconds : {-1.0, 6.0}) {
        Readings fast = tour_;
        const double gained = seconds / seconds_;
        for (Scan& scan : fast.scans)
            scan.time_s = begin_s_ + (scan.time_s - begin_s_) * (1.0 + gained);
        const auto found = fast.of_kind(Kind::clock_speed);
        ASSERT_TRUE(found) << seconds << '\n' << fast.said();
        EXPECT_NEAR(found->value, -gained, 0.2 * std::abs(gained)) << seconds;
        add(*found, fast);
        EXPECT_EQ(fast.said(), "") << seconds;
    }
}

TEST_P(OfClocks, AClockThatIsSetDuringTheTourIsTold) {
    for (const double by_s : {-3.0, 5.0}) {
        Readings set = tour_;
        for (Scan& scan : set.scans) {
            if (scan.time_s > begin_s_ + 0.6 * seconds_) scan.time_s += by_s;
        }
        const auto found = set.of_kind(Kind::clock_set);
        ASSERT_TRUE(found) << by_s << '\n' << set.said();
        EXPECT_NEAR(found->value, -by_s, 0.3) << by_s;
        add(*found, set);
        EXPECT_EQ(set.said(), "") << by_s;
        for (std::size_t i = 1; i < set.scans.size(); ++i) {
            EXPECT_LT(set.scans[i - 1].time_s, set.scans[i].time_s) << clock_of(*found);
        }
    }
}

TEST_P(OfClocks, AClockThatIsSetSeveralTimesIsTold) {
    struct Set {
        double share;  ///< of the tour, where it is done
        double by_s;
    };
    const std::vector<std::vector<Set>> all{{{0.3, 6.0}, {0.7, -6.0}},   // and set back
                                            {{0.4, 8.0}, {0.55, -8.0}},  // soon
                                            {{0.2, 4.0}, {0.5, 4.0}, {0.8, -3.0}}};
    for (const std::vector<Set>& sets : all) {
        Readings set = tour_;
        for (Scan& scan : set.scans) {
            const double share = (scan.time_s - begin_s_) / seconds_;
            for (const Set& one : sets) scan.time_s += share > one.share ? one.by_s : 0.0;
        }
        const auto found = set.of_kind(Kind::clock_set);
        ASSERT_TRUE(found) << sets.size() << '\n' << set.said();
        EXPECT_NEAR(found->value, -sets.front().by_s, 0.3);
        add(*found, set);
        EXPECT_EQ(set.said(), "") << clock_of(*found);
        for (std::size_t i = 1; i < set.scans.size(); ++i) {
            EXPECT_NEAR(set.scans[i].time_s, tour_.scans[i].time_s, 0.1) << clock_of(*found);
        }
    }
}

TEST_P(OfClocks, AFanOfOtherAnglesIsTold) {
    for (const double factor : {0.75, 1.3}) {
        Readings stated = tour_;
        for (Scan& scan : stated.scans) {
            for (Point2& point : scan.points) {
                const Pose& mount = scan.fan.pose_robot_laser;
                const Point2 seen = transform(inverse(mount), point);
                const double angle = factor * std::atan2(seen.y, seen.x);
                const double range = std::hypot(seen.x, seen.y);
                point = transform(mount, Point2{range * std::cos(angle), range * std::sin(angle)});
            }
            scan.fan.min_angle_rad *= factor;
            scan.fan.max_angle_rad *= factor;
        }
        const auto found = stated.of_kind(Kind::wrong_fan);
        ASSERT_TRUE(found) << factor << '\n' << stated.said();
        const Fan& fan = tour_.scans.front().fan;
        EXPECT_NEAR(found->value, fan.max_angle_rad - fan.min_angle_rad, 0.07) << factor;
    }
}

TEST_P(OfClocks, StampsThatWaverAreTold) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> late(0.0, 0.8);
    Readings wavering = tour_;
    for (Scan& scan : wavering.scans) scan.time_s += late(random);
    std::ranges::sort(wavering.scans, {}, &Scan::time_s);
    for (std::size_t i = 0; i < tour_.scans.size(); ++i)
        wavering.scans[i].line = tour_.scans[i].line;
    EXPECT_TRUE(wavering.of_kind(Kind::unfit_odometry)) << wavering.said();
}

/// Where scans come when the robot has moved, stamps leap wherever it stood, and by how much says
/// nothing of the clock.
TEST(RealClocks, OneThatIsSetIsToldRightlyWhereTheRobotStoodNowAndThen) {
    for (const char* name : {"freiburg-101", "intel"}) {
        const auto log = test::shared_log(std::string("radish/") + name + ".log.gz");
        HITOS_SKIP_WITHOUT(log);
        Readings set = test::read(log.string());
        const double middle_s = (set.scans.front().time_s + set.scans.back().time_s) / 2.0;
        for (Scan& scan : set.scans) scan.time_s += scan.time_s > middle_s ? 10.0 : 0.0;
        const auto found = set.of_kind(Kind::clock_set);
        ASSERT_TRUE(found) << name << '\n' << set.said();
        EXPECT_NEAR(found->value, -10.0, 0.3) << name;  // freiburg-101 has 0.15 of its own
    }
}

INSTANTIATE_TEST_SUITE_P(Worlds, OfClocks, testing::Values("recinto", "bigloop", "complex"),
                         [](const auto& world) { return world.param; });

}  // namespace
}  // namespace hitos
