// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of whole runs: a tour that is moved, mirrored, slowed down, written anew, or cut and joined
// gives the same map.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/recorded_tour.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using Tour = std::shared_ptr<const RecordedTour>;

Tour tour_of(const TourReader& reader) {
    return record_tour(reader, [](std::size_t /*bytes*/) { return true; });
}

/// What a run says of its tour.
struct MappedTour {
    LandmarkMap map;
    Trajectory path;
};

MappedTour mapped_tour(const Configuracion& configuration, std::unique_ptr<TourReader> reader) {
    Algoritmo run(configuration, std::move(reader), {.step_grid = false});
    while (run.step()) {
    }
    return {run.filter().best_map(), run.best_trajectory()};
}

/// Landmarks and paths are no further apart than `tolerance` [m, rad]. Every landmark was seen as
/// often but for some `sightings`, and first and last in the same scans: every observation went
/// to the same one.
void expect_same(const MappedTour& found, const MappedTour& expected, double tolerance,
                 int sightings = 0) {
    ASSERT_EQ(found.map.size(), expected.map.size());
    ASSERT_GE(expected.map.size(), 4U);
    for (std::size_t i = 0; i < found.map.size(); ++i) {
        const ICaracteristica& a = found.map[i];
        const ICaracteristica& b = expected.map[i];
        ASSERT_EQ(a.kind(), b.kind()) << i;
        EXPECT_LE(std::abs(static_cast<int>(a.observations) - static_cast<int>(b.observations)),
                  sightings)
            << i;
        EXPECT_EQ(a.first_seen, b.first_seen) << i;
        EXPECT_EQ(a.last_seen, b.last_seen) << i;
        if (const auto* recta = std::get_if<Recta>(&a.value)) {
            const LineDifference apart = difference(*recta, std::get<Recta>(b.value));
            EXPECT_LE(apart.rho, tolerance) << i;
            EXPECT_LE(apart.theta, tolerance) << i;
        } else {
            EXPECT_LE(distance(a.point(), b.point()), tolerance) << i;
        }
    }
    ASSERT_EQ(found.path.size(), expected.path.size());
    for (std::size_t i = 0; i < found.path.size(); ++i) {
        const Pose& a = found.path[i].pose;
        const Pose& b = expected.path[i].pose;
        ASSERT_LE(std::hypot(a.x - b.x, a.y - b.y), tolerance) << i;
        ASSERT_LE(std::abs(wrap_angle(a.theta - b.theta)), tolerance) << i;
    }
}

/// The same to the last bit, covariances and all.
void expect_same_bits(const MappedTour& found, const MappedTour& expected) {
    expect_same(found, expected, 0.0);
    for (std::size_t i = 0; i < found.map.size(); ++i) {
        EXPECT_EQ(found.map[i].value, expected.map[i].value) << i;
        EXPECT_EQ(found.map[i].covariance, expected.map[i].covariance) << i;
        EXPECT_EQ(found.map[i].from_m, expected.map[i].from_m) << i;
        EXPECT_EQ(found.map[i].to_m, expected.map[i].to_m) << i;
    }
    for (std::size_t i = 0; i < found.path.size(); ++i)
        EXPECT_EQ(found.path[i].pose, expected.path[i].pose) << i;
}

/// Seen in a mirror that lies along the first heading.
MappedTour mirror_of(MappedTour seen) {
    for (ICaracteristica& landmark : seen.map) {
        if (auto* recta = std::get_if<Recta>(&landmark.value)) recta->theta = -recta->theta;
        if (auto* corner = std::get_if<Esquina>(&landmark.value)) corner->y = -corner->y;
    }
    for (StampedPose& stamped : seen.path)
        stamped.pose = {stamped.pose.x, -stamped.pose.y, -stamped.pose.theta};
    return seen;
}

/// The world somewhere else, its start with it.
World stood_at(World world, const Pose& pose) {
    for (WallSegment& wall : world.walls) {
        wall.a = transform(pose, wall.a);
        wall.b = transform(pose, wall.b);
    }
    for (WayPoint& point : world.tour.way_points) point.at = transform(pose, point.at);
    world.tour.start = compose(pose, world.tour.start);
    return world;
}

/// All of it takes so many times as long.
Tour slower(RecordedTour tour, double factor) {
    for (Scan& scan : tour.scans.items) scan.time_s *= factor;
    for (Odometria& reading : tour.odometry.items) {
        reading.time_s *= factor;
        reading.twist.v /= factor;
        reading.twist.v_lateral /= factor;
        reading.twist.w /= factor;
    }
    return std::make_shared<const RecordedTour>(std::move(tour));
}

std::filesystem::path written(const Tour& tour, std::string_view format,
                              const std::filesystem::path& path) {
    RecordedReader reader(tour);
    const std::unique_ptr<LogWriter> writer = make_log_writer(format, path);
    write_tour(reader, *writer);
    writer->finish();
    return path;
}

