// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/algoritmo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/quality.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/services/run/open_source.hpp"
#include "support.hpp"

namespace hitos {
namespace {

const std::filesystem::path kSource = HITOS_SOURCE_DIR;

Configuracion ready_tour() {
    Configuracion configuration = ArchivoConfiguracion::read(kSource / "config/thesis.cfg");
    configuration.source.file = kSource / "data/bigloop.log.gz";
    configuration.filter.particles = 20;
    return configuration;
}

TEST(Algoritmo, MapsTheReadyTour) {
    const Configuracion configuration = ready_tour();
    Algoritmo run(configuration, open_source(configuration.source));
    while (run.step()) {
    }
    EXPECT_TRUE(run.finished());
    EXPECT_FALSE(run.step());
    EXPECT_EQ(run.steps(), 1050U);
    EXPECT_EQ(run.report().duplicate_scans, 291U);
    EXPECT_EQ(run.best_trajectory().size(), 1050U);
    const auto error =
        map_error(run.filter().best_map(), read_map(kSource / "data/maps/bigloop.map"));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->landmarks, 16);
    EXPECT_EQ(error->reference_found, 16);
    EXPECT_LT(error->mean_m, 0.25);
    EXPECT_FALSE(run.step_grid().empty());
}

TEST(Algoritmo, OdometryAloneIsTheLoggedPath) {
    // The log's odometry is perfect, so its path is the true one, pose by pose.
    const Configuracion configuration = ready_tour();
    Algoritmo run(configuration, open_source(configuration.source), {.step_grid = false});
    while (run.step()) {
    }
    EXPECT_TRUE(run.step_grid().empty());
    const Trajectory& path = run.odometry_trajectory();
    // Both laps end where the first scan was taken, as NOTES of the log say: 2 s at rest at the
    // end.
    EXPECT_EQ(path.back().pose, path[path.size() - 5].pose);
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length +=
            std::hypot(path[i].pose.x - path[i - 1].pose.x, path[i].pose.y - path[i - 1].pose.y);
    }
    EXPECT_NEAR(length, 95.3, 0.3);
}

TEST(Algoritmo, RestartRepeatsTheRunBitByBit) {
    const Configuracion configuration = ready_tour();
    Algoritmo run(configuration, open_source(configuration.source));
    for (int i = 0; i < 200; ++i) run.step();
    const Trajectory first = run.best_trajectory();
    run.restart();
    EXPECT_EQ(run.steps(), 0U);
    EXPECT_TRUE(run.step_grid().empty());
    for (int i = 0; i < 200; ++i) run.step();
    EXPECT_EQ(run.best_trajectory(), first);
}

TEST(Algoritmo, ARestartBeginsToMeasureAnew) {
    const Configuracion configuration = ready_tour();
    Algoritmo run(configuration, open_source(configuration.source), {.time_stages = true});
    const auto sum = [&run] {
        return std::accumulate(run.stages().begin(), run.stages().end(), 0.0);
    };
    for (int i = 0; i < 50; ++i) run.step();
    EXPECT_GT(sum(), 0.0);
    run.restart();
    EXPECT_EQ(sum(), 0.0);
}

TEST(Algoritmo, WhereAScanIsNoKeyTheStepGridDoesNotChange) {
    Configuracion configuration =
        ArchivoConfiguracion::read(HITOS_SOURCE_DIR "/config/recorded.cfg");
    configuration.source.file = ready_tour().source.file;
    configuration.filter.particles = 2;
    Algoritmo run(configuration, open_source(configuration.source));
    std::size_t keys = 0;
    bool changed = false;
    bool still = false;
    for (int i = 0; i < 60; ++i) {
        run.step();
        const bool key = run.registration()->keys().size() > keys;
        keys = run.registration()->keys().size();
        changed = changed || (key && !run.step_grid_change().empty());
        if (key) continue;
        still = true;
        EXPECT_TRUE(run.step_grid_change().empty()) << "after scan " << i + 1;
    }
    EXPECT_TRUE(changed && still);
}

