// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/grid_blur.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hitos/base/geometry.hpp"

namespace hitos {
namespace {

/// One ray along a row of cells of 2 m, ending in the fifth.
Scan one_ray() {
    Scan scan;
    scan.points = {{8.0, 0.0}};
    return scan;
}

double entropy_bits(double log_odds) {
    const double p = std::exp(log_odds) / (1.0 + std::exp(log_odds));
    return -p * std::log(p) / std::log(2.0) - (1.0 - p) * std::log(1.0 - p) / std::log(2.0);
}

TEST(GridBlur, IsTheEntropyOfTheCellsSeenTimesTheirArea) {
    GridParams params;
    params.resolution_m = 2.0;
    Grid grid(params);
    EXPECT_EQ(grid_blur_m2(grid), std::nullopt);
    grid.add(one_ray(), {1.0, 1.0, 0.0});
    // The ray passes four cells before the one that it ends in.
    const double once = 4.0 * (4.0 * entropy_bits(-0.4) + entropy_bits(0.85));
    EXPECT_NEAR(*grid_blur_m2(grid), once, 1e-5);
    grid.add(one_ray(), {1.0, 1.0, 0.0});
    const double twice = 4.0 * (4.0 * entropy_bits(-0.8) + entropy_bits(1.7));
    EXPECT_NEAR(*grid_blur_m2(grid), twice, 1e-5);
    EXPECT_LT(twice, once) << "what is seen again is more certain";
}

/// A robot that stands before a wall, drawn at poses that are `off` now and then.
Grid wall_seen(const Pose& off) {
    GridParams params;
    params.resolution_m = 0.1;
    Grid grid(params);
    Scan scan;
    for (int k = 0; k < 60; ++k) scan.points.push_back({4.0, -3.0 + 0.1 * k});
    for (int i = 0; i < 40; ++i) {
        const Pose there{0.05, 0.05, 0.0};
        grid.add(scan, i % 3 == 0 ? compose(there, off) : there);
    }
    return grid;
}

TEST(GridBlur, WrongPosesAddToItNearAndFar) {
    const double right = *grid_blur_m2(wall_seen({0.0, 0.0, 0.0}));
    EXPECT_GT(right, 0.0);
    // A quarter of a metre: the wall is smeared. Thirty metres: it stands there twice.
    EXPECT_GT(*grid_blur_m2(wall_seen({-0.25, 0.0, 0.02})), 1.2 * right);
    EXPECT_GT(*grid_blur_m2(wall_seen({30.0, 0.0, 0.0})), 1.5 * right);
}

}  // namespace
}  // namespace hitos
