#include "hitos/simulation/simulated_tour_reader.hpp"

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
    const Log near = read_all(*SimulatedTourReader(tour, {kGreatest, false}).reopen());
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
    EXPECT_EQ(read_all(*SimulatedTourReader(tour, {100.0, false}).reopen()).scans, all.scans);
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
