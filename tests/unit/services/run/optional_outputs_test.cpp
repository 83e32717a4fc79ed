// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/optional_outputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "hitos/base/error.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/results/results_check.hpp"
#include "hitos/services/run/open_source.hpp"
#include "results/corrected_tour.hpp"
#include "results/run_graph.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::message_of;
using test::TempFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::filesystem::path kOutputsSource = HITOS_SOURCE_DIR;

TEST(ChosenOutputs, AreNamedByWordOrFile) {
    EXPECT_THAT(chosen_outputs("", "--write"), IsEmpty());
    EXPECT_THAT(chosen_outputs(" map.pgm , svg,map.yaml,", "--write"),
                ElementsAre("map-server", "svg"));
    EXPECT_EQ(chosen_outputs("g2o,all", "--write").size(), optional_outputs().size());
}

TEST(ChosenOutputs, WhatNoneHasIsRefusedWithTheNearest) {
    EXPECT_THAT(message_of<ConfigError>([] { chosen_outputs("svg,map.yml", "--write"); }),
                HasSubstr("--write: found \"map.yml\", which is no file of a run that can be asked "
                          "for; did you mean map."));
    EXPECT_THAT(message_of<ConfigError>([] { chosen_outputs("everything", "--write"); }),
                HasSubstr("there are all, svg, pdf, map-server"));
}

TEST(ChosenOutputs, WordsAndFilesAreNobodyElses) {
    std::set<std::string> names;
    for (const OptionalOutput& output : optional_outputs()) {
        EXPECT_TRUE(names.insert(output.word).second) << output.word;
        for (const std::string& file : output.files) {
            EXPECT_TRUE(names.insert(file).second) << file;
            EXPECT_TRUE(is_results_file(file)) << file;
        }
        EXPECT_FALSE(output.purpose.empty());
    }
}

class OptionalOutputsTest : public testing::Test {
  protected:
    static Algoritmo run_of(const std::string& log, const char* algorithm, int steps, int threads) {
        Configuracion configuration =
            ArchivoConfiguracion::read(kOutputsSource / "config/thesis.cfg");
        configuration.source.file = kOutputsSource / "data" / log;
        configuration.filter.algorithm = algorithm;
        configuration.filter.particles = 7;
        configuration.run.threads = threads;
        Algoritmo run(configuration, open_source(configuration.source));
        for (int i = 0; i < steps && run.step(); ++i) {
        }
        return run;
    }
    std::map<std::string, std::string> written(const Algoritmo& run) const {
        const TempFolder folder;
        StagedFolder staged = results_folder(folder.path());
        const std::vector<std::string> all = chosen_outputs("all", "");
        const RunSummary summary = write_results(run, {}, 1.0, staged, {}, nullptr, all);
        EXPECT_THAT(summary.not_written, IsEmpty());
        EXPECT_TRUE(check_results(folder.path()).whole());
        std::map<std::string, std::string> files;
        for (const OptionalOutput& output : optional_outputs()) {
            for (const std::string& file : output.files) {
                files[file] = content(folder / file);
                EXPECT_FALSE(files[file].empty()) << file;
            }
        }
        return files;
    }
    TempFolder out_;
};

TEST_F(OptionalOutputsTest, AreTheSameWithAnyNumberOfThreads) {
    const auto one = written(run_of("bigloop.log.gz", "fastslam", 60, 1));
    EXPECT_EQ(one, written(run_of("bigloop.log.gz", "fastslam", 60, 3)));
}

TEST_F(OptionalOutputsTest, ThoseOfAnEarlierRunGo) {
    const Algoritmo run = run_of("bigloop.log.gz", "fastslam", 20, 1);
    for (const std::string list : {"svg,carmen", "pdf"}) {
        StagedFolder staged = results_folder(out_.path());
        write_results(run, {}, 1.0, staged, {}, nullptr, chosen_outputs(list, ""));
    }
    EXPECT_TRUE(std::filesystem::exists(out_ / "map.pdf"));
    EXPECT_FALSE(std::filesystem::exists(out_ / "map.svg"));
    EXPECT_FALSE(std::filesystem::exists(out_ / "corrected.log"));
}

TEST_F(OptionalOutputsTest, GraphsOfEveryAlgorithmJoinEveryLandmark) {
    for (const char* algorithm : {"fastslam", "ekf-slam", "graph-slam"}) {
        const Algoritmo run = run_of("bigloop.log.gz", algorithm, 200, 1);
        const PlanarGraph graph = graph_of(run);
        ASSERT_EQ(graph.count(PlanarVertex::Kind::pose), 200U) << algorithm;
        ASSERT_GT(graph.vertices.size(), 200U) << algorithm;
        EXPECT_EQ(std::ranges::count(graph.vertices, true, &PlanarVertex::fixed), 1) << algorithm;
        EXPECT_TRUE(graph.vertices.front().fixed) << algorithm;
        std::set<std::size_t> seen;
        for (const PlanarEdge& edge : graph.edges) {
            if (edge.kind != PlanarEdge::Kind::step) seen.insert(edge.to);
        }
        EXPECT_EQ(seen.size(), graph.vertices.size() - 200U) << algorithm;
        // Dead reckoning by the steps alone is the odometry.
        Pose pose = run.odometry_trajectory().front().pose;
        for (std::size_t i = 0; i < 199; ++i) {
            ASSERT_EQ(graph.edges[i].to, i + 1) << algorithm;
            const Eigen::Vector3d& z = graph.edges[i].z;
            pose = compose(pose, {z(0), z(1), z(2)});
        }
        const Pose& odometry = run.odometry_trajectory().back().pose;
        EXPECT_NEAR(pose.x, odometry.x, 1e-9) << algorithm;
        EXPECT_NEAR(pose.y, odometry.y, 1e-9) << algorithm;
        EXPECT_EQ(graph.count(PlanarEdge::Kind::step) > 199U, run.registration() != nullptr)
            << algorithm;
    }
}

