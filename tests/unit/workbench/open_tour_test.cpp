// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/open_tour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

const std::filesystem::path kSourceDir = HITOS_SOURCE_DIR;

TEST(OpenTour, SimulatesAWorldAndReadsALog) {
    SourceParams source;
    source.file = (kSourceDir / "data/worlds/recinto.toml").string();
    const auto world = open_tour(source);
    EXPECT_EQ(world->format(), "world");
    EXPECT_EQ(world->name(), source.file);
    source.file = (kSourceDir / "data/bigloop.log.gz").string();
    EXPECT_EQ(open_tour(source)->format(), "player");
}

TEST(OpenTour, RefusesAWorldInAnotherFormat) {
    SourceParams source;
    source.file = (kSourceDir / "data/worlds/recinto.toml").string();
    source.format = "normalized";
    EXPECT_NO_THROW(open_tour(source));  // as older configurations say
    source.format = "carmen";
    EXPECT_THROW(open_tour(source), ConfigError);
    source.file = "missing.TOML";
    source.format = kAutoFormat;
    EXPECT_THROW(open_tour(source), FileError);
}

TEST(OpenTour, OdometryOfAWorldIsMadeOfItsScansWhereAsked) {
    SourceParams source;
    source.file = (kSourceDir / "data/worlds/bigloop.toml").string();
    source.world_set = "laser.field_of_view=360 laser.max_range=30 odometry.noise=0.5";
    source.read.odometry = OdometryFrom::scans;
    const auto reader = open_tour(source, 1);
    const std::optional<Truth> truth = reader->truth();
    ASSERT_TRUE(truth);
    Pose pose;
    double time_s = 0.0;
    for (std::size_t i = 0; i < 50; ++i) {
        const std::optional<Odometria> step = reader->next_odometry();
        ASSERT_TRUE(step);
        pose = compose(pose, displacement(step->twist, step->time_s - time_s));
        time_s = step->time_s;
        EXPECT_EQ(time_s, truth->path[i].time_s);
        const Pose off = between(truth->path[i].pose, pose);
        EXPECT_LT(std::hypot(off.x, off.y), 0.03) << i;
    }
}

/// The first readings that a world gives: laser and odometry of its noise.
std::vector<double> noise_of(TourReader& reader) {
    std::vector<double> noise;
    for (int i = 0; i < 3; ++i) noise.push_back(reader.next_scan()->points.front().x);
    for (int i = 0; i < 100; ++i) noise.push_back(reader.next_odometry()->twist.v);
    return noise;
}

TEST(OpenTour, TheRunsSeedIsTheToursUnlessOneIsGiven) {
    SourceParams source;
    source.file = (kSourceDir / "data/worlds/recinto.toml").string();
    const auto noise = [&](std::uint64_t run_seed) {
        const auto reader = open_tour(source, run_seed);
        return noise_of(*reader);
    };
    EXPECT_EQ(noise(1), noise(1));
    EXPECT_NE(noise(1), noise(2));
    const std::vector<double> third = noise(3);
    source.tour_seed = 3;
    EXPECT_EQ(noise(1), third);
    EXPECT_EQ(noise(2), third);
    EXPECT_EQ(open_tour(source, 9)->truth()->seed, 3U);
    Configuracion configuration;
    configuration.source.file = source.file;
    configuration.run.seed = 3;
    EXPECT_EQ(noise_of(*open_tour(configuration)), third);
}

TEST(OpenTour, TheWorldsOwnSeedIsBetweenTheTwo) {
    const test::TempFolder folder;
    SourceParams source;
    source.file =
        folder
            .put("own.toml", "seed = 4\n" + test::content(kSourceDir / "data/worlds/recinto.toml"))
            .string();
    EXPECT_EQ(open_tour(source, 7)->truth()->seed, 4U);
    source.tour_seed = 5;
    EXPECT_EQ(open_tour(source, 7)->truth()->seed, 5U);
    source.tour_seed = 0;
    source.world_set = "seed=6 laser.rays=11";
    const auto reader = open_tour(source, 7);
    EXPECT_EQ(reader->truth()->seed, 6U);
    EXPECT_EQ(reader->next_scan()->fan.count, 11U);
    source.world_set = "laser.rays=1";
    EXPECT_THROW(open_tour(source, 7), ConfigError);
}

TEST(OpenTour, ARunOverAWorldMapsIt) {
    Configuracion configuration = preset_configuration("simulated");
    configuration.source.file = (kSourceDir / "data/worlds/lineamedia.toml").string();
    Algoritmo run(configuration, open_tour(configuration.source), {.step_grid = false});
    while (run.step()) {
    }
    const auto error =
        map_error(run.filter().best_map(), read_map(kSourceDir / "data/maps/lineamedia.map"));
    ASSERT_TRUE(error);
    EXPECT_LT(error->mean_m, 0.15);
    EXPECT_EQ(error->reference_found, 9);
}

TEST(WorldFiles, FindsTheWorldsThatComeWithHitos) {
    for (const char* name : {"recinto", "lineamedia", "bigloop", "bigloop2", "complex", "iusiani",
                             "usc-sal", "corridor", "corridor-cluttered", "park", "campus"}) {
        EXPECT_TRUE(std::filesystem::exists(find_world(name))) << name;
    }
    EXPECT_EQ(shipped_worlds().size(), 13U);
    EXPECT_THROW(find_world("atlantis"), FileError);
    EXPECT_TRUE(is_world_file("a/b.TOML"));
    EXPECT_FALSE(is_world_file("a/b.log"));
}

TEST(TourFiles, AreTheWorldAndTheDrawingOfItsWalls) {
    const test::TempFolder folder;
    const std::string world = test::content(find_world("corridor"));
    const auto plain = folder.put("plain.toml", world);
    EXPECT_EQ(tour_files(plain.string()), std::vector{plain});
    const auto drawn = folder.put("drawn.toml", "walls_dxf = \"room.dxf\"\n" + world);
    EXPECT_EQ(tour_files(drawn.string()), std::vector{drawn}) << "it cannot be opened";
    const auto drawing = folder.put("room.dxf",
                                    "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n50\n11\n9\n"
                                    "21\n50\n0\nENDSEC\n0\nEOF\n");
    EXPECT_EQ(tour_files(drawn.string()), (std::vector{drawn, drawing}));
    EXPECT_EQ(tour_files("tour.log"), std::vector<std::filesystem::path>{"tour.log"});
}

}  // namespace
}  // namespace hitos
