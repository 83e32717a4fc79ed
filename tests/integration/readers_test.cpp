// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a tour comes through, a log of any format, a world or noise on either, nothing is lost.
#include <gtest/gtest.h>

#include "hitos/capture/log_format.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/recorded_tour.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/simulation/drive/noisy_reader.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "unit/capture/test_files.hpp"
#include "unit/simulation/worlds.hpp"

namespace hitos {
namespace {

using test::Log;
using test::read_all;

/// Looks at ranges from the laser, rays, and covariances seen from it.
Configuracion demanding() {
    Configuracion configuration;
    configuration.extraction.method = "ransac";
    configuration.extraction.covariance = ObservationCovariance::points;
    configuration.extraction.lines.min_points = 8;
    configuration.filter.particles = 10;
    configuration.run.threads = 1;
    return configuration;
}

struct Result {
    std::string map;
    std::string path;
    std::vector<std::uint8_t> grid;
    friend bool operator==(const Result&, const Result&) = default;
};

Result result_of(const Configuracion& configuration, std::unique_ptr<TourReader> reader) {
    Algoritmo run(configuration, std::move(reader));
    while (run.step()) {
    }
    return {map_to_text(run.filter().best_map()), trajectory_to_text(run.best_trajectory()),
            run.step_grid().picture().grey};
}

World mounted_world() {
    World world = test::small_world();
    world.laser.mount_x_m = 0.25;
    world.laser.mount_y_m = 0.1;
    return world;
}

/// A tour by a mounted laser, as a log of each format and as the world itself.
class EveryReader : public ::testing::TestWithParam<std::string> {
  protected:
    std::unique_ptr<TourReader> open(const ReadOptions& options = {}) const {
        if (GetParam() == "world") {
            return std::make_unique<SimulatedTourReader>(tour_, options);
        }
        SourceParams source{(folder_ / "tour.log").string(), GetParam(), options};
        if (!std::filesystem::exists(source.file)) {
            SimulatedTourReader reader(tour_);
            const auto writer = make_log_writer(GetParam(), source.file);
            write_tour(reader, *writer);
            writer->finish();
        }
        return open_tour(source);
    }
    static std::unique_ptr<TourReader> with_noise(std::unique_ptr<TourReader> reader,
                                                  double level) {
        return make_noisy_reader(std::move(reader), level, OdometryNoiseKind::relative_sigma, 1);
    }

    test::TempFolder folder_;
    std::shared_ptr<const SimulatedTour> tour_ =
        std::make_shared<const SimulatedTour>(mounted_world());
};

TEST_P(EveryReader, WithoutNoiseIsItself) {
    const Log plain = read_all(*open());
    const Log noisy = read_all(*with_noise(open(), 0.0));
    ASSERT_GT(plain.scans.size(), 50U);
    EXPECT_EQ(noisy.scans, plain.scans);
    EXPECT_EQ(noisy.odometry, plain.odometry);
    const Configuracion configuration = demanding();
    const Result result = result_of(configuration, open());
    EXPECT_FALSE(result.map.empty());
    EXPECT_TRUE(result_of(configuration, with_noise(open(), 0.0)) == result);
}

TEST_P(EveryReader, KeepsItsScansUnderNoise) {
    const Log plain = read_all(*open());
    const Log noisy = read_all(*with_noise(open(), 0.2));
    EXPECT_EQ(noisy.scans, plain.scans);
    ASSERT_EQ(noisy.odometry.size(), plain.odometry.size());
    EXPECT_NE(noisy.odometry, plain.odometry);
    for (std::size_t i = 0; i < plain.odometry.size(); ++i) {
        EXPECT_EQ(noisy.odometry[i].time_s, plain.odometry[i].time_s);
        EXPECT_EQ(noisy.odometry[i].line, plain.odometry[i].line);
    }
}

TEST_P(EveryReader, ObeysTheGreatestRangeWithAndWithoutNoise) {
    const auto farthest = [](const Log& log) {
        double range = 0.0;
        for (const Scan& scan : log.scans) {
            const Pose& laser = scan.fan.pose_robot_laser;
            for (const Point2& p : scan.points) {
                range = std::max(range, std::hypot(p.x - laser.x, p.y - laser.y));
            }
        }
        return range;
    };
    constexpr double kGreatest = 2.5;
    const ReadOptions near{kGreatest};
    EXPECT_GT(farthest(read_all(*open())), 5.0);
    const Log plain = read_all(*open(near));
    EXPECT_LT(farthest(plain), kGreatest);
    EXPECT_GT(farthest(plain), kGreatest - 0.1);
    EXPECT_EQ(read_all(*with_noise(open(near), 0.1)).scans, plain.scans);
}

TEST_P(EveryReader, CanBeRecordedAndReadAgain) {
    const auto reader = open();
    const Log plain = read_all(*reader);
    RecordedReader recorded(record_tour(*reader, [](std::size_t) { return true; }));
    for (int round = 0; round < 2; ++round) {
        const Log log = read_all(recorded);
        EXPECT_EQ(log.scans, plain.scans);
        EXPECT_EQ(log.odometry, plain.odometry);
        EXPECT_EQ(recorded.progress(), 1.0);
        recorded.restart();
    }
    EXPECT_EQ(read_all(*recorded.reopen()).scans, plain.scans);
}

INSTANTIATE_TEST_SUITE_P(Tours, EveryReader,
                         ::testing::Values("player", "radish", "normalized", "carmen", "world"),
                         [](const auto& value) { return value.param; });

// A limit above the one that the log states keeps readings beyond it, under noise too.
TEST(ReadOptions, AGreaterLimitThanTheLogsKeepsMore) {
    const test::TempFolder folder;
    const auto log =
        folder.put("a.log",
                   "PARAM robot_front_laser_max 5.0 1 h 1\nODOM 0 0 0 0 0 0 1 h 1\n"
                   "FLASER 4 1.0 2.0 6.0 7.0 0 0 0 0 0 0 1 h 1\nODOM 1 0 0 0 0 0 2 h 2\n");
    const auto points = [&](double greatest, double noise) {
        SourceParams source{log.string(), "auto", {greatest}};
        return make_noisy_reader(open_tour(source), noise, OdometryNoiseKind::variance, 1)
            ->next_scan()
            ->points.size();
    };
    for (const double noise : {0.0, 0.1}) {
        EXPECT_EQ(points(0.0, noise), 2U);
        EXPECT_EQ(points(6.5, noise), 3U);
        EXPECT_EQ(points(10.0, noise), 4U);
    }
}

}  // namespace
}  // namespace hitos
