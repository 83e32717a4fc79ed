#include "hitos/workbench/open_tour.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/maps/map_file.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/shipped_data.hpp"

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

TEST(OpenTour, ARunOverAWorldMapsIt) {
    Configuracion configuration = ArchivoConfiguracion::read(kSourceDir / "config/simulated.cfg");
    // The world's laser has 10 mm of noise, for which the thesis's end-point fit is too fine.
    configuration.extraction.split_merge.fit = LineFit::least_squares;
    configuration.extraction.split_merge.dmax_m = 0.04;
    configuration.source.file = (kSourceDir / "data/worlds/lineamedia.toml").string();
    Algoritmo run(configuration, open_tour(configuration.source), {.step_grid = false});
    while (run.step()) {
    }
    const auto error =
        map_error(run.filter().best_map(), read_map(kSourceDir / "data/maps/lineamedia.map"));
    ASSERT_TRUE(error);
    EXPECT_LT(error->mean_m, 0.3);
    EXPECT_EQ(error->reference_found, 9);
}

TEST(WorldFiles, FindsTheWorldsThatComeWithHitos) {
    for (const char* name : {"recinto", "lineamedia", "bigloop", "bigloop2", "complex", "iusiani",
                             "usc-sal", "corridor"}) {
        EXPECT_TRUE(std::filesystem::exists(find_world(name))) << name;
    }
    EXPECT_EQ(shipped_worlds().size(), 8U);
    EXPECT_THROW(find_world("atlantis"), FileError);
    EXPECT_TRUE(is_world_file("a/b.TOML"));
    EXPECT_FALSE(is_world_file("a/b.log"));
}

}  // namespace
}  // namespace hitos
