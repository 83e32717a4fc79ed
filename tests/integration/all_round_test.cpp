// SPDX-License-Identifier: GPL-3.0-or-later
// Lasers that turn all round, in a room that has no opening.
#include <gtest/gtest.h>

#include <filesystem>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

const std::filesystem::path kAllRoundSource = HITOS_SOURCE_DIR;

class AllRound : public testing::TestWithParam<const char*> {};

TEST_P(AllRound, AClosedRoomHasItsWallsAndCornersWhateverTheFan) {
    const LandmarkMap reference = read_map(kAllRoundSource / "data/maps/recinto.map");
    for (const char* fan : {"laser.rays=360 laser.field_of_view=359",
                            "laser.rays=360 laser.field_of_view=359 laser.clockwise=true "
                            "laser.fan_turn=-77",
                            "laser.rays=181 laser.field_of_view=360"}) {
        Configuracion configuration =
            ArchivoConfiguracion::read(kAllRoundSource / "config/simulated.cfg");
        configuration.filter.algorithm = GetParam();
        configuration.source.file = (kAllRoundSource / "data/worlds/recinto.toml").string();
        configuration.source.world_set =
            std::string("tour.laps=1 laser.max_range=30 laser.sigma=0.003 ") + fan;
        Algoritmo run(configuration, open_tour(configuration.source), {.step_grid = false});
        while (run.step()) {
        }
        const auto error = map_error(run.filter().best_map(), reference);
        ASSERT_TRUE(error) << fan;
        EXPECT_EQ(error->landmarks, static_cast<int>(reference.size())) << fan;
        EXPECT_EQ(error->reference_found, static_cast<int>(reference.size())) << fan;
        EXPECT_LT(error->mean_m, 0.1) << fan;
    }
}

INSTANTIATE_TEST_SUITE_P(Every, AllRound, testing::Values("fastslam", "ekf-slam", "graph-slam"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace hitos
