// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/simulated_tour.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::content;
using test::small_world;
using test::TempFolder;

std::filesystem::path write(const World& world, std::string_view format,
                            const std::filesystem::path& path) {
    SimulatedTourReader reader(std::make_shared<const SimulatedTour>(world));
    const auto writer = make_log_writer(format, path);
    write_tour(reader, *writer);
    writer->finish();
    return path;
}

TEST(SimulatedTour, TakesReadingsAndScansAtTheirRates) {
    const SimulatedTour tour(small_world());
    const double end = tour.path().duration_s();
    EXPECT_EQ(tour.scans(), static_cast<std::uint64_t>(std::floor(end * 5 + 1e-9)) + 1);
    EXPECT_EQ(tour.readings(), static_cast<std::uint64_t>(std::floor(end * 10 + 1e-9)) + 1);
    EXPECT_EQ(tour.true_pose(0), Pose{});
    EXPECT_EQ(tour.scan(7).time_s, 1.4);
    EXPECT_EQ(tour.true_reading(0).twist, Twist{});
}

World world_with_landmarks() {
    World world = small_world();
    // Two ahead, the second one on the wall; one behind the robot, one behind the wall, one too
    // far.
    world.landmarks.at = {{3.0, 1.0}, {8.0, 0.0}, {-1.0, 0.0}, {8.5, 1.0}, {6.0, 3.0}};
    world.landmarks.sigma_range_m = world.landmarks.sigma_bearing_deg = 0.0;
    world.laser.max_range_m = 8.2;
    world.tour.events = {{DisturbanceKind::box, 0.0, {5.0, 2.5, 0.2}}};
    return world;
}

TEST(SimulatedTour, KnowsTheFirstScanThatIsNotBeforeATime) {
    const World world = test::small_world();
    const SimulatedTour tour(world);
    for (std::uint64_t scan = 0; scan < 50; ++scan) {
        const double at_s = static_cast<double>(scan) / world.laser.rate_hz;
        EXPECT_EQ(tour.scan_from(at_s), scan);
        EXPECT_EQ(tour.scan_from(at_s + 1e-3), scan + 1);
    }
    EXPECT_EQ(tour.scan_from(-1.0), 0U);
}

TEST(SimulatedTour, LandmarksAreSeenWhereNoWallHidesThem) {
    World world = world_with_landmarks();
    const Scan scan = SimulatedTour(world).scan(0);
    EXPECT_TRUE(scan.points.empty());
    ASSERT_EQ(scan.landmarks.size(), 2U);
    EXPECT_EQ(scan.landmarks[0], (LandmarkSighting{std::sqrt(10.0), std::atan2(1.0, 3.0), 0}));
    EXPECT_EQ(scan.landmarks[1], (LandmarkSighting{8.0, 0.0, 1}));
    world.landmarks.identities = false;
    EXPECT_EQ(SimulatedTour(world).scan(0).landmarks[1].identity, LandmarkSighting::kNameless);
    world.laser.mount_heading_deg = 180.0;
    world.laser.mount_x_m = 0.5;
    const Scan behind = SimulatedTour(world).scan(0);
    ASSERT_EQ(behind.landmarks.size(), 1U);
    EXPECT_NEAR(behind.landmarks[0].range_m, 1.0, 1e-12);  // of the robot, not of the sensor
    EXPECT_NEAR(std::abs(behind.landmarks[0].bearing_rad), kPi, 1e-12);
}

TEST(SimulatedTour, LandmarksAreMeasuredWithTheirNoise) {
    World world = world_with_landmarks();
    world.landmarks.at = {{3.0, 1.0}};
    world.landmarks.sigma_range_m = 0.1;
    world.landmarks.sigma_bearing_deg = 2.0;
    world.tour.rest_s = 400.0;
    const SimulatedTour tour(world);
    double range = 0.0;
    double bearing = 0.0;
    constexpr std::uint64_t kScans = 2000;
    for (std::uint64_t k = 0; k < kScans; ++k) {
        const LandmarkSighting seen = tour.scan(k).landmarks.at(0);
        range += std::pow(seen.range_m - std::sqrt(10.0), 2) / kScans;
        bearing += std::pow(seen.bearing_rad - std::atan2(1.0, 3.0), 2) / kScans;
    }
    EXPECT_NEAR(std::sqrt(range), 0.1, 0.006);
    EXPECT_NEAR(std::sqrt(bearing) / kRadiansPerDegree, 2.0, 0.12);
    EXPECT_EQ(tour.scan(7), tour.scan(7));
}

TEST(SimulatedTour, StartsAtTheOriginOfItsFrameWhereverTheRobotStarts) {
    World world = small_world();
    world.tour.start = {1.0, 1.0, 0.5};
    const SimulatedTour tour(world);
    EXPECT_EQ(tour.true_pose(0), Pose{});
    const Pose last = compose(world.tour.start, tour.true_pose(tour.scans() - 1));
    EXPECT_NEAR(std::hypot(last.x - 5.0, last.y), 0.0, world.robot.tolerance_m);
}

