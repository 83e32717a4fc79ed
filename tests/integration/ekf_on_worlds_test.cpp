// SPDX-License-Identifier: GPL-3.0-or-later
// EKF-SLAM on the shipped worlds, with the configuration that comes for it.
#include <gtest/gtest.h>

#include <filesystem>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

const std::filesystem::path kEkfSource = HITOS_SOURCE_DIR;

Configuracion configuration_for(const std::string& world, const char* preset = "ekf.cfg") {
    Configuracion configuration = ArchivoConfiguracion::read(kEkfSource / "config" / preset);
    configuration.source.file = (kEkfSource / "data/worlds" / (world + ".toml")).string();
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
    const LandmarkMap reference = read_map(kEkfSource / "data/maps" / (world + ".map"));
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

TEST(EkfOnWorlds, ThePaperToTheLetterMeasuresTheCorridorBetterThanItsTable) {
    for (std::int64_t seed = 1; seed <= 2; ++seed) {
        Configuracion configuration = configuration_for("corridor", "paper.cfg");
        configuration.run.seed = static_cast<std::uint64_t>(seed);
        const Algoritmo run = finished_run(configuration);
        const auto measured = measure_distances(
            run.filter().best_map(), read_distances(kEkfSource / "data/worlds/corridor.distances"));
        ASSERT_EQ(measured.size(), 9U);
        for (const MeasuredDistance& distance : measured) {
            ASSERT_TRUE(distance.error_percent()) << distance.missing;
            EXPECT_LT(*distance.error_percent(), 0.5);  // [P table 1]: up to 3.35
        }
    }
}

TEST(EkfOnWorlds, JointCompatibilityFindsEveryLandmarkToo) {
    Configuracion configuration = configuration_for("complex");
    configuration.filter.association.method = AssociationMethod::joint_compatibility;
    const Algoritmo run = finished_run(configuration);
    const LandmarkMap reference = read_map(kEkfSource / "data/maps/complex.map");
    const auto error = map_error(run.filter().best_map(), reference);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->landmarks, static_cast<int>(reference.size()));
    EXPECT_LT(error->mean_m, 0.05);
    EXPECT_EQ(run.filter().statistics().searches_cut, 0U);
}

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
