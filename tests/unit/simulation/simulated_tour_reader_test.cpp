// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/simulated_tour_reader.hpp"

#include <gmock/gmock.h>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/procesador.hpp"
#include "unit/capture/test_files.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::Log;
using test::read_all;
using test::small_world;
using test::TempFolder;

std::shared_ptr<const SimulatedTour> tour_of(World world) {
    return std::make_shared<const SimulatedTour>(std::move(world));
}

TEST(SimulatedTourReader, GivesWhatTheWrittenLogHolds) {
    const TempFolder folder;
    for (const double rate : {10.0, 3.0, 7.0}) {
        World world = small_world();
        world.odometry.rate_hz = rate;
        SimulatedTourReader reader(tour_of(world));
        const auto writer = make_log_writer("normalized", folder / "tour.log");
        write_tour(reader, *writer);
        writer->finish();
        reader.restart();
        const Log simulated = read_all(reader);
        EXPECT_EQ(reader.progress(), 1.0);
        const Log read = test::read_log(folder / "tour.log");
        EXPECT_EQ(simulated.odometry, read.odometry);
        ASSERT_EQ(simulated.scans.size(), read.scans.size());
        for (std::size_t i = 0; i < read.scans.size(); ++i) {
            // Text has no place for the fan and its rays; all else is the same to the last bit.
            Scan scan = simulated.scans[i];
            scan.fan = {};
            scan.rays.clear();
            EXPECT_EQ(scan, read.scans[i]);
        }
    }
}

TEST(SimulatedTourReader, KeepsFanAndRaysOfAMountedLaser) {
    World world = small_world();
    world.laser.mount_x_m = 0.2;
    world.laser.mount_heading_deg = 10.0;
    const auto tour = tour_of(world);
    const Log log = read_all(*SimulatedTourReader(tour).reopen());
    ASSERT_EQ(log.scans.size(), tour->scans());
    for (std::size_t k = 0; k < log.scans.size(); ++k) {
        Scan expected = tour->scan(k);
        expected.line = log.scans[k].line;
        EXPECT_EQ(log.scans[k], expected);
        EXPECT_EQ(log.scans[k].fan, fan_of(world.laser));
        EXPECT_EQ(log.scans[k].rays.size(), log.scans[k].points.size());
    }
}

TEST(SimulatedTourReader, BeginsAnewWithTheSameNoise) {
    SimulatedTourReader reader(tour_of(small_world()));
    for (int i = 0; i < 20; ++i) reader.next_odometry();
    reader.next_scan();
    const auto again = reader.reopen();
    EXPECT_EQ(again->format(), "world");
    EXPECT_EQ(again->progress(), 0.0);
    EXPECT_EQ(again->name(), "small.toml");
    const Log first = read_all(*again);
    reader.restart();
    // The sequences are independent: there one after the other, here in turn.
    Log in_turn;
    for (bool more = true; more;) {
        const auto reading = reader.next_odometry();
        const auto scan = reader.next_scan();
        if (reading) in_turn.odometry.push_back(*reading);
        if (scan) in_turn.scans.push_back(*scan);
        more = reading || scan;
    }
    EXPECT_EQ(in_turn.scans, first.scans);
    EXPECT_EQ(in_turn.odometry, first.odometry);
    EXPECT_EQ(reader.report().scans, first.scans.size());
    EXPECT_EQ(reader.report().odometry, first.odometry.size());
}

