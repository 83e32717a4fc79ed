// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/results.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/run/open_source.hpp"
#include "results/loop_json.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using nlohmann::json;
using test::content;
using test::TempFolder;
using ::testing::StartsWith;

const std::filesystem::path kResultsSource = HITOS_SOURCE_DIR;

const std::set<std::string> kAlways = {"map.txt",
                                       "segments.txt",
                                       "map.dxf",
                                       "trajectory.tum",
                                       "trajectory_online.tum",
                                       "odometry.tum",
                                       "grid_best_steps.png",
                                       "grid_best.png",
                                       "grid_odometry.png",
                                       "grid_best.jpg",
                                       "grid_best_steps.jpg",
                                       "config.cfg",
                                       "grid_odometry.jpg",
                                       "summary.json"};

class ResultsTest : public testing::Test {
  protected:
    static Algoritmo run_of(const char* algorithm, const AlgoritmoOptions& options = {},
                            double resolution_m = 0.05) {
        Configuracion configuration =
            ArchivoConfiguracion::read(kResultsSource / "config/thesis.cfg");
        configuration.source.file = kResultsSource / "data/logs/player-laser.log.gz";
        configuration.filter.algorithm = algorithm;
        configuration.filter.particles = 7;
        configuration.run.seed = 11;
        configuration.grid.resolution_m = resolution_m;
        Algoritmo run(configuration, open_source(configuration.source), options);
        while (run.step()) {
        }
        return run;
    }
    std::set<std::string> names() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(out_.path())) {
            names.insert(entry.path().filename().string());
        }
        return names;
    }
    TempFolder out_;
};

TEST_F(ResultsTest, TheSummaryStatesTheRun) {
    const Algoritmo run = run_of("fastslam");
    References references;
    references.map = run.filter().best_map();
    references.trajectory = run.best_trajectory();
    const RunSummary summary = summarize(run, references);
    const json stated = json::parse(to_json(summary, 2.0));
    EXPECT_EQ(stated["hitos_version"], version());
    EXPECT_THAT(stated["source"].get<std::string>(), ::testing::EndsWith("player-laser.log.gz"));
    EXPECT_EQ(stated["format"], "player");
    EXPECT_EQ(stated["seed"], 11);
    EXPECT_EQ(stated["algorithm"], "fastslam");
    EXPECT_EQ(stated["particles"], 7);
    EXPECT_EQ(stated["scans"], 50);
    EXPECT_NEAR(stated["duration_s"].get<double>(), 9.8, 1e-9);
    EXPECT_EQ(stated["run_seconds"], 2.0);
    EXPECT_EQ(stated["scans_per_second"], 25.0);
    EXPECT_EQ(stated["landmarks"]["lines"], run.filter().best_count(FeatureKind::line));
    EXPECT_EQ(stated["landmarks"]["corners"], run.filter().best_count(FeatureKind::corner));
    EXPECT_EQ(stated["log"]["odometry_readings"], 99);
    EXPECT_EQ(stated["log"]["skipped_lines"], 0);
    // The run measured by itself.
    ASSERT_FALSE(references.map->empty());
    EXPECT_EQ(stated["map_error"]["mean_m"], 0.0);
    EXPECT_EQ(stated["map_error"]["landmarks"], references.map->size());
    EXPECT_EQ(stated["map_error"]["reference_found"], references.map->size());
    EXPECT_EQ(stated["map_error_aligned"]["mean_m"], 0.0);
    EXPECT_NEAR(stated["trajectory_error"]["ate_rmse_m"].get<double>(), 0.0, 1e-12);
    EXPECT_EQ(stated["trajectory_error"]["poses"], 50);
    EXPECT_GT(stated["odometry_error"]["ate_rmse_m"].get<double>(), 1e-6);
    // What the robot had while driving is another path.
    const TrajectoryError online =
        trajectory_error(run.online_trajectory(), *references.trajectory).value();
    EXPECT_GT(online.rmse_m, 1e-6);
    EXPECT_EQ(stated["online_error"]["ate_rmse_m"], online.rmse_m);
    EXPECT_FALSE(stated.contains("distances"));
}

TEST_F(ResultsTest, TheTimesNameEveryFileThatWasWritten) {
    const Algoritmo run = run_of("fastslam", {.time_stages = true});
    const RunSummary summary = write_results(run, {}, 1.0, out_.path());
    ASSERT_TRUE(summary.times);
    std::set<std::string> timed;
    for (const auto& file : summary.times->files) timed.insert(file.name);
    for (const char* file : {"map.txt", "trajectory.tum", "grid_best.png", "map.dxf"})
        EXPECT_TRUE(timed.contains(file)) << file;
    EXPECT_FALSE(timed.contains("map.svg"));
}

