// EKF-SLAM on the shipped worlds, with the configuration that comes for it.
#include <gtest/gtest.h>

#include <filesystem>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

const std::filesystem::path kSource = HITOS_SOURCE_DIR;

Configuracion configuration_for(const std::string& world) {
    Configuracion configuration = ArchivoConfiguracion::read(kSource / "config/ekf.cfg");
    configuration.source.file = (kSource / "data/worlds" / (world + ".toml")).string();
    return configuration;
}

Algoritmo finished_run(const Configuracion& configuration) {
    Algoritmo run(configuration, open_tour(configuration.source), {.step_grid = false});
    while (run.step()) {
    }
    return run;
}

class EkfOnWorld : public testing::TestWithParam<const char*> {};

TEST_P(EkfOnWorld, FindsEveryLandmarkOnceAndWithinADecimetre) {
    const std::string world = GetParam();
    const Algoritmo run = finished_run(configuration_for(world));
    const LandmarkMap reference = read_map(kSource / "data/maps" / (world + ".map"));
    const auto error = map_error(run.filter().best_map(), reference);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->landmarks, static_cast<int>(reference.size()));
    EXPECT_EQ(error->reference_found, static_cast<int>(reference.size()));
    EXPECT_LT(error->mean_m, 0.05);
    EXPECT_LT(error->maximum_m, 0.15);
}

INSTANTIATE_TEST_SUITE_P(All, EkfOnWorld,
                         testing::Values("recinto", "lineamedia", "bigloop", "bigloop2", "complex"),
                         [](const auto& test) { return std::string(test.param); });

TEST(EkfOnWorlds, TheSameBitsAgainAfterARestartAndWithAnyThreads) {
    Configuracion configuration = configuration_for("recinto");
    Algoritmo run = finished_run(configuration);
    const Trajectory first = run.best_trajectory();
    const std::string map = map_to_text(run.filter().best_map());
    run.restart();
    while (run.step()) {
    }
    EXPECT_EQ(run.best_trajectory(), first);
    EXPECT_EQ(map_to_text(run.filter().best_map()), map);
    configuration.run.threads = 3;
    EXPECT_EQ(map_to_text(finished_run(configuration).filter().best_map()), map);
}

TEST(EkfOnWorlds, TheSeedOfRansacMatters) {
    Configuracion configuration = configuration_for("recinto");
    const std::string map = map_to_text(finished_run(configuration).filter().best_map());
    configuration.run.seed = 2;  // the world's own noise keeps its seed
    EXPECT_NE(map_to_text(finished_run(configuration).filter().best_map()), map);
}

}  // namespace
}  // namespace hitos