struct LawCase {
    const char* world;
    const char* preset;
    const char* algorithm;
    // Two solutions of the same equations are as near each other as their last step was short.
    double solver = 1e-9;
    // A key scan at the limit of what makes a line or corner of it.
    int sightings = 0;
};

/// One lap through a world, with the noise of laser and odometry.
class TourLaws : public testing::TestWithParam<LawCase> {
  protected:
    TourLaws() {
        const std::filesystem::path root = HITOS_SOURCE_DIR;
        const auto& [world, preset, algorithm, solver, sightings] = GetParam();
        configuration_ =
            ArchivoConfiguracion::read(root / "config" / (std::string(preset) + ".cfg"));
        configuration_.filter.algorithm = algorithm;
        configuration_.filter.particles = 20;
        configuration_.source.file = (root / "data/worlds" / (std::string(world) + ".toml"));
        configuration_.source.world_set = "tour.laps=1 tour.rest=1";
        tour_ = tour_of(*open_tour(configuration_));
        expected_ = run(tour_);
    }

    /// Particles deviate from the odometry at random, which no mirror does: here they do not.
    void leave_nothing_to_chance() {
        if (configuration_.filter.algorithm != "fastslam") return;
        MotionParams& motion = configuration_.filter.motion;
        motion = {};
        motion.sigma_x_m = motion.sigma_y_m = motion.sigma_theta_rad = 0.0;
    }
    MappedTour run(const Tour& tour) const {
        return mapped_tour(configuration_, std::make_unique<RecordedReader>(tour));
    }
    /// Of a log that is read by these options.
    MappedTour run(const std::filesystem::path& log, const ReadOptions& read = {}) const {
        SourceParams source;
        source.file = log.string();
        source.read = read;
        return mapped_tour(configuration_, open_tour(source));
    }

    Configuracion configuration_;
    Tour tour_;
    MappedTour expected_;
};

TEST_P(TourLaws, AWorldThatStandsElsewhereGivesTheSameMap) {
    const World world = open_world(configuration_.source);
    for (const Pose& pose : {Pose{30.0, -20.0, 0.0}, Pose{-5.0, 8.0, 2.0}}) {
        SCOPED_TRACE(pose.theta);
        const SimulatedTourReader reader(
            std::make_shared<const SimulatedTour>(stood_at(world, pose)));
        expect_same(run(tour_of(reader)), expected_, 1e-6);
    }
}

TEST_P(TourLaws, TheFrameOfTheOdometryDoesNotMatter) {
    const test::TempFolder folder;
    const Pose frame{100.0, -70.0, 2.5};
    const std::filesystem::path log = written(tour_, "carmen", folder / "tour.log");
    std::istringstream lines(test::content(log));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream stream(line);
        std::vector<std::string> words;
        for (std::string word; stream >> word;) words.push_back(word);
        std::vector<std::size_t> poses;
        if (words[0] == "ODOM") poses = {1};
        if (words[0] == "FLASER") poses = {words.size() - 9, words.size() - 6};
        for (const std::size_t at : poses) {
            const Pose there = compose(
                frame, {std::stod(words[at]), std::stod(words[at + 1]), std::stod(words[at + 2])});
            words[at] = fmt::format("{}", there.x);
            words[at + 1] = fmt::format("{}", there.y);
            words[at + 2] = fmt::format("{}", there.theta);
        }
        text += fmt::format("{}\n", fmt::join(words, " "));
    }
    expect_same(run(folder.put("turned.log", text)), run(log), 1e-6);
}

TEST_P(TourLaws, AMirroredTourGivesTheMirroredMap) {
    leave_nothing_to_chance();
    RecordedTour tour = *tour_;
    for (Scan& scan : tour.scans.items) {
        for (Point2& point : scan.points) point.y = -point.y;
        scan.fan.min_angle_rad = -scan.fan.min_angle_rad;
        scan.fan.max_angle_rad = -scan.fan.max_angle_rad;
    }
    for (Odometria& reading : tour.odometry.items) {
        reading.twist.w = -reading.twist.w;
        reading.twist.v_lateral = -reading.twist.v_lateral;
    }
    expect_same(run(std::make_shared<const RecordedTour>(std::move(tour))), mirror_of(run(tour_)),
                GetParam().solver);
}

TEST_P(TourLaws, AnUpsideDownLaserAndTurnsToTheRightAreAMirror) {
    leave_nothing_to_chance();
    const test::TempFolder folder;
    const std::filesystem::path log = written(tour_, "carmen", folder / "tour.log");
    ReadOptions read;
    read.laser_pose = "0,0,0,upside-down";
    read.odometry_turns = -1.0;
    expect_same(run(log, read), mirror_of(run(log)), GetParam().solver);
}

