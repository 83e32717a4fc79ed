// SPDX-License-Identifier: GPL-3.0-or-later
// Tours that look wrong and are not, or are wrong in another way than they look: what is advised
// of them must not make them worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "integration/wrong_tours.hpp"
#include "support.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using test::add_reading;
using test::Readings;

struct SeededWorld {
    const char* world;
    const char* set;
    std::uint64_t seed;
};

Readings read_seeded(const SeededWorld& tour) {
    SourceParams params;
    params.file = source_named(tour.world);
    params.world_set = tour.set;
    params.tour_seed = tour.seed;
    return test::read(params);
}

/// Each of them was told to have another clock, other turns, or wheels that slip.
TEST(SoundTours, SlowOrCoarseSensorsAreNoDoubt) {
    const std::vector<SeededWorld> tours{{"corridor-cluttered", "odometry.rate=2", 1},
                                         {"corridor-cluttered", "odometry.rate=2", 2},
                                         {"corridor-cluttered", "odometry.rate=1", 1},
                                         {"corridor-cluttered", "odometry.noise=0.2", 2},
                                         {"orchard", "odometry.noise=0.2", 2},
                                         {"campus", "odometry.noise=0.1", 7},
                                         {"campus", "", 7},
                                         {"usc-sal", "laser.field_of_view=90 laser.rays=91", 1},
                                         {"bigloop", "laser.rays=20", 1}};
    for (const SeededWorld& tour : tours)
        EXPECT_EQ(read_seeded(tour).said(), "") << tour.world << ' ' << tour.set;
}

/// Scans of where the robot stood a while ago, and odometry that drives on meanwhile: no driver
/// begins anew so.
TEST(SoundTours, WhoDrivesOnThroughAPauseOfTheScansDoesNotBeginAnew) {
    Readings tour = test::read(source_named("recinto"));
    const double begin_s = tour.scans[tour.scans.size() / 2].time_s;
    constexpr double kPause = 8.0;
    std::erase_if(tour.scans, [&](const Scan& scan) {
        return scan.time_s > begin_s && scan.time_s < begin_s + kPause;
    });
    const auto behind =
        std::ranges::find_if(tour.scans, [&](const Scan& scan) { return scan.time_s > begin_s; });
    ASSERT_NE(behind, tour.scans.begin());
    behind->points = (behind - 1)->points;
    behind->points.front().x += 1e-4;  // else it hangs
    EXPECT_FALSE(tour.of_kind(Kind::leaping_odometry)) << tour.said();
}

TEST(SoundTours, ALaserThatIsTurnedALittleIsNoWheelThatIsSmaller) {
    for (const double degrees : {5.0, -5.0, 8.0}) {
        for (const char* name : {"player/bigloop", "player/recinto", "radish/infinite-corridor"}) {
            const auto log = test::shared_log(std::string(name) + ".log.gz");
            HITOS_SKIP_WITHOUT(log);
            Readings tour = test::read(log.string());
            for (Scan& scan : tour.scans) {
                const Pose laser = scan.fan.pose_robot_laser;
                const Pose turned = compose(laser, {0, 0, -degrees * kRadiansPerDegree});
                for (Point2& point : scan.points)
                    point = transform(turned, transform(inverse(laser), point));
            }
            const auto found = tour.of_kind(Kind::turned_laser);
            ASSERT_TRUE(found) << name << degrees << tour.said();
            EXPECT_NEAR(found->value, degrees * kRadiansPerDegree, 2.0 * kRadiansPerDegree) << name;
        }
    }
}

/// As a part of the robot, a floor, or a hung laser are.
TEST(SoundTours, WhatRaysRepeatIsNoReachWhereItIsShortOrUnlike) {
    for (const bool near : {true, false}) {
        Readings tour = test::read(source_named("recinto"));
        for (Scan& scan : tour.scans) {
            scan.points.clear();
            scan.rays.clear();
            for (std::uint32_t ray = 0; ray < scan.fan.count; ++ray)
                add_reading(scan, ray, near ? 0.35 : 2.5 + 0.2 * ray);
        }
        EXPECT_FALSE(tour.of_kind(Kind::no_return)) << tour.said();
    }
}

TEST(SoundTours, ALaserFartherOffThanARobotIsLargeIsToldAsThat) {
    for (const double off_m : {200.0, 10.0}) {
        Readings tour = test::read(source_named("bigloop"));
        for (Scan& scan : tour.scans) {
            const Pose laser = scan.fan.pose_robot_laser;
            scan.fan.pose_robot_laser.x += off_m;
            for (Point2& point : scan.points)
                point = transform(scan.fan.pose_robot_laser, transform(inverse(laser), point));
        }
        const auto found = tour.findings();
        ASSERT_EQ(found.size(), 1U) << tour.said();
        EXPECT_EQ(found[0].kind, Kind::misplaced_laser);
        EXPECT_NEAR(found[0].value, off_m, 0.5);
        ASSERT_EQ(found[0].remedies.size(), 1U);
        EXPECT_EQ(found[0].remedies[0].settings.size(), 1U);
    }
}

TEST(SoundTours, WhereReadingsAndPositionsAreOfOneUnitBothAreSaid) {
    for (const double per_metre : {100.0, 1000.0}) {
        Readings tour = test::read(source_named("bigloop"));
        for (Odometria& reading : tour.odometry) reading.twist.v *= per_metre;
        for (Scan& scan : tour.scans)
            for (Point2& point : scan.points) point = {per_metre * point.x, per_metre * point.y};
        const auto found = tour.findings();
        ASSERT_EQ(found.size(), 1U) << tour.said();
        EXPECT_EQ(found[0].kind, Kind::odometry_units);
        ASSERT_EQ(found[0].remedies.at(0).settings.size(), 2U);
        EXPECT_NEAR(std::stod(found[0].remedies[0].settings[0].value), 1.0 / per_metre, 1e-9);
        EXPECT_NEAR(std::stod(found[0].remedies[0].settings[1].value), 1.0 / per_metre, 1e-9);
    }
}

/// Of which scans lie a metre apart.
TEST(SoundTours, ReadingsOfAnotherUnitPutTheLaserNowhereElse) {
    const auto log = test::shared_log("radish/intel.log.gz");
    HITOS_SKIP_WITHOUT(log);
    const Readings tour = test::read(log.string());
    for (const double metres : {0.01, 0.0254, 0.1}) {
        Readings other = tour;
        for (Scan& scan : other.scans)
            for (Point2& point : scan.points) point = {point.x / metres, point.y / metres};
        const auto found = other.of_kind(Kind::laser_units);
        ASSERT_TRUE(found) << metres << other.said();
        EXPECT_NEAR(std::stod(found->remedies.at(0).settings.at(0).value), metres, 1e-9);
    }
}

TEST(SoundTours, ClocksThatAreMinutesApartAreToldWhereTheTourIsLonger) {
    for (const char* name : {"intel", "aces"}) {
        const auto log = test::shared_log(std::string("radish/") + name + ".log.gz");
        HITOS_SKIP_WITHOUT(log);
        for (const double late_s : {90.0, 300.0}) {
            Readings tour = test::read(log.string());
            for (Scan& scan : tour.scans) scan.time_s += late_s;
            const auto found = tour.of_kind(Kind::scan_delay);
            ASSERT_TRUE(found) << name << late_s << tour.said();
            EXPECT_NEAR(found->value, -late_s, 0.2) << name;
        }
    }
}

}  // namespace
}  // namespace hitos