TEST(SimulatedTourReader, SeesNoFurtherThanAsked) {
    World world = small_world();
    world.laser.mount_x_m = 0.3;
    const auto tour = tour_of(world);
    constexpr double kGreatest = 1.5;
    const Log all = read_all(*SimulatedTourReader(tour).reopen());
    const Log near = read_all(*SimulatedTourReader(tour, {.max_range_m = kGreatest}).reopen());
    ASSERT_EQ(near.scans.size(), all.scans.size());
    std::size_t left_out = 0;
    for (std::size_t k = 0; k < all.scans.size(); ++k) {
        const Scan& whole = all.scans[k];
        const Scan& scan = near.scans[k];
        EXPECT_EQ(scan.fan.max_range_m, kGreatest);
        std::size_t next = 0;
        bool neighbour = false;  // the ray before is a point of the same run
        std::size_t runs = 0;
        for (std::size_t i = 0; i < whole.points.size(); ++i) {
            const Point2& p = whole.points[i];
            const bool starts = std::ranges::find(whole.run_starts, i) != whole.run_starts.end();
            if (std::hypot(p.x - 0.3, p.y) >= kGreatest) {
                neighbour = false;
                ++left_out;
                continue;
            }
            if (starts || !neighbour) ++runs;
            neighbour = true;
            ASSERT_LT(next, scan.points.size());
            EXPECT_EQ(scan.points[next], p);
            EXPECT_EQ(scan.rays[next], whole.rays[i]);
            ++next;
        }
        EXPECT_EQ(scan.points.size(), next);
        EXPECT_EQ(scan.run_starts.size(), runs);
    }
    EXPECT_GT(left_out, 0U);
    // A laser of 8 m sees no further because more is asked.
    EXPECT_EQ(read_all(*SimulatedTourReader(tour, {.max_range_m = 100.0}).reopen()).scans,
              all.scans);
}

TEST(SimulatedTourReader, LeavesOutWhatIsNearerThanAsked) {
    const auto tour = tour_of(small_world());
    constexpr double kLeast = 2.5;
    ReadOptions options;
    options.min_range_m = kLeast;
    const Log all = read_all(*SimulatedTourReader(tour).reopen());
    const Log far = read_all(*SimulatedTourReader(tour, options).reopen());
    ASSERT_EQ(far.scans.size(), all.scans.size());
    for (std::size_t k = 0; k < all.scans.size(); ++k) {
        EXPECT_EQ(far.scans[k].fan, all.scans[k].fan);
        std::vector<Point2> expected = all.scans[k].points;
        std::erase_if(expected, [](const Point2& p) { return std::hypot(p.x, p.y) <= kLeast; });
        EXPECT_EQ(far.scans[k].points, expected);
    }
    EXPECT_LT(far.scans.front().points.size(), all.scans.front().points.size());
}

TEST(SimulatedTourReader, ScansAreAsLateAsAsked) {
    const auto tour = tour_of(small_world());
    ReadOptions options;
    options.scan_delay_s = -0.3;
    SimulatedTourReader reader(tour, options);
    const Log log = read_all(reader);
    ASSERT_EQ(log.scans.size(), tour->scans());
    EXPECT_EQ(reader.report().early_scans, 2U) << "at 0 and 0.2 s, said to be before the odometry";
    const Trajectory truth = reader.truth()->path;
    for (std::uint64_t k = 0; k < tour->scans(); ++k) {
        EXPECT_EQ(log.scans[k].time_s, tour->scan_time(k) - 0.3);
        EXPECT_EQ(log.scans[k].points, tour->scan(k).points);
        EXPECT_EQ(truth[k].time_s, tour->scan_time(k));
        EXPECT_NEAR(log.scans[k].stamp_s(), tour->scan_time(k), 1e-12);
        EXPECT_EQ(truth[k].pose, tour->true_pose(k));
    }
    options.leave_out_early_scans = true;
    SimulatedTourReader later(tour, options);
    EXPECT_EQ(read_all(later).scans.front(), log.scans[2]);
    EXPECT_EQ(later.report().early_scans_left_out, 2U);
    EXPECT_EQ(later.progress(), 1.0);
}