TEST(SimulatedTour, OdometryWithoutNoiseIsTheTrueMotionAtAnyRate) {
    for (const double rate : {10.0, 5.0, 3.0, 40.0}) {
        World world = small_world();
        world.odometry.rate_hz = rate;
        const SimulatedTour tour(world);
        Pose pose = world.tour.start;
        for (std::uint64_t k = 1; k < tour.readings(); ++k) {
            pose = compose(pose, displacement(tour.true_reading(k).twist, 1.0 / rate));
            const Pose truth = tour.path().pose_at(tour.reading_time(k));
            ASSERT_NEAR(pose.x, truth.x, 1e-9) << rate << " " << k;
            ASSERT_NEAR(pose.y, truth.y, 1e-9);
            ASSERT_NEAR(wrap_angle(pose.theta - truth.theta), 0.0, 1e-9);
        }
    }
}

TEST(SimulatedTour, RaysWithoutAWallCanGivePointsAtTheGreatestRange) {
    World world = small_world();
    world.laser.max_range_m = 5.0;
    world.laser.sigma_m = 0.0;
    const Scan gaps = SimulatedTour(world).scan(0);
    set_world_value(world, "laser.no_return=max-range");
    const Scan full = SimulatedTour(world).scan(0);
    ASSERT_LT(gaps.points.size(), full.points.size());
    ASSERT_EQ(full.points.size(), full.fan.count) << "every ray is a point";
    EXPECT_EQ(full.run_starts, std::vector<std::uint32_t>{0}) << "and none ends a run";
    for (const Point2& p : full.points) EXPECT_LE(std::hypot(p.x, p.y), 5.0 + 1e-9);
    for (std::size_t i = 0; i < gaps.points.size(); ++i) {
        EXPECT_EQ(full.points[gaps.rays[i]], gaps.points[i]) << "the walls are seen as before";
    }
}

TEST(SimulatedTour, RangesBetweenTracedRaysAreInterpolatedAsInStage2) {
    World world = small_world();
    world.walls.push_back({{1.0, -0.3}, {1.0, 0.3}});  // ranges jump at its ends
    world.laser.max_range_m = 4.0;
    world.laser.sigma_m = 0.0;
    for (const int rays : {181, 180, 3}) {
        world.laser.rays = rays;
        const auto ranges_of = [&](int skip) {
            world.laser.sample_skip = skip;
            const Scan scan = SimulatedTour(world).scan(0);
            std::vector<double> ranges(scan.fan.count, 4.0);
            for (std::size_t i = 0; i < scan.points.size(); ++i) {
                ranges[scan.rays[i]] = std::hypot(scan.points[i].x, scan.points[i].y);
            }
            return ranges;
        };
        const std::vector<double> all = ranges_of(1);
        const std::vector<double> some = ranges_of(4);
        int between = 0;
        for (std::size_t ray = 0; ray < all.size(); ++ray) {
            const std::size_t from = ray / 4 * 4;
            const std::size_t to = std::min(from + 4, all.size() - 1);
            const double part =
                to == from ? 0.0 : static_cast<double>(ray - from) / static_cast<double>(to - from);
            const double expected = all[from] + part * (all[to] - all[from]);
            EXPECT_NEAR(some[ray], expected, 1e-12) << rays << " rays, ray " << ray;
            between += std::abs(some[ray] - all[ray]) > 0.1 ? 1 : 0;
        }
        EXPECT_GT(between, 0) << "it draws a line across a jump";
    }
    // A ray measured later is interpolated as well, and a point at the greatest range stays one.
    for (const char* also : {"laser.sweep=on", "laser.no_return=max-range"}) {
        World other = world;
        other.laser.rays = 181;
        set_world_value(other, also);
        other.laser.sample_skip = 1;
        const Scan all = SimulatedTour(other).scan(20);  // it drives
        other.laser.sample_skip = 4;
        const Scan some = SimulatedTour(other).scan(20);
        for (std::size_t i = 0; i < all.points.size(); ++i) {
            const auto same = std::ranges::find(some.rays, all.rays[i]);
            if (all.rays[i] % 4 != 0) continue;
            ASSERT_NE(same, some.rays.end()) << also << ", ray " << all.rays[i];
            EXPECT_EQ(some.points[static_cast<std::size_t>(same - some.rays.begin())],
                      all.points[i]);
        }
        const bool every = other.laser.no_return == NoReturn::max_range;
        EXPECT_EQ(every, some.points.size() == 181) << also;
        EXPECT_NE(some.points, all.points) << also;
    }
    // Noise does not make points of rays that have no wall on either side.
    world.laser.rays = 181;
    world.laser.max_range_m = 0.5;
    world.laser.sigma_m = 0.3;
    world.laser.sample_skip = 4;
    EXPECT_TRUE(SimulatedTour(world).scan(0).points.empty());
}

