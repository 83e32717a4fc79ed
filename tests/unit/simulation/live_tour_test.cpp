// SPDX-License-Identifier: GPL-3.0-or-later
// Tours that are driven by hand, and what happens to them on the way.
#include <thread>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "unit/capture/test_files.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::Log;
using test::read_all;
using test::small_world;

Disturbance event(DisturbanceKind kind, std::array<double, 3> values, double at_s = 0.0) {
    return {kind, at_s, values, 0};
}

World with_door() {
    World world = small_world();
    world.doors.push_back({{4, -2}, {4, 4}, 1, 0});
    world.odometry.rate_hz = 7.0;  // not that of the scans
    world.walkers.push_back({{{3, -1}, {3, 3}}, 0.8, 0.25, 0});
    return world;
}

/// Drives so and lets everything happen that can.
void drive_about(SimulatedTour& tour) {
    const auto drive = [&](double v, double w, int periods) {
        for (int k = 0; k < periods; ++k) tour.drive_on(v, w);
    };
    drive(0.0, 0.0, 3);
    drive(0.5, 0.1, 20);
    tour.disturb(event(DisturbanceKind::odometry_noise, {0.4}));
    tour.disturb(event(DisturbanceKind::laser_sigma, {0.1}));
    drive(0.3, -0.4, 13);
    tour.disturb(event(DisturbanceKind::push, {0.3, -0.2, 30.0}));
    tour.disturb(event(DisturbanceKind::slip, {1.0, 0.5, 0.0}));
    drive(0.4, 0.3, 25);
    tour.disturb(event(DisturbanceKind::open, {1.0}));
    tour.disturb(event(DisturbanceKind::box, {1.0, 3.0, 0.4}));
    tour.disturb(event(DisturbanceKind::blind, {0.7}));
    drive(0.5, 0.0, 60);
    tour.disturb(event(DisturbanceKind::close, {1.0}));
    drive(-0.2, 0.1, 10);
}

TEST(LiveTour, RecordedIsTheSameTourToTheLastBit) {
    const auto live = SimulatedTour::live(with_door());
    drive_about(*live);
    live->end();
    const auto again = std::make_shared<const SimulatedTour>(live->recorded());
    EXPECT_EQ(again->path().poses(), live->path().poses());
    SimulatedTourReader first(live);
    SimulatedTourReader second(again);
    const Log was = read_all(first);
    const Log is = read_all(second);
    ASSERT_GT(was.scans.size(), 50U);
    EXPECT_EQ(was.scans, is.scans);
    EXPECT_EQ(was.odometry, is.odometry);
    EXPECT_EQ(first.truth()->path, second.truth()->path);
}

TEST(LiveTour, ReadWhileItIsDrivenIsTheSameTour) {
    const auto live = SimulatedTour::live(with_door());
    SimulatedTourReader reader(live);
    EXPECT_FALSE(reader.next_scan().has_value());
    Log met;
    std::thread driver([&] { drive_about(*live); });
    const auto take = [&] {
        while (auto scan = reader.next_scan()) met.scans.push_back(std::move(*scan));
        while (auto reading = reader.next_odometry()) met.odometry.push_back(*reading);
    };
    for (int i = 0; i < 200; ++i) take();
    driver.join();
    EXPECT_EQ(reader.progress(), std::nullopt);
    live->end();
    take();
    EXPECT_EQ(reader.progress(), 1.0);
    const Log whole = read_all(*reader.reopen());
    EXPECT_EQ(met.scans, whole.scans);
    EXPECT_EQ(met.odometry, whole.odometry);
}

TEST(LiveTour, WallsAndDoorsStopTheRobotAndItMayLeave) {
    const auto live = SimulatedTour::live(with_door());
    for (int k = 0; k < 200; ++k) live->drive_on(0.5, 0.0);
    EXPECT_NEAR(live->pose_now().x, 4.0 - 0.26, 0.05);  // at the door
    EXPECT_LE(live->pose_now().x, 4.0 - 0.26);
    EXPECT_EQ(live->twist_now(), Twist{});
    live->disturb(event(DisturbanceKind::open, {1.0}));
    for (int k = 0; k < 200; ++k) live->drive_on(0.5, 0.0);
    EXPECT_NEAR(live->pose_now().x, 8.0 - 0.26, 0.05);  // at the wall
    for (int k = 0; k < 20; ++k) live->drive_on(-0.5, 0.0);
    EXPECT_LT(live->pose_now().x, 7.5);
    // What is put on top of it does not hold it.
    live->disturb(event(DisturbanceKind::box, {live->pose_now().x + 0.3, 0.0, 0.2}));
    const double before = live->pose_now().x;
    for (int k = 0; k < 20; ++k) live->drive_on(-0.5, 0.0);
    EXPECT_LT(live->pose_now().x, before - 0.3);
}

