// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/map_server_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/ieee_map_file.hpp"
#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;

/// A scan of one point straight ahead, often enough that what it says is sure.
Grid grid_with_a_point(const Pose& pose, double ahead_m) {
    GridParams params;
    params.resolution_m = 0.1;
    Grid grid(params);
    Scan scan;
    scan.points = {{ahead_m, 0.0}};
    scan.run_starts = {0};
    for (int i = 0; i < 20; ++i) grid.add(scan, pose);
    return grid;
}

TEST(MapServerFile, RowsBeginAtTheTop) {
    // From (0.05, 0.05) up to a wall at (0.05, 0.35): four cells above each other.
    const Grid grid = grid_with_a_point({0.05, 0.05, kPi / 2.0}, 0.3);
    ASSERT_EQ(grid.columns(), 1);
    ASSERT_EQ(grid.rows(), 4);
    const std::string expected("P5\n1 4\n255\n\x00\xfe\xfe\xfe", 15);
    EXPECT_EQ(map_server_pgm(grid), expected);
}

TEST(MapServerFile, WhatNoRayCameToIsUnknown) {
    Grid grid = grid_with_a_point({0.05, 0.05, 0.0}, 0.3);
    Scan scan;
    scan.points = {{0.3, 0.0}};
    scan.run_starts = {0};
    for (int i = 0; i < 20; ++i) grid.add(scan, {0.05, 0.25, kPi});
    // Above: x = -0.3 ... 0.0 and nothing farther right; below: x = 0.0 ... 0.3.
    const std::string pixels = map_server_pgm(grid).substr(std::string("P5\n7 3\n255\n").size());
    const std::string expected(
        "\x00\xfe\xfe\xfe\xcd\xcd\xcd"
        "\xcd\xcd\xcd\xcd\xcd\xcd\xcd"
        "\xcd\xcd\xcd\xfe\xfe\xfe\x00",
        21);
    EXPECT_EQ(pixels, expected);
}

TEST(MapServerFile, AGridOfNothingBetweenTwoPlacesIsRefused) {
    Grid grid = grid_with_a_point({0.05, 0.05, 0.0}, 20.0);
    const auto goes_far = [&](double x, double y) {
        Scan scan;
        scan.points = {{20.0, 0.0}};
        scan.run_starts = {0};
        grid.add(scan, {x, y, kPi / 2.0});
    };
    goes_far(30.05, 30.05);
    EXPECT_EQ(map_server_pgm(grid).substr(0, 11), "P5\n301 501\n");
    goes_far(30'000.05, 30.05);
    EXPECT_EQ(grid.columns(), 300'001);
    EXPECT_LT(grid.seen_cells(), 100'000);
    const std::string said = message_of<Error>([&] { map_server_pgm(grid); });
    EXPECT_THAT(said, HasSubstr("300001 x 501 cells, 30000 m by 50 m"));
    EXPECT_THAT(said, HasSubstr("grid.resolution"));
    EXPECT_EQ(message_of<Error>([&] { ieee_map_xml({"", "", {}, {}, grid}); }), said);
}

TEST(MapServerFile, StatesAreThoseOfTheThresholdsItStates) {
    EXPECT_EQ(state_of(0.0F), CellState::unknown);
    EXPECT_EQ(state_of(0.61F), CellState::unknown);   // 0.648
    EXPECT_EQ(state_of(0.63F), CellState::occupied);  // 0.652
    EXPECT_EQ(state_of(-1.40F), CellState::unknown);  // 0.198
    EXPECT_EQ(state_of(-1.42F), CellState::free);     // 0.195
}

TEST(MapServerFile, YamlNamesPictureAndCorner) {
    const Grid grid = grid_with_a_point({-0.95, 0.05, kPi / 2.0}, 0.3);
    EXPECT_EQ(map_server_yaml(grid, "map.pgm"),
              "image: map.pgm\nmode: trinary\nresolution: 0.1\norigin: [-1, 0, 0.0]\nnegate: 0\n"
              "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapServerFile, AnEmptyGridIsNoMap) {
    EXPECT_THAT(message_of<Error>([] { map_server_pgm(Grid()); }), HasSubstr("empty"));
}

}  // namespace
}  // namespace hitos