TEST(Algoritmo, NotesSegmentsAndWhereAskedUncertainty) {
    const Configuracion configuration = ready_tour();
    Algoritmo run(configuration, open_source(configuration.source),
                  {.step_grid = false, .uncertainty = true});
    for (int i = 0; i < 300; ++i) run.step();
    const LandmarkMap map = run.filter().best_map();
    const auto segments = run.line_extents().of(map, run.best_trajectory());
    EXPECT_GE(segments.size(),
              static_cast<std::size_t>(run.filter().best_count(FeatureKind::line)));
    const LandmarkSigma& last = run.uncertainty().entries().back();
    EXPECT_EQ(last.scan, 299U);
    EXPECT_EQ(last.time_s, run.scan().time_s);
    EXPECT_DOUBLE_EQ(last.sigma_1, std::sqrt(map.back().covariance(0, 0)));
    EXPECT_DOUBLE_EQ(last.sigma_2, std::sqrt(map.back().covariance(1, 1)));
    run.restart();
    EXPECT_TRUE(run.uncertainty().entries().empty());
    EXPECT_TRUE(run.line_extents().of(map, run.best_trajectory()).empty());
    // After it, scan 1 is the first noted again.
    for (int i = 0; i < 300; ++i) run.step();
    const auto again = run.line_extents().of(map, run.best_trajectory());
    ASSERT_EQ(again.size(), segments.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
        EXPECT_EQ(again[i].a, segments[i].a);
        EXPECT_EQ(again[i].points, segments[i].points);
    }
    Algoritmo silent(configuration, open_source(configuration.source), {.step_grid = false});
    for (int i = 0; i < 50; ++i) silent.step();
    EXPECT_TRUE(silent.uncertainty().entries().empty());
}

TEST(Algoritmo, GridOfTheWholePathIsTheStepGridWhereTheBestNeverChanges) {
    Configuracion configuration = ready_tour();
    configuration.filter.particles =
        1;  // one particle: the best at each step is the best at the end
    Algoritmo run(configuration, open_source(configuration.source));
    for (int i = 0; i < 300; ++i) run.step();
    const Grid grid = build_grid(configuration.grid, run.reader(), run.best_trajectory());
    EXPECT_EQ(grid.picture().grey, run.step_grid().picture().grey);
}

TEST(Algoritmo, RefusesASourceWithoutScans) {
    const test::TempFolder folder;
    Configuracion configuration;
    configuration.source.file = folder.put("odometry.log", "ODOM 1 0.1 0\nODOM 2 0.1 0\n");
    const std::string message = test::message_of<FormatError>([&] {
        Algoritmo run(configuration, open_source(configuration.source));
        while (run.step()) {
        }
    });
    EXPECT_NE(message.find("no readable scan"), std::string::npos) << message;
    EXPECT_NE(message.find("odometry.log"), std::string::npos) << message;
}

TEST(Algoritmo, TellsOfScansBeforeTheOdometry) {
    const test::TempFolder folder;
    Configuracion configuration;
    configuration.source.file =
        folder.put("late.log", "LASER 0 2 1 0 1 1\nLASER 1 2 1 0 1 1.1\nODOM 2 0.1 0\n");
    Algoritmo run(configuration, open_source(configuration.source));
    while (run.step()) {
    }
    EXPECT_EQ(run.report().early_scans, 2U);
    EXPECT_EQ(run.best_trajectory().back().pose, Pose{});
    const std::vector<Advice> told = warnings(run.evidence());
    EXPECT_TRUE(std::ranges::any_of(told, [](const Advice& advice) {
        return advice.figure == "2" && advice.text.find("source.early_scans") != advice.text.npos;
    }));
    configuration.source.read.leave_out_early_scans = true;
    const std::string message = test::message_of<FormatError>([&] {
        Algoritmo none(configuration, open_source(configuration.source));
        none.step();
    });
    EXPECT_NE(message.find("2 before it were left out"), std::string::npos) << message;
}

TEST(Algoritmo, RefusesNoFileAndImpossibleParameters) {
    Configuracion configuration;
    EXPECT_THROW(open_source(configuration.source), ConfigError);
    configuration = ready_tour();
    configuration.filter.particles = 0;
    EXPECT_THROW(Algoritmo(configuration, open_source(configuration.source)), ConfigError);
}

TEST(Algoritmo, NumbersInALogThatMakeNoSenseDoNotStopIt) {
    // Readings of 1e300 m/s and scans far away: the poses overflow, the run goes on.
    const test::TempFolder folder;
    std::string log = "ODOM 0 0 0\nODOM 1 1e300 1e300\nODOM 2 1e308 -1e300\n";
    for (int k = 0; k < 3; ++k) {
        log += "LASER " + std::to_string(k) + " 40";
        for (int i = 0; i < 40; ++i) log += " 2 " + std::to_string(0.1 * i);
        log += "\n";
    }
    Configuracion configuration;
    configuration.source.file = folder.put("wild.log", log);
    Algoritmo run(configuration, open_source(configuration.source));
    while (run.step()) {
    }
    EXPECT_EQ(run.steps(), 3U);
}

}  // namespace
}  // namespace hitos
