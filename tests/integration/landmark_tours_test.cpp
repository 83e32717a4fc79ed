// SPDX-License-Identifier: GPL-3.0-or-later
// Whole tours of landmarks with names, from the shipped world of posts, and of trees without, from
// the shipped orchard.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/tour_files.hpp"
#include "support.hpp"

namespace hitos {
namespace {

struct Driven {
    double ate_m = 0.0;
    double odometry_ate_m = 0.0;
    LandmarkMap map;
    Trajectory path;
    bool alone = false;
};

Driven driven(const std::string& source, std::uint64_t seed,
              const std::vector<std::string>& set = {}) {
    Configuracion configuration = suited_configuration(source);
    configuration.source.file = source;
    configuration.run.seed = seed;
    configuration.run.threads = 1;
    for (const std::string& assignment : set) set_parameter(configuration, assignment);
    Algoritmo run(configuration, open_tour(configuration), {.step_grid = false});
    while (run.step()) {
    }
    Driven seen{0.0, 0.0, run.filter().best_map(), run.best_trajectory(),
                run.shows_landmarks_alone()};
    if (const auto truth = run.reader().truth()) {
        seen.ate_m = trajectory_error(seen.path, truth->path).value().rmse_m;
        seen.odometry_ate_m =
            trajectory_error(run.odometry_trajectory(), truth->path).value().rmse_m;
    }
    return seen;
}

std::string posts() {
    return find_world("posts").string();
}

class LandmarkTours : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(LandmarkTours, AreMappedByTheNamesOfWhatIsSeen) {
    const auto& [assignment, limit_m] = GetParam();
    const LandmarkMap truth = reference_map(read_world(posts()));
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Driven seen = driven(posts(), seed, {assignment});
        EXPECT_TRUE(seen.alone);
        EXPECT_EQ(seen.map.size(), truth.size());
        EXPECT_LT(seen.ate_m, limit_m) << seed;
        EXPECT_GT(seen.odometry_ate_m, 1.0);
        const MapError error = aligned_map_error(seen.map, truth).value().error;
        EXPECT_EQ(error.reference_found, static_cast<int>(truth.size()));
        EXPECT_LT(error.mean_m, limit_m) << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(, LandmarkTours,
                         testing::Values(std::pair{"filter.proposal=motion", 0.4},
                                         std::pair{"filter.proposal=posterior", 0.4},
                                         std::pair{"association.method=jcbb", 0.4},
                                         std::pair{"filter.algorithm=ekf-slam", 0.15},
                                         std::pair{"filter.algorithm=graph-slam", 0.1}));

class TreeTours : public testing::TestWithParam<std::pair<const char*, double>> {};

/// By where they stand: nothing says which is which, and a laser alone sees them.
TEST_P(TreeTours, AreMappedByThePlacesOfTheTrees) {
    const auto& [assignment, limit_m] = GetParam();
    const std::string orchard = find_world("orchard").string();
    const World world = read_world(orchard);
    LandmarkMap trees = reference_map(world);
    ASSERT_EQ(trees.size(), 4 + 4 + world.landmarks.at.size());  // a shed's walls and corners first
    trees.erase(trees.begin(), trees.begin() + 8);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        Driven seen = driven(orchard, seed, {assignment});
        EXPECT_FALSE(seen.alone);
        EXPECT_LT(seen.ate_m, limit_m) << seed;
        EXPECT_GT(seen.odometry_ate_m, 3.0);
        std::erase_if(seen.map, [](const ICaracteristica& landmark) {
            return landmark.kind() == FeatureKind::line;
        });
        const MapError error = aligned_map_error(seen.map, trees).value().error;
        EXPECT_GE(error.reference_found, static_cast<int>(trees.size()) - 1);
        EXPECT_LE(seen.map.size(), trees.size() + 3);
        EXPECT_LT(error.mean_m, limit_m) << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(, TreeTours,
                         testing::Values(std::pair{"filter.proposal=motion", 0.3},
                                         std::pair{"filter.proposal=posterior", 0.1},
                                         std::pair{"association.method=jcbb", 0.1},
                                         std::pair{"filter.algorithm=ekf-slam", 0.1},
                                         std::pair{"filter.algorithm=graph-slam", 0.1}));

TEST(LandmarkLogs, GiveWhatTheWorldGave) {
    const test::TempFolder folder;
    World simulated = read_world(posts());
    simulated.seed = 5;
    write_tour_files(std::make_shared<SimulatedTour>(simulated),
                     {"normalized", folder / "posts.log", {}, {}, {}}, {});
    const Driven world = driven(posts(), 5);
    const Driven log = driven((folder / "posts.log").string(), 5);
    EXPECT_EQ(map_to_text(log.map), map_to_text(world.map));
    ASSERT_EQ(log.path.size(), world.path.size());
    for (std::size_t i = 0; i < log.path.size(); ++i)
        EXPECT_EQ(log.path[i].pose, world.path[i].pose) << i;
}

}  // namespace
}  // namespace hitos