TEST_P(TourLaws, TimeDoesNotMatter) {
    expect_same_bits(run(slower(*tour_, 2.0)), expected_);
    expect_same(run(slower(*tour_, 3.0)), expected_, 1e-9);
    const MappedTour found = run(slower(*tour_, 2.0));
    for (std::size_t i = 0; i < found.path.size(); ++i)
        ASSERT_EQ(found.path[i].time_s, 2.0 * expected_.path[i].time_s);
}

TEST_P(TourLaws, EveryFormatGivesTheSameMap) {
    const test::TempFolder folder;
    expect_same_bits(run(written(tour_, "normalized", folder / "normalized.log")), expected_);
    // Digits that a format leaves out decide which particles go on.
    leave_nothing_to_chance();
    const MappedTour expected = run(tour_);
    for (const std::string format : {"mcap", "player", "radish", "carmen"}) {
        SCOPED_TRACE(format);
        expect_same(run(written(tour_, format, folder / ("tour." + format))), expected, 0.01,
                    GetParam().sightings);
    }
}

/// Reads a tour as it lies there.
Tour read_tour(const std::filesystem::path& log, const ReadOptions& options = {}) {
    SourceParams source;
    source.file = log.string();
    source.read = options;
    return tour_of(*open_tour(source));
}

void expect_same_readings(const Tour& found, const Tour& expected) {
    const auto& scans = expected->scans.items;
    const auto& odometry = expected->odometry.items;
    EXPECT_FALSE(scans.empty());
    ASSERT_EQ(found->scans.items.size(), scans.size());
    for (std::size_t i = 0; i < scans.size(); ++i) {
        ASSERT_EQ(found->scans.items[i].time_s, scans[i].time_s) << i;
        ASSERT_EQ(found->scans.items[i].points, scans[i].points) << i;
        ASSERT_EQ(found->scans.items[i].run_starts, scans[i].run_starts) << i;
    }
    ASSERT_EQ(found->odometry.items.size(), odometry.size());
    for (std::size_t i = 0; i < odometry.size(); ++i) {
        ASSERT_EQ(found->odometry.items[i].time_s, odometry[i].time_s) << i;
        ASSERT_EQ(found->odometry.items[i].twist, odometry[i].twist) << i;
    }
}

class JoinedTours : public testing::Test {
  protected:
    JoinedTours() {
        SourceParams source;
        source.file = std::string(HITOS_SOURCE_DIR) + "/data/worlds/recinto.toml";
        source.world_set = "tour.laps=1 tour.rest=1";
        tour_ = tour_of(*open_tour(source));
    }
    test::TempDir folder_;
    Tour tour_;
};

TEST_F(JoinedTours, ALogCutAnywhereAndJoinedIsTheLog) {
    for (const std::string format : {"normalized", "player", "radish", "carmen"}) {
        SCOPED_TRACE(format);
        const std::filesystem::path log = written(tour_, format, folder_ / (format + ".log"));
        const std::string text = test::content(log);
        for (const std::size_t at : {text.size() / 2, text.find('\n', text.size() / 3) + 1}) {
            const auto first = folder_.put_gz("first.gz", text.substr(0, at));
            const auto second = folder_.put_gz("second.gz", text.substr(at));
            const auto joined = folder_.put(format + "-joined.log.gz",
                                            test::content(first) + test::content(second));
            expect_same_readings(read_tour(joined), read_tour(log));
        }
    }
}

TEST_F(JoinedTours, TwoRecordingsInOneFolderAreOneTour) {
    RecordedTour first = *tour_;
    RecordedTour second = *tour_;
    const double cut_s = first.scans.items[first.scans.items.size() / 2].time_s;
    const auto later = [cut_s](const auto& item) { return item.time_s >= cut_s; };
    std::erase_if(first.scans.items, later);
    std::erase_if(first.odometry.items, later);
    std::erase_if(second.scans.items, std::not_fn(later));
    std::erase_if(second.odometry.items, std::not_fn(later));
    const std::filesystem::path parts = folder_ / "parts";
    std::filesystem::create_directory(parts);
    written(std::make_shared<const RecordedTour>(first), "mcap", parts / "tour_0.mcap");
    written(std::make_shared<const RecordedTour>(second), "mcap", parts / "tour_1.mcap");
    // Each part's poses begin at its own start; its velocities are those of the whole.
    ReadOptions velocities;
    velocities.odometry = OdometryFrom::velocities;
    expect_same_readings(read_tour(parts, velocities),
                         read_tour(written(tour_, "mcap", folder_ / "tour.mcap"), velocities));
}

INSTANTIATE_TEST_SUITE_P(Runs, TourLaws,
                         testing::Values(LawCase{"recinto", "simulated", "fastslam"},
                                         LawCase{"bigloop", "ekf", "ekf-slam"},
                                         LawCase{"recinto", "recorded", "fastslam"},
                                         LawCase{"recinto", "recorded", "graph-slam", 1e-6, 1}),
                         [](const auto& test) {
                             std::string name = std::string(test.param.world) + "_" +
                                                test.param.preset + "_" + test.param.algorithm;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace hitos