TEST(SimulatedTour, RangesHaveTheNoiseThatWasAskedFor) {
    World world = small_world();
    world.tour.rest_s = 200.0;
    world.tour.way_points.resize(1);
    world.laser.sigma_m = 0.02;
    const SimulatedTour tour(world);
    const SimulatedLaser laser(world.walls, fan_of(world.laser));
    std::vector<RayHit> hits;
    double sum = 0.0;
    double squares = 0.0;
    double neighbours = 0.0;
    int n = 0;
    for (std::uint64_t k = 0; k < tour.scans() && n < 100'000; ++k) {
        laser.cast(tour.path().pose_at(tour.scan_time(k)), hits);
        const Scan scan = tour.scan(k);
        double before = 0.0;
        for (std::size_t i = 0; i < scan.points.size(); ++i) {
            // Rays near the greatest range lose the readings beyond it.
            const double truth = hits[scan.rays[i]].range_m;
            if (truth > 7.8) continue;
            const double error = std::hypot(scan.points[i].x, scan.points[i].y) - truth;
            sum += error;
            squares += error * error;
            neighbours += error * before;
            before = error;
            ++n;
        }
    }
    ASSERT_GE(n, 100'000);
    const double sigma = world.laser.sigma_m;
    EXPECT_NEAR(sum / n, 0.0, 5.0 * sigma / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(squares / n), sigma, 5.0 * sigma / std::sqrt(2.0 * n));
    EXPECT_NEAR(neighbours / n / (sigma * sigma), 0.0, 5.0 / std::sqrt(n));
}

TEST(SimulatedTour, ARunOfNeighboursEndsWhereARayReturnsNothing) {
    World world = small_world();
    world.laser.max_range_m = 5.0;
    world.laser.sigma_m = 0.0;
    const Scan scan = SimulatedTour(world).scan(0);
    // Facing +x from the origin: the walls above and below are near, the one ahead is 8 m away.
    ASSERT_EQ(scan.run_starts.size(), 2U);
    const std::uint32_t second = scan.run_starts[1];
    EXPECT_GT(scan.rays[second], scan.rays[second - 1] + 1);
    EXPECT_EQ(scan.rays.front(), 0U);
    EXPECT_EQ(scan.rays.back(), 180U);
}

TEST(SimulatedTour, PointsLieOnTheWallsWhateverTheMounting) {
    World world = small_world();
    world.laser.sigma_m = 0.0;
    world.laser.mount_x_m = 0.2;
    world.laser.mount_y_m = -0.1;
    world.laser.mount_heading_deg = 30.0;
    const SimulatedTour tour(world);
    for (std::uint64_t k = 0; k < tour.scans(); k += 9) {
        const Pose pose = tour.path().pose_at(tour.scan_time(k));
        const Scan scan = tour.scan(k);
        EXPECT_EQ(scan.fan.pose_robot_laser.x, 0.2);
        for (const Point2& point : scan.points) {
            const Point2 at = transform(pose, point);
            double gap = 1.0;
            for (const WallSegment& wall : world.walls) gap = std::min(gap, distance(wall, at));
            ASSERT_LT(gap, 1e-9);
        }
    }
}

TEST(SimulatedTour, TheSameSeedWritesTheSameBytesInEveryFormat) {
    const TempFolder folder;
    for (const char* format : {"player", "radish", "normalized", "carmen"}) {
        World world = small_world();
        const std::string first = content(write(world, format, folder / "a.log"));
        EXPECT_EQ(first, content(write(world, format, folder / "b.log")));
        world.seed = 2;
        EXPECT_NE(first, content(write(world, format, folder / "c.log")));
    }
}

TEST(SimulatedTour, EveryFormatReadsBackAsTheSameTour) {
    const TempFolder folder;
    World world = small_world();
    world.laser.mount_x_m = 0.1;
    const SimulatedTour tour(world);
    for (const char* format : {"player", "radish", "normalized", "carmen"}) {
        SCOPED_TRACE(format);
        Procesador reader(open_log(write(world, format, folder / "tour.log")));
        EXPECT_EQ(reader.format(), format);
        for (std::uint64_t k = 0; k < tour.scans(); ++k) {
            const auto scan = reader.next_scan();
            ASSERT_TRUE(scan) << k;
            const Scan expected = tour.scan(k);
            ASSERT_EQ(scan->points.size(), expected.points.size());
            ASSERT_EQ(scan->run_starts, expected.run_starts);
            for (std::size_t i = 0; i < scan->points.size(); ++i) {
                ASSERT_NEAR(scan->points[i].x, expected.points[i].x, 1e-4);
                ASSERT_NEAR(scan->points[i].y, expected.points[i].y, 1e-4);
            }
        }
        EXPECT_FALSE(reader.next_scan());
    }
}

TEST(SimulatedTour, AnUnwritableLogLeavesNothingBehind) {
    const TempFolder folder;
    EXPECT_THROW(write(small_world(), "player", folder / "missing/tour.log"), FileError);
    {
        const auto writer = make_log_writer("normalized", folder / "tour.log");
        SimulatedTourReader reader(std::make_shared<const SimulatedTour>(small_world()));
        write_tour(reader, *writer);
    }
    EXPECT_EQ(folder.files(), 0U);
}

}  // namespace
}  // namespace hitos