TEST(LiveTour, WheelsDoNotNoticeAPushAndCountWhatSlips) {
    World world = small_world();
    world.odometry.noise = 0.0;
    const auto live = SimulatedTour::live(world);
    for (int k = 0; k < 10; ++k) live->drive_on(0.0, 0.0);
    live->disturb(event(DisturbanceKind::push, {1.0, 0.5, 90.0}));
    EXPECT_NEAR(live->pose_now().x, 1.0, 1e-12);
    EXPECT_NEAR(live->pose_now().theta, kPi / 2, 1e-12);
    for (int k = 0; k < 10; ++k) live->drive_on(0.0, 0.0);
    for (std::uint64_t k = 0; k < live->readings(); ++k) {
        EXPECT_EQ(live->true_reading(k).twist, Twist{});
    }
    // The left wheel loses all its way: the robot turns about it while odometry goes straight on.
    live->disturb(event(DisturbanceKind::slip, {100.0, 1.0, 0.0}));
    const Pose from = live->pose_now();
    for (int k = 0; k < 5; ++k) live->drive_on(0.1, 0.0);
    const Pose moved = between(from, live->pose_now());
    const double half = 0.5 * world.robot.track_m;
    EXPECT_NEAR(std::hypot(moved.x - 0.0, moved.y - half), half, 1e-9);
    EXPECT_GT(moved.theta, 0.0);
    live->end();
    EXPECT_EQ(live->true_reading(live->readings() - 1).twist.w, 0.0);
}

TEST(LiveTour, ABlindLaserGivesEmptyScansAndNoiseIsThatOfItsTime) {
    World world = small_world();
    world.laser.sigma_m = 0.0;
    const auto live = SimulatedTour::live(world);
    const auto rest = [&](int periods) {
        for (int k = 0; k < periods; ++k) live->drive_on(0.0, 0.0);
    };
    rest(10);
    live->disturb(event(DisturbanceKind::blind, {1.0}));
    rest(20);
    live->disturb(event(DisturbanceKind::laser_sigma, {0.05}));
    rest(10);
    live->end();
    const Scan clear = live->scan(0);
    for (std::uint64_t k = 0; k < live->scans(); ++k) {
        const double time_s = live->scan_time(k);
        const Scan scan = live->scan(k);
        EXPECT_EQ(scan.points.empty(), time_s >= 1.0 && time_s < 2.0 - 1e-9) << time_s;
        if (time_s < 1.0) {
            EXPECT_EQ(scan.points, clear.points);
        }
        if (time_s >= 3.0) {
            EXPECT_NE(scan.points, clear.points);
        }
    }
}

TEST(LiveTour, SomebodyWhoWalksIsSeenWhereHeIs) {
    World world = small_world();
    world.laser.sigma_m = 0.0;
    world.laser.max_range_m = 20.0;
    world.walkers.push_back({{{2, -1}, {2, 1}}, 1.0, 0.25, 0});
    const auto live = SimulatedTour::live(world);
    for (int k = 0; k < 60; ++k) live->drive_on(0.0, 0.0);
    live->end();
    // Half the way to and fro takes a second: ahead of the robot after one, three, five seconds.
    for (const double time_s : {1.0, 3.0, 5.0}) {
        const Scan scan = live->scan(static_cast<std::uint64_t>(time_s * world.laser.rate_hz));
        const auto ahead = std::ranges::find(scan.rays, 90U);
        ASSERT_NE(ahead, scan.rays.end());
        EXPECT_NEAR(scan.points[static_cast<std::size_t>(ahead - scan.rays.begin())].x, 1.75, 1e-9);
    }
    const Scan gone = live->scan(0);  // at an end of the way
    EXPECT_NEAR(gone.points[90].x, 8.0, 1e-9);
}