TEST_F(ResultsTest, LoopsAreReadAsTheyWereStated) {
    Trajectory path(8);
    RunLoop closed;
    closed.record.scan = 7;
    closed.record.earlier = 1;
    closed.record.verdict = LoopVerdict::closed;
    closed.record.move_m = 0.25;
    RunLoop strained = closed;
    strained.record.scan = 5;
    strained.record.verdict = LoopVerdict::strained;
    strained.record.chi_square = 40.0;
    strained.record.move_m = 0.0;
    const std::vector<RunLoop> loops{strained, closed};
    const json quality{{"loops", json_of(loops, true)}, {"refused_loops", json_of(loops, false)}};
    const std::vector<RunLoop> read = read_loops(quality, path, "summary.json");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].record.verdict, LoopVerdict::strained);
    EXPECT_EQ(read[0].record.chi_square, 40.0);
    EXPECT_EQ(read[1].record.verdict, LoopVerdict::closed);
    EXPECT_EQ(read[1].record.move_m, 0.25);
}

TEST_F(ResultsTest, AGridsJpgHasNoMorePixelsThanOneLooksAt) {
    const auto pixels = [&](const char* name) {
        const Grid::Picture picture = read_grey_picture(out_ / name);
        return std::int64_t{picture.width} * picture.height;
    };
    write_results(run_of("fastslam"), {}, 1.0, out_.path());
    EXPECT_EQ(pixels("grid_best.jpg"), pixels("grid_best.png"));
    write_results(run_of("fastslam", {}, 0.002), {}, 1.0, out_.path());
    EXPECT_GT(pixels("grid_best.png"), 16'000'000);
    EXPECT_LE(pixels("grid_best.jpg"), 16'000'000);
    EXPECT_GT(pixels("grid_best.jpg"), 2'000'000);
}

TEST_F(ResultsTest, TheFiguresOfARunStandWhereTheirEntriesSay) {
    const Algoritmo run = run_of("fastslam");
    References references;
    references.map = {{Recta{1.0, 0.5}, {}, 0}, {Esquina{1.0, 1.0}, {}, 0}};
    references.trajectory = run.odometry_trajectory();
    const RunSummary summary = summarize(run, references);
    const json stated = json::parse(to_json(summary, 2.0));
    for (const Measure* measure : taken_measures()) {
        const std::optional<double>& figure = summary.figures[*measure];
        if (measure->place.empty()) continue;
        const json::json_pointer place(measure->place);
        EXPECT_EQ(stated.contains(place), figure.has_value()) << measure->word;
        if (figure) {
            EXPECT_EQ(stated.at(place), *figure) << measure->word;
        }
    }
    EXPECT_EQ(summary.figures["blur_m2"], std::nullopt) << "nobody has drawn a grid";
    EXPECT_EQ(summary.figures["lines"], run.filter().best_count(FeatureKind::line));
    EXPECT_GT(summary.figures["error_m"], summary.figures["aligned_error_m"]);
    EXPECT_GT(summary.figures["trajectory_error_m"], 1e-6);
    EXPECT_NEAR(summary.figures["odometry_error_m"].value(), 0.0, 1e-12);
}

TEST_F(ResultsTest, WhatIsNotThereIsNotStated) {
    const json stated = json::parse(to_json(summarize(run_of("ekf-slam"), {}), 0.0));
    EXPECT_EQ(stated["algorithm"], "ekf-slam");
    EXPECT_EQ(stated["scans_per_second"], 0.0);
    for (const char* key : {"particles", "map_error", "map_error_aligned", "trajectory_error",
                            "odometry_error", "distances"}) {
        EXPECT_FALSE(stated.contains(key)) << key;
    }
}

TEST_F(ResultsTest, FilesOfAnEarlierRunThatThisOneHasNotAreRemoved) {
    const Algoritmo run = run_of("fastslam");
    for (const char* name : {"distances.csv", "paths.png", "paths.gp", "odometry_scans.png",
                             "odometry_scans.gp", "grid_particle_3.png", "uncertainty.csv",
                             "uncertainty.png", "uncertainty.dat", "uncertainty.gp"}) {
        out_.put(name, "old");
    }
    out_.put("map.txt", "old");
    out_.put("summary.json", "{}");  // of a version that listed no files
    out_.put("notes.txt", "mine");
    write_results(run, {}, 1.0, out_.path());
    std::set<std::string> expected = kAlways;
    expected.insert("notes.txt");
    EXPECT_EQ(names(), expected);
    // What a summary with a list does not name is somebody's, whatever its name.
    out_.put("distances.csv", "mine");
    expected.insert("distances.csv");
    const RunSummary summary = write_results(run, {}, 1.0, out_.path());
    EXPECT_EQ(names(), expected);
    EXPECT_NE(content(out_ / "map.txt"), "old");
    EXPECT_TRUE(summary.not_written.empty());
    const std::string text = to_json(summary, 1.0);
    EXPECT_TRUE(content(out_ / "summary.json").starts_with(text.substr(0, text.size() - 3)));
}

