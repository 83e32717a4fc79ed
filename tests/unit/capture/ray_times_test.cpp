// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that are measured one after the other while the robot drives on.
#include <gmock/gmock.h>

#include <cmath>

#include "hitos/capture/odometry_track.hpp"
#include "unit/capture/ros_packings.hpp"
#include "unit/capture/ros_tours.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Bytes;
using test::Log;
using test::Said;
using test::Stamp;

constexpr std::uint32_t kBegin = 1'700'000'000;
constexpr int kRaysOfATurn = 360;
constexpr double kTurn = 2.0 * kPi;
constexpr double kTurnSeconds = 0.2;  // a turn of the laser [s]
constexpr Twist kDriven{0.5, 0.0, 1.0};

Stamp stamp_of(double seconds) {
    const auto ns = static_cast<std::uint64_t>(std::llround(seconds * 1e9));
    return {kBegin + static_cast<std::uint32_t>(ns / 1'000'000'000),
            static_cast<std::uint32_t>(ns % 1'000'000'000)};
}

/// From (0, 0) to the walls of a square room of 8 m, along a direction.
double range_at(const Pose& at, double direction) {
    const double c = std::cos(direction);
    const double s = std::sin(direction);
    const double x = c > 0.0 ? (4.0 - at.x) / c : c < 0.0 ? (-4.0 - at.x) / c : 1e9;
    const double y = s > 0.0 ? (4.0 - at.y) / s : s < 0.0 ? (-4.0 - at.y) / s : 1e9;
    return std::min(x, y);
}

/// The tour of a robot that drives in a circle; its laser turns once in kTurnSeconds and says it in
/// `parts` messages, with the time of a ray where `timed` and so many rays `more` than its part
/// has.
std::vector<Said> tour(int parts, bool timed, double sense = 1.0, int more = 0) {
    std::vector<Said> all{test::said_transforms(
        {{{kBegin, 0}, "base_link", "laser", {0.1, 0.0, 0.1}}}, Bytes::cdr(), "/tf_static")};
    const double ray_s = kTurnSeconds / kRaysOfATurn;
    for (int k = 0; k < 40; ++k) {
        const Pose at = displacement(kDriven, 0.1 * k);
        all.push_back(
            test::said_odometry(stamp_of(0.1 * k), {at.x, at.y, 0.0, 0.0, at.theta}, Bytes::cdr()));
    }
    for (int turn = 0; turn < 10; ++turn) {
        for (int part = 0; part < parts; ++part) {
            const int rays = kRaysOfATurn / parts;
            test::LaserFields laser;
            laser.stamp = stamp_of(turn * kTurnSeconds + part * rays * ray_s);
            laser.step = sense * kTurn / kRaysOfATurn;
            laser.min_angle = sense * -kPi + part * rays * laser.step;
            laser.max_range = 30.0;
            laser.ray_time = timed ? ray_s : 0.0;
            laser.ranges.clear();
            for (int i = 0; i < rays + more; ++i) {
                const double time = turn * kTurnSeconds + (part * rays + i) * ray_s;
                const Pose at = compose(displacement(kDriven, time), {0.1, 0.0, 0.0});
                laser.ranges.push_back(
                    static_cast<float>(range_at(at, at.theta + laser.min_angle + i * laser.step)));
            }
            all.push_back(test::said_laser(laser, Bytes::cdr()));
        }
    }
    return all;
}

Log read(const std::vector<Said>& all, const ReadOptions& options = ReadOptions()) {
    const test::TempDir folder;
    Procesador reader(open_log(folder.put("a.mcap", test::mcap_of(all)), kAutoFormat, options),
                      options);
    return test::read_all(reader);
}

/// How far the points lie from the walls, at the most, where the robot is known to be.
double off_the_walls(const Log& log) {
    double greatest = 0.0;
    for (const Scan& scan : log.scans) {
        const Pose at = displacement(kDriven, scan.time_s - kBegin);
        for (const Point2& point : scan.points) {
            const Point2 there = transform(at, point);
            greatest =
                std::max(greatest, std::abs(std::max(std::abs(there.x), std::abs(there.y)) - 4.0));
        }
    }
    return greatest;
}

TEST(RayTimes, RaysLieOnTheWallsWhereTheirTimesAreKnown) {
    for (const double sense : {1.0, -1.0}) {
        const Log log = read(tour(1, true, sense));
        ASSERT_EQ(log.scans.size(), 10U);
        EXPECT_LT(off_the_walls(log), 1e-3);
        EXPECT_TRUE(log.scans[3].times_s.empty());
        EXPECT_EQ(log.scans[3].points.size(), static_cast<std::size_t>(kRaysOfATurn));
        EXPECT_GT(off_the_walls(read(tour(1, false, sense))), 0.3);
        ReadOptions as_measured;
        as_measured.mend = Mend::nothing;
        EXPECT_GT(off_the_walls(read(tour(1, true, sense), as_measured)), 0.3);
        ReadOptions said;
        said.ray_time_s = sense * kTurnSeconds / kRaysOfATurn;
        if (sense > 0.0) {
            EXPECT_LT(off_the_walls(read(tour(1, false), said)), 1e-3);
        }
    }
}

TEST(RayTimes, PartsOfATurnAreJoined) {
    const Log whole = read(tour(1, true));
    for (const int parts : {2, 5, 6}) {
        for (const double sense : {1.0, -1.0}) {
            for (const bool timed : {true, false}) {
                const Log log = read(tour(parts, timed, sense));
                ASSERT_EQ(log.scans.size(), 10U) << parts;
                EXPECT_TRUE(log.scans[4].fan.closed());
                EXPECT_EQ(log.scans[4].time_s, whole.scans[4].time_s);
                // The pace of the parts tells the times of the rays where they do not.
                EXPECT_LT(off_the_walls(log), timed ? 1e-3 : 3e-3) << parts << sense;
            }
        }
    }
}

TEST(RayTimes, PartsThatOverlapOrMissARayAreJoinedToo) {
    for (const int more : {-2, -1, 1, 2}) {
        for (const double sense : {1.0, -1.0}) {
            const Log log = read(tour(6, true, sense, more));
            ASSERT_EQ(log.scans.size(), 10U) << more;
            const Scan& scan = log.scans[4];
            EXPECT_LE(scan.fan.count, 362U);
            EXPECT_NEAR(static_cast<double>(scan.points.size()), 360.0 + 6.0 * std::min(more, 0),
                        2.0);
            EXPECT_LT(off_the_walls(log), 1e-3) << more << sense;
        }
    }
}

TEST(RayTimes, PartsWithGapsBetweenThemAreJoinedWhereTheyGoRound) {
    for (const double sense : {1.0, -1.0}) {
        for (const bool timed : {true, false}) {
            const Log log = read(tour(3, timed, sense, -30));
            ASSERT_EQ(log.scans.size(), 10U) << sense;
            EXPECT_EQ(log.scans[4].points.size(), 270U);
            EXPECT_EQ(log.scans[4].fan.count, 330U);
            EXPECT_LT(off_the_walls(log), timed ? 1e-3 : 4e-3) << sense;
            EXPECT_TRUE(log.findings.empty());
        }
    }
}

TEST(RayTimes, PartsThatDoNotMeetAreTold) {
    for (const double sense : {1.0, -1.0}) {
        const Log log = read(tour(3, true, sense, -50));
        EXPECT_EQ(log.scans.size(), 30U) << sense;
        ASSERT_EQ(log.findings.size(), 1U);
        EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::parts_of_a_turn);
        EXPECT_THAT(log.findings.front().what.english(),
                    testing::AllOf(testing::HasSubstr("29 of 30 scans of /scan"),
                                   testing::HasSubstr("51 degrees apart")));
    }
    // A fan that is no turn is none of its parts.
    EXPECT_TRUE(read(tour(1, true, 1.0, -100)).findings.empty());
    EXPECT_TRUE(read(tour(1, true, 1.0, -20)).findings.empty());
    EXPECT_EQ(read(tour(1, true, 1.0, -20)).scans.size(), 10U);
}

TEST(RayTimes, SweepsLongerThanFromScanToScanAreNotBelieved) {
    std::vector<Said> all = tour(1, true);
    for (Said& said : all) {
        if (said.topic != "/scan") continue;
        test::LaserFields laser;
        laser.ray_time = 0.01;
        laser.step = kTurn / kRaysOfATurn;
        laser.ranges.assign(kRaysOfATurn, 2.0F);
        laser.stamp = {static_cast<std::uint32_t>(said.log_time_ns / 1'000'000'000),
                       static_cast<std::uint32_t>(said.log_time_ns % 1'000'000'000)};
        said.bytes = test::laser_message(laser, Bytes::cdr());
    }
    const Log log = read(all);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::ray_times);
    EXPECT_NEAR(log.findings.front().value, 3.59, 1e-3);
}

TEST(OdometryTrack, IsWhereTheReadingsAddUpTo) {
    int next = 0;
    OdometryTrack track([&]() -> std::optional<Odometria> {
        if (next > 100) return std::nullopt;
        const double time = 0.1 * next++;
        return Odometria{time, kDriven, 0};
    });
    for (const double time : {0.0, 0.05, 3.14, 2.0, 9.99, 10.5}) {
        test::expect_near(track.at(time), displacement(kDriven, time), 1e-12);
    }
    test::expect_near(track.at(30.0), displacement(kDriven, 11.0), 1e-12);
    test::expect_near(track.at(-1.0), track.at(0.0), 1e-12);
}

}  // namespace
}  // namespace hitos