TEST(LiveTour, RefusesWhatCannotHappen) {
    const auto live = SimulatedTour::live(with_door());
    EXPECT_THROW(live->disturb(event(DisturbanceKind::open, {2.0})), ConfigError);
    EXPECT_THROW(live->disturb(event(DisturbanceKind::open, {1.5})), ConfigError);
    EXPECT_THROW(live->disturb(event(DisturbanceKind::slip, {1.0, 2.0, 0.0})), ConfigError);
    EXPECT_THROW(live->disturb(event(DisturbanceKind::blind, {std::nan("")})), ConfigError);
    EXPECT_THROW(live->drive_on(5.0, 0.0), ConfigError);
    EXPECT_THROW(live->drive_on(0.0, std::nan("")), ConfigError);
    EXPECT_NO_THROW(SimulatedTour(live->recorded()));
}

TEST(LiveTour, AWorldFileTellsIt) {
    const std::string text =
        "walls = [[[-2, -2], [8, -2], [8, 4], [-2, 4], [-2, -2]]]\n"
        "doors = [[[4, -2], [4, 4]]]\n"
        "people = [{ way = [[3, -1], [3, 3]], speed = 0.5 }]\n"
        "[tour]\nrest = 0\n"
        "commands = [[0.5, 0.1, 2.0], [0.3, -0.4, 1.3]]\n"
        "events = [{ at = 2.0, push = [0.3, -0.2, 30] }, { at = 2.5, open = 1 },\n"
        "          { at = 1, slip = [1, 0.5, 0] }, { at = 3, blind = 0.2 }]\n"
        "[robot]\ntrack = 0.4\n";
    const World world = parse_world(text, "room.toml");
    ASSERT_EQ(world.doors.size(), 1U);
    ASSERT_EQ(world.walkers.size(), 1U);
    EXPECT_EQ(world.walkers[0].speed, 0.5);
    ASSERT_EQ(world.tour.commands.size(), 2U);
    EXPECT_EQ(world.tour.commands[1].w, -0.4);
    ASSERT_EQ(world.tour.events.size(), 4U);
    EXPECT_EQ(world.tour.events[0].values[2], 30.0);
    EXPECT_EQ(SimulatedTour(world).path().twists().size(), 33U);

    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        other.replace(other.find(from), from.size(), to);
        try {
            parse_world(other, "room.toml");
        } catch (const FormatError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const auto expect = [&](const char* from, const char* to, const char* told) {
        EXPECT_NE(changed(from, to).find(told), std::string::npos) << changed(from, to);
    };
    expect("open = 1", "open = 2", "room.toml:7: open: found door 2");
    expect("push = [0.3", "shove = [0.3", "room.toml:7: tour.events: found shove, expected one of");
    expect("[0.3, -0.2, 30]", "[0.3, 30]", "room.toml:7: push: expected [ahead, left, turn]");
    expect("[0.5, 0.1, 2.0]", "[5, 0.1, 2.0]", "room.toml:6: found the speed 5 m/s, expected -0.5");
    expect("[0.5, 0.1, 2.0]", "[0.5, 2.0]", "room.toml:6: tour.commands: expected");
    expect("[3, -1], [3, 3]", "[3, -1]", "room.toml:3: walker 1: expected two points");
    expect("speed = 0.5", "pace = 0.5", "room.toml:3: walker 1: pace: expected");
    expect("[[[4, -2], [4, 4]]]", "[[[4, -2]]]", "room.toml:2: door 1");
    expect("rest = 0", "rest = 0\nway_points = [[1, 1]]", "way_points and commands");
}

TEST(LiveTour, WayPointsAreDrivenThroughWhatHappens) {
    World world = small_world();
    world.tour.events = {event(DisturbanceKind::slip, {3.0, 0.4, 0.0}, 2.0),
                         event(DisturbanceKind::push, {0.2, 0.0, 10.0}, 6.0)};
    const SimulatedTour tour(world);  // the driver sees where the robot is, and gets there
    const Pose end = tour.path().poses().back();
    EXPECT_LT(std::hypot(end.x - 5.0, end.y - 0.0), 0.2);
    std::swap(world.tour.events[0], world.tour.events[1]);  // in whatever order they stand
    EXPECT_EQ(SimulatedTour(world).path().poses(), tour.path().poses());
    world.doors.push_back({{3, -2}, {3, 4}, 1, 0});
    EXPECT_THROW(SimulatedTour{world}, FormatError);  // closed
}

}  // namespace
}  // namespace hitos