TEST(SimulatedTourReader, OdometryCountsTooFarWhereAsked) {
    const auto tour = tour_of(small_world());
    const Log log = read_all(*SimulatedTourReader(tour).reopen());
    ReadOptions options;
    options.odometry_scale = 1.25;
    const Log scaled = read_all(*SimulatedTourReader(tour, options).reopen());
    EXPECT_EQ(scaled.scans, log.scans);
    ASSERT_EQ(scaled.odometry.size(), log.odometry.size());
    for (std::size_t i = 0; i < log.odometry.size(); ++i) {
        EXPECT_EQ(scaled.odometry[i].twist.v, 1.25 * log.odometry[i].twist.v);
        EXPECT_EQ(scaled.odometry[i].twist.w, log.odometry[i].twist.w);
    }
}

TEST(SimulatedTourReader, WhatIsUnsureOfADrawingIsSaidOfTheTour) {
    World world = small_world();
    EXPECT_TRUE(SimulatedTourReader(tour_of(world)).findings().empty());
    world.drawing_warnings = {verbatim("no unit"), verbatim("2 blocks")};
    const std::vector<TourFinding> found = SimulatedTourReader(tour_of(world)).findings();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(word_of(found[1].kind), "unsure-drawing");
    EXPECT_EQ(found[1].what.english(), "2 blocks");
    EXPECT_EQ(found[1].value, 2.0);
    EXPECT_FALSE(found[1].remedies.empty());
}

TEST(SimulatedTourReader, AWorldSaysItselfWhereItsLaserSits) {
    ReadOptions options;
    options.laser_pose = "0.1,0,0";
    try {
        SimulatedTourReader reader(tour_of(small_world()), options);
        FAIL() << "nothing refused it";
    } catch (const ConfigError& error) {
        EXPECT_EQ(error.key(), "source.laser_pose");
        EXPECT_THAT(error.what(), testing::HasSubstr("laser.mount_x"));
    }
}

/// Turns while it drives, with a laser that turns all round in 0.2 s.
World sweeping_world() {
    World world = small_world();
    for (const char* value :
         {"laser.sweep=on", "laser.rays=360", "laser.field_of_view=359", "laser.max_range=30",
          "laser.sigma=0", "laser.mount_x=0.2", "laser.mount_heading=20", "odometry.noise=0"}) {
        set_world_value(world, value);
    }
    return world;
}

/// How far the points lie from the walls, at the most, where the truth is at the scans' stamps.
double off_the_walls(const World& world, const Log& log, const Trajectory& truth) {
    double greatest = 0.0;
    for (std::size_t k = 0; k < log.scans.size(); ++k) {
        EXPECT_EQ(truth[k].time_s, log.scans[k].time_s);
        for (const Point2& point : log.scans[k].points) {
            const Point2 there = transform(compose(world.tour.start, truth[k].pose), point);
            double nearest = 1e9;
            for (const WallSegment& wall : world.walls)
                nearest = std::min(nearest, distance(wall, there));
            greatest = std::max(greatest, nearest);
        }
    }
    return greatest;
}

TEST(SimulatedTourReader, UnwarpsWhatASweepingLaserMeasured) {
    for (const char* value : {"laser.clockwise=false", "laser.clockwise=true", "raster.cell=0.01",
                              "laser.rate=7.3", "laser.no_return=max-range"}) {
        World world = sweeping_world();
        set_world_value(world, value);
        const auto tour = tour_of(world);
        SimulatedTourReader reader(tour);
        const Log log = read_all(reader);
        ASSERT_EQ(log.scans.size(), tour->scans());
        const double cells = 2.0 * world.raster.cell_m;
        EXPECT_LT(off_the_walls(world, log, reader.truth()->path), 1e-3 + cells) << value;
        for (std::size_t k = 0; k < log.scans.size(); ++k) {
            EXPECT_TRUE(log.scans[k].times_s.empty());
            EXPECT_EQ(log.scans[k].points.size(), 360U);
            EXPECT_EQ(log.scans[k].time_s, tour->scan_time(k));
            EXPECT_EQ(reader.truth()->path[k].pose, tour->true_pose(k));
        }
        ReadOptions as_measured;
        as_measured.mend = Mend::nothing;
        SimulatedTourReader raw(tour, as_measured);
        const Log measured = read_all(raw);
        EXPECT_GT(off_the_walls(world, measured, raw.truth()->path), 0.2) << value;
        const Scan& scan = measured.scans[20];
        ASSERT_EQ(scan.times_s.size(), scan.points.size());
        EXPECT_EQ(scan.times_s.front(), 0.0F);
        EXPECT_NEAR(scan.times_s.back(), 359.0 / 360.0 / world.laser.rate_hz, 1e-6);
    }
}