TEST_F(OptionalOutputsTest, LinesSeenFromBehindHaveTheLandmarksNormal) {
    const Algoritmo run = run_of("bigloop.log.gz", "fastslam", 1050, 1);
    const PlanarGraph graph = graph_of(run);
    int turned = 0;
    for (const PlanarEdge& edge : graph.edges) {
        if (edge.kind != PlanarEdge::Kind::line) continue;
        const Recta z{edge.z(1), edge.z(0)};
        const Recta line{graph.vertices[edge.to].at(1), graph.vertices[edge.to].at(0)};
        const Pose pose = graph.vertices[edge.from].pose();
        EXPECT_LT(std::abs(wrap_angle(z.theta + pose.theta - line.theta)), 0.3);
        EXPECT_NEAR(z.rho, -signed_distance(line, {pose.x, pose.y}), 0.6);
        if (z.rho < 0.0) ++turned;
    }
    EXPECT_GT(turned, 100) << "the robot drives round walls and sees lines from both their sides";
}

/// All that is read of a log.
struct Read {
    std::vector<Scan> scans;
    Trajectory odometry;
};

Read read(const std::filesystem::path& log) {
    SourceParams source;
    source.file = log;
    const auto reader = open_source(source);
    ControlTrack track([&reader] { return reader->next_odometry(); });
    OdometryPath path;
    std::vector<Control> controls;
    Read all;
    while (auto scan = reader->next_scan()) {
        track.controls_until(*scan, controls);
        path.add(scan->time_s, controls);
        all.scans.push_back(std::move(*scan));
    }
    all.odometry = path.trajectory();
    return all;
}

void expect_same_scans(const Read& a, const Read& b) {
    ASSERT_EQ(a.scans.size(), b.scans.size());
    for (std::size_t i = 0; i < a.scans.size(); ++i) {
        ASSERT_EQ(a.scans[i].points.size(), b.scans[i].points.size()) << i;
        for (std::size_t j = 0; j < a.scans[i].points.size(); ++j) {
            EXPECT_NEAR(a.scans[i].points[j].x, b.scans[i].points[j].x, 2e-4);
            EXPECT_NEAR(a.scans[i].points[j].y, b.scans[i].points[j].y, 2e-4);
        }
    }
}

void expect_same_path(const Trajectory& a, const Trajectory& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Pose one = between(a.front().pose, a[i].pose);
        const Pose other = between(b.front().pose, b[i].pose);
        EXPECT_NEAR(one.x, other.x, 1e-4) << i;
        EXPECT_NEAR(one.y, other.y, 1e-4) << i;
        EXPECT_NEAR(wrap_angle(one.theta - other.theta), 0.0, 1e-4) << i;
    }
}

TEST_F(OptionalOutputsTest, ACorrectedLogIsTheSameTour) {
    const Algoritmo run = run_of("logs/carmen-flaser.log.gz", "fastslam", 1000, 1);
    write_corrected_tour(run, run.best_trajectory(), out_ / "c.log");
    EXPECT_THAT(content(out_ / "c.log"), HasSubstr("\nFLASER "));
    const Read before = read(kOutputsSource / "data/logs/carmen-flaser.log.gz");
    const Read after = read(out_ / "c.log");
    expect_same_scans(before, after);
    expect_same_path(before.odometry, after.odometry);
}

TEST_F(OptionalOutputsTest, ALaserThatFlaserCannotSayHasTheCorrectedPathForOdometry) {
    const Algoritmo run = run_of("logs/carmen-robotlaser.log.gz", "fastslam", 1000, 1);
    Trajectory path = run.best_trajectory();
    for (StampedPose& stamped : path) stamped.pose = compose({1.0, 2.0, 0.5}, stamped.pose);
    path.back().pose.x += 0.5;
    write_corrected_tour(run, path, out_ / "c.log");
    EXPECT_THAT(content(out_ / "c.log"), Not(HasSubstr("\nODOM ")));
    const Read after = read(out_ / "c.log");
    expect_same_scans(read(kOutputsSource / "data/logs/carmen-robotlaser.log.gz"), after);
    expect_same_path(path, after.odometry);
}

TEST_F(OptionalOutputsTest, OfAStoppedRunItHasTheScansSoFar) {
    const Algoritmo run = run_of("logs/carmen-flaser.log.gz", "fastslam", 12, 1);
    write_corrected_tour(run, run.best_trajectory(), out_ / "c.log");
    EXPECT_EQ(read(out_ / "c.log").scans.size(), 12U);
}

}  // namespace
}  // namespace hitos
