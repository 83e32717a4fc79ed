// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/grid/grid_tiles.hpp"

#include <gtest/gtest.h>

#include <random>

namespace hitos {
namespace {

/// A scan of random points round the robot, which wanders far enough to make the grid grow on every
/// side.
struct Wanderer {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> near{-6.0, 6.0};
    Pose pose;

    Scan next() {
        pose = compose(pose, {0.4 * near(random), 0.4 * near(random), near(random)});
        Scan scan;
        for (int i = 0; i < 20; ++i) scan.points.push_back({near(random), near(random)});
        return scan;
    }
};

std::uint8_t grey_at(const GridTiles& tiles, std::int64_t column, std::int64_t row) {
    const std::int64_t x = column - tiles.first_column * kTileSide;
    const std::int64_t y = row - tiles.first_row * kTileSide;
    const auto& tile =
        tiles.tiles[static_cast<std::size_t>(y / kTileSide * tiles.columns + x / kTileSide)];
    return tile ? tile->grey[static_cast<std::size_t>(y % kTileSide * kTileSide + x % kTileSide)]
                : std::uint8_t{205};
}

void expect_picture_of(const Grid& grid, const GridTiles& tiles) {
    const CellArea area = grid.area();
    ASSERT_EQ(tiles.area, area);
    const Grid::Picture picture = grid.picture();
    for (std::int64_t row = 0; row < grid.rows(); ++row) {
        for (std::int64_t column = 0; column < grid.columns(); ++column) {
            const auto place =
                static_cast<std::size_t>((grid.rows() - 1 - row) * grid.columns() + column);
            ASSERT_EQ(grey_at(tiles, area.first_column + column, area.first_row + row),
                      picture.grey[place])
                << column << ", " << row;
        }
    }
}

TEST(GridTiles, AreThePictureHoweverTheGridGrows) {
    Grid grid;
    GridTiler tiler;
    Wanderer wanderer;
    for (int step = 1; step <= 60; ++step) {
        const Scan scan = wanderer.next();
        grid.add(scan, wanderer.pose);
        tiler.note_change(grid.last_change());
        if (step % 7 == 0 || step == 60) expect_picture_of(grid, tiler.tiles(grid));
    }
    expect_picture_of(grid, tiles_of(grid));
}

TEST(GridTiles, ShareWhatDidNotChange) {
    Grid grid;
    GridTiler tiler;
    Scan scan;
    scan.points = {{20.0, 0.0}, {0.0, 20.0}, {-20.0, 0.0}, {0.0, -20.0}};
    grid.add(scan, {});
    tiler.note_change(grid.last_change());
    const GridTiles before = tiler.tiles(grid);
    scan.points = {{1.0, 0.0}};
    grid.add(scan, {15.0, 0.0, 0.0});
    tiler.note_change(grid.last_change());
    const GridTiles after = tiler.tiles(grid);
    ASSERT_EQ(before.tiles.size(), after.tiles.size());
    std::size_t fresh = 0;
    for (std::size_t i = 0; i < after.tiles.size(); ++i)
        if (before.tiles[i] != after.tiles[i]) ++fresh;
    EXPECT_GE(fresh, 1U);
    EXPECT_LE(fresh, 2U);
    expect_picture_of(grid, after);
}

TEST(GridTiles, OfAnEmptyGridAreNone) {
    EXPECT_TRUE(tiles_of(Grid{}).empty());
    GridTiler tiler;
    EXPECT_TRUE(tiler.tiles(Grid{}).empty());
}

TEST(GridTiles, BeginAnewAfterClear) {
    Grid grid;
    GridTiler tiler;
    Scan scan;
    scan.points = {{5.0, 5.0}};
    grid.add(scan, {});
    tiler.note_change(grid.last_change());
    ASSERT_FALSE(tiler.tiles(grid).empty());
    grid.clear();
    tiler.clear();
    EXPECT_TRUE(tiler.tiles(grid).empty());
    scan.points = {{-5.0, 1.0}};
    grid.add(scan, {});
    tiler.note_change(grid.last_change());
    expect_picture_of(grid, tiler.tiles(grid));
}

TEST(GridChange, HoldsEveryCellThatChanged) {
    Grid grid;
    Wanderer wanderer;
    EXPECT_TRUE(grid.last_change().empty());
    for (int step = 0; step < 30; ++step) {
        const Grid before = grid;
        const Scan scan = wanderer.next();
        grid.add(scan, wanderer.pose);
        const CellArea change = grid.last_change();
        const CellArea area = grid.area();
        const CellArea old = before.area();
        for (std::int64_t row = area.first_row; row < area.end_row; ++row) {
            for (std::int64_t column = area.first_column; column < area.end_column; ++column) {
                const bool inside = column >= change.first_column && column < change.end_column &&
                                    row >= change.first_row && row < change.end_row;
                if (inside) continue;
                const bool was_there = column >= old.first_column && column < old.end_column &&
                                       row >= old.first_row && row < old.end_row;
                const float was = was_there
                                      ? before.log_odds(static_cast<int>(column - old.first_column),
                                                        static_cast<int>(row - old.first_row))
                                      : 0.0F;
                ASSERT_EQ(grid.log_odds(static_cast<int>(column - area.first_column),
                                        static_cast<int>(row - area.first_row)),
                          was);
            }
        }
    }
}

}  // namespace
}  // namespace hitos