TEST(SimulatedTourReader, AWrittenLogOfASweepIsReadAsTheTour) {
    const TempFolder folder;
    const auto tour = tour_of(sweeping_world());
    ReadOptions as_measured;
    as_measured.mend = Mend::nothing;
    SimulatedTourReader raw(tour, as_measured);
    const auto writer = make_log_writer("mcap", folder / "tour.mcap");
    write_tour(raw, *writer);
    writer->finish();
    const Log read = test::read_log(folder / "tour.mcap");
    const Log mended = read_all(*SimulatedTourReader(tour).reopen());
    ASSERT_EQ(read.scans.size(), mended.scans.size());
    for (std::size_t k = 0; k < read.scans.size(); ++k) {
        ASSERT_EQ(read.scans[k].points.size(), mended.scans[k].points.size());
        for (std::size_t i = 0; i < read.scans[k].points.size(); ++i)
            test::expect_near(read.scans[k].points[i], mended.scans[k].points[i], 1e-3);
    }
}

TEST(SimulatedTourReader, ASweepOfARobotAtRestIsAScanOfOneTime) {
    World world = sweeping_world();
    set_world_value(world, "laser.sigma=0.01");
    const Scan swept = *SimulatedTourReader(tour_of(world)).next_scan();
    set_world_value(world, "laser.sweep=off");
    EXPECT_EQ(swept, *SimulatedTourReader(tour_of(world)).next_scan());
}

TEST(SimulatedTourReader, ASweepIsThereWhenAllOfItIsKnown) {
    World world = sweeping_world();
    const auto tour = SimulatedTour::live(world);
    SimulatedTourReader reader(tour);
    Log live;
    for (int period = 0; period < 60; ++period) {
        tour->drive_on(0.4, 0.5);
        while (const std::optional<Scan> scan = reader.next_scan()) live.scans.push_back(*scan);
    }
    tour->end();
    while (const std::optional<Scan> scan = reader.next_scan()) live.scans.push_back(*scan);
    const auto again = tour_of(tour->recorded());
    EXPECT_EQ(live.scans, read_all(*SimulatedTourReader(again).reopen()).scans);
    EXPECT_GT(live.scans.size(), 25U);
}

TEST(SimulatedTourReader, KnowsTheTruthInTheFrameOfTheStart) {
    World world = small_world();
    const auto tour = tour_of(world);
    const std::optional<Truth> truth = SimulatedTourReader(tour).truth();
    ASSERT_TRUE(truth);
    ASSERT_EQ(truth->path.size(), tour->scans());
    EXPECT_EQ(truth->path.front().pose, Pose{});
    for (std::uint64_t k = 0; k < tour->scans(); ++k) {
        EXPECT_EQ(truth->path[k].time_s, tour->scan_time(k));
        EXPECT_EQ(truth->path[k].pose, tour->true_pose(k));
    }
    ASSERT_EQ(truth->walls.size(), world.walls.size());
    const Pose start = world.tour.start;
    for (std::size_t i = 0; i < world.walls.size(); ++i) {
        test::expect_near(transform(start, truth->walls[i].first), world.walls[i].a, 1e-12);
        test::expect_near(transform(start, truth->walls[i].second), world.walls[i].b, 1e-12);
    }
}

}  // namespace
}  // namespace hitos