TEST_F(ResultsTest, TheGridOfAParticleIsThatOfItsOwnPath) {
    const Algoritmo run = run_of("fastslam", {.step_grid = true, .grid_of = 3});
    out_.put("grid_particle_5.png", "old");
    out_.put("summary.json", R"({"files": [{"name": "grid_particle_5.png", "bytes": 3,)"
                             R"("xxh3_128": ""}]})");
    write_results(run, {}, 1.0, out_.path());
    std::set<std::string> expected = kAlways;
    expected.insert({"grid_particle_3.png", "grid_particle_3.jpg"});
    EXPECT_EQ(names(), expected);
    const std::vector<WeightedPose> hypotheses = run.filter().hypotheses();
    for (std::size_t i = 0; i < hypotheses.size(); ++i) {
        const Trajectory path = run.trajectory_of(i);
        ASSERT_EQ(path.size(), run.steps());
        EXPECT_EQ(path.back().pose, hypotheses[i].pose);
    }
}

TEST_F(ResultsTest, WallsAndScansByOdometryAreDrawnWhereWallsAreKnown) {
    const Algoritmo run = run_of("fastslam");
    References references;
    references.walls = {{{0.0, -1.0}, {5.0, -1.0}}};
    const RunSummary summary = write_results(run, references, 1.0, out_.path());
    EXPECT_TRUE(names().contains("odometry_scans.gp"));
    EXPECT_NE(summary.not_written.empty(), !names().contains("odometry_scans.png"));
    const std::string script = content(out_ / "odometry_scans.gp");
    EXPECT_NE(script.find("0.0000 -1.0000\n5.0000 -1.0000\n"), std::string::npos);
    // The first point that the first scan puts there, whose pose by odometry is known.
    const auto reader = run.reader().reopen();
    const Point2 first =
        transform(run.odometry_trajectory().front().pose, reader->next_scan()->points.front());
    EXPECT_NE(script.find(fmt::format("$points << EOD\n{:.4f} {:.4f}\n", first.x, first.y)),
              std::string::npos);
}

TEST_F(ResultsTest, WhatWasAskedForIsWrittenAndWhatCouldNotBeDrawnIsTold) {
    const Algoritmo run = run_of("fastslam", {.step_grid = true, .uncertainty = true});
    References references;
    references.trajectory = Trajectory{StampedPose{1e6, {}}};  // of another time
    references.distances = {{"room", {-1.0, 0.0}, {19.0, 0.0}}};
    out_.put("paths.png", "old");
    out_.put("summary.json", "{}");
    const RunSummary summary = write_results(run, references, 1.0, out_.path());
    ASSERT_FALSE(summary.not_written.empty());
    EXPECT_THAT(summary.not_written.front().reason.english(),
                StartsWith("no pose of the reference trajectory"));
    EXPECT_FALSE(names().contains("paths.png"));
    for (const char* name : {"distances.csv", "uncertainty.csv", "uncertainty.gp"}) {
        EXPECT_TRUE(names().contains(name)) << name;
    }
    EXPECT_EQ(json::parse(content(out_ / "summary.json"))["distances"][0]["name"], "room");
}

TEST_F(ResultsTest, ALogsNameMayBeOfAnyBytes) {
    const TempFolder logs;
    Configuracion configuration = run_of("fastslam").configuration();
    const auto log = logs / "n\xff\xfe.log.gz";
    std::filesystem::copy_file(configuration.source.file, log);
    configuration.source.file = log.string();
    Algoritmo run(configuration, open_source(configuration.source));
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(run.step());
    write_results(run, {}, 1.0, out_.path());
    EXPECT_THAT(content(out_ / "config.cfg"), ::testing::HasSubstr("n\xef\xbf\xbd"));
    EXPECT_EQ(read_results(out_.path()).scans, 5U);
}

TEST_F(ResultsTest, AnOutputFolderIsTriedBeforeTheRun) {
    prepare_output_folder(out_ / "a/b");
    EXPECT_TRUE(std::filesystem::is_empty(out_ / "a/b"));
    out_.put("file", "x");
    EXPECT_THAT(test::message_of<FileError>([&] { prepare_output_folder(out_ / "file"); }),
                ::testing::HasSubstr("--out"));
}

}  // namespace
}  // namespace hitos
