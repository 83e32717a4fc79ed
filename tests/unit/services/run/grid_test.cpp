// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/grid/grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "hitos/base/error.hpp"
#include "slow_grid.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Scan scan_of(std::vector<Point2> points) {
    Scan scan;
    scan.points = std::move(points);
    return scan;
}

GridParams unit_cells() {
    GridParams params;
    params.resolution_m = 1.0;
    params.log_odds_hit = 1.0;
    params.log_odds_miss = -0.5;
    params.log_odds_limit = 3.0;
    return params;
}

/// The known cells with their values, whatever the grid's bounds.
std::map<Cell, float> known_cells(const Grid& grid) {
    std::map<Cell, float> cells;
    const auto column0 = std::llround(grid.origin().x / grid.resolution_m());
    const auto row0 = std::llround(grid.origin().y / grid.resolution_m());
    for (int row = 0; row < grid.rows(); ++row) {
        for (int column = 0; column < grid.columns(); ++column) {
            if (grid.known(column, row)) {
                cells[{column0 + column, row0 + row}] = grid.log_odds(column, row);
            }
        }
    }
    return cells;
}

std::map<Cell, float> after_one_ray(const Point2& from, const Point2& to) {
    Grid grid(unit_cells());
    grid.add(scan_of({{to.x - from.x, to.y - from.y}}), {from.x, from.y, 0.0});
    return known_cells(grid);
}

TEST(Grid, StartsEmpty) {
    const Grid grid;
    EXPECT_TRUE(grid.empty());
    EXPECT_EQ(grid.columns(), 0);
    EXPECT_EQ(grid.rows(), 0);
    EXPECT_TRUE(grid.picture().grey.empty());
}

TEST(Grid, ARayFreesWhatItPassesAndOccupiesItsEnd) {
    using Cells = std::map<Cell, float>;
    EXPECT_EQ(after_one_ray({0.5, 0.5}, {3.5, 0.5}),
              (Cells{{{0, 0}, -0.5F}, {{1, 0}, -0.5F}, {{2, 0}, -0.5F}, {{3, 0}, 1.0F}}));
    EXPECT_EQ(after_one_ray({0.5, 0.5}, {-1.5, 0.5}),
              (Cells{{{0, 0}, -0.5F}, {{-1, 0}, -0.5F}, {{-2, 0}, 1.0F}}));
    EXPECT_EQ(after_one_ray({0.5, 0.5}, {0.5, -1.5}),
              (Cells{{{0, 0}, -0.5F}, {{0, -1}, -0.5F}, {{0, -2}, 1.0F}}));
    // Up the slope the ray changes row inside column 1.
    EXPECT_EQ(after_one_ray({0.5, 0.25}, {2.5, 1.75}),
              (Cells{{{0, 0}, -0.5F}, {{1, 0}, -0.5F}, {{1, 1}, -0.5F}, {{2, 1}, 1.0F}}));
    EXPECT_EQ(after_one_ray({0.5, 0.5}, {0.75, 0.25}), (Cells{{{0, 0}, 1.0F}}));
}

TEST(Grid, CellsHoldTheirLowerBorders) {
    const std::map<Cell, float> cells = after_one_ray({0.0, 0.0}, {2.0, 0.0});
    EXPECT_EQ(cells, (std::map<Cell, float>{{{0, 0}, -0.5F}, {{1, 0}, -0.5F}, {{2, 0}, 1.0F}}));
    // Downwards through the corner (1, 1), which is the cell's to the right and above.
    EXPECT_EQ(
        after_one_ray({0.5, 1.25}, {2.5, 0.25}),
        (std::map<Cell, float>{{{0, 1}, -0.5F}, {{1, 1}, -0.5F}, {{1, 0}, -0.5F}, {{2, 0}, 1.0F}}));
    // 0.15 / 0.05 is a little less than 3 in doubles.
    GridParams params;
    params.resolution_m = 0.05;
    Grid grid(params);
    grid.add(scan_of({{0.15, 0.0}}), {});
    EXPECT_EQ(grid.columns(), 4);
    EXPECT_GT(grid.log_odds(3, 0), 0.0F);
}

TEST(Grid, BoundsAreWhatWasDrawn) {
    Grid grid(unit_cells());
    grid.add(scan_of({{2.0, 0.0}, {0.0, -4.0}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.columns(), 3);
    EXPECT_EQ(grid.rows(), 5);
    EXPECT_EQ(grid.origin(), (Point2{0.0, -4.0}));
    grid.add(scan_of({{-7.0, 2.0}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.columns(), 10);
    EXPECT_EQ(grid.rows(), 7);
    EXPECT_EQ(grid.origin(), (Point2{-7.0, -4.0}));
}

TEST(Grid, NoCellThatAScanHitIsFreedByIt) {
    const std::vector<Point2> points = {{3.0, 0.0}, {5.0, 0.0}, {3.2, 0.1}};
    for (const auto& order : {std::vector<int>{0, 1, 2}, {1, 0, 2}, {2, 1, 0}}) {
        Scan scan;
        for (const int i : order) scan.points.push_back(points[static_cast<std::size_t>(i)]);
        Grid grid(unit_cells());
        grid.add(scan, {0.5, 0.5, 0.0});
        EXPECT_EQ(grid.log_odds(3, 0), 2.0F);  // hit twice, passed once
        EXPECT_EQ(grid.log_odds(5, 0), 1.0F);
        EXPECT_EQ(grid.log_odds(4, 0), -0.5F);
        EXPECT_EQ(grid.log_odds(1, 0), -1.5F);
        // The next scan may free it.
        grid.add(scan_of({{5.0, 0.0}}), {0.5, 0.5, 0.0});
        EXPECT_EQ(grid.log_odds(3, 0), 1.5F);
    }
}

TEST(Grid, ValuesStayWithinTheLimit) {
    Grid grid(unit_cells());
    for (int i = 0; i < 20; ++i) grid.add(scan_of({{2.0, 0.0}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.log_odds(0, 0), -3.0F);
    EXPECT_EQ(grid.log_odds(2, 0), 3.0F);
}

TEST(Grid, RaysAreDrawnUpToTheGreatestRange) {
    GridParams params = unit_cells();
    params.max_range_m = 3.0;
    Grid grid(params);
    grid.add(scan_of({{10.0, 0.0}, {0.0, 3.0}, {1e300, 1e300}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.columns(), 4);
    EXPECT_EQ(grid.rows(), 4);
    EXPECT_EQ(grid.log_odds(3, 0), -0.5F);  // the last cell within reach, freed
    EXPECT_EQ(grid.log_odds(0, 3), 1.0F);   // exactly at the range: a hit
    EXPECT_EQ(grid.log_odds(2, 2), -0.5F);
}

TEST(Grid, ACutRayFreesTheCellItIsCutIn) {
    GridParams params = unit_cells();
    params.max_range_m = 1.5;
    Grid grid(params);
    grid.add(scan_of({{4.0, 3.0}}), {0.5, 0.25, 0.0});  // ends at (1.7, 1.15)
    EXPECT_EQ(known_cells(grid),
              (std::map<Cell, float>{{{0, 0}, -0.5F}, {{1, 0}, -0.5F}, {{1, 1}, -0.5F}}));
}

TEST(Grid, RaysStartAtTheLaser) {
    Scan scan = scan_of({{4.0, 0.0}});  // in the robot frame
    scan.fan.pose_robot_laser = {2.0, 0.0, kPi};
    Grid grid(unit_cells());
    grid.add(scan, {0.5, 0.5, kPi / 2.0});
    EXPECT_EQ(known_cells(grid),
              (std::map<Cell, float>{{{0, 2}, -0.5F}, {{0, 3}, -0.5F}, {{0, 4}, 1.0F}}));
}

TEST(Grid, AgreesWithTheSlowGridOnATourThatGrowsEverywhere) {
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> places(-6.0, 6.0);
    std::uniform_real_distribution<double> angles(-kPi, kPi);
    std::uniform_real_distribution<double> ranges(0.0, 4.0);
    GridParams params;
    params.resolution_m = 0.11;
    Grid fast(params);
    SlowGrid slow(params);
    for (int i = 0; i < 60; ++i) {
        Scan scan;
        scan.fan.pose_robot_laser = {0.1, -0.05, 0.3};
        for (int k = 0; k < 25; ++k) {
            const double angle = angles(random);
            const double range = ranges(random);
            scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
        }
        const Pose pose{places(random), places(random), angles(random)};
        fast.add(scan, pose);
        slow.add(scan, pose);
    }
    std::map<Cell, float> cells = known_cells(fast);
    std::erase_if(slow.cells, [](const auto& entry) { return entry.second == 0.0F; });
    EXPECT_LT(slow.doubtful.size(), 60U);
    for (const Cell& cell : slow.doubtful) {
        cells.erase(cell);
        slow.cells.erase(cell);
    }
    EXPECT_GT(cells.size(), 5000U);
    EXPECT_EQ(cells, slow.cells);
}

TEST(Grid, RaysInEveryDirectionPassAsManyCellsAsTheyCrossBorders) {
    for (int i = 0; i < 720; ++i) {
        const double angle = i * kPi / 360.0;
        const Point2 from{0.37, 0.61};
        const Point2 to{from.x + 40.3 * std::cos(angle), from.y + 40.3 * std::sin(angle)};
        const auto borders = std::abs(std::floor(to.x)) + std::abs(std::floor(to.y));
        EXPECT_EQ(static_cast<double>(after_one_ray(from, to).size()), borders + 1.0) << i;
    }
}

TEST(Grid, TheSameScansGiveTheSameBits) {
    const auto draw = [] {
        std::mt19937_64 random(8);
        std::uniform_real_distribution<double> values(-5.0, 5.0);
        Grid grid;
        for (int i = 0; i < 50; ++i) {
            Scan scan;
            for (int k = 0; k < 100; ++k) scan.points.push_back({values(random), values(random)});
            grid.add(scan, {values(random), values(random), values(random)});
        }
        return known_cells(grid);
    };
    EXPECT_EQ(draw(), draw());
}

TEST(Grid, LeavesOutWhatIsNotFinite) {
    Grid grid(unit_cells());
    const Scan scan = scan_of({{1.0, 0.0}, {kNan, 0.0}, {0.0, HUGE_VAL}, {1e308, 1e308}});
    for (const Pose& pose : {Pose{kNan, 0.0, 0.0}, Pose{0.0, HUGE_VAL, 0.0}, Pose{0.0, 0.0, kNan},
                             Pose{1e30, 0.0, 0.0}}) {
        grid.add(scan, pose);
        EXPECT_TRUE(grid.empty());
    }
    grid.add(scan, {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.columns(), 2);
    EXPECT_EQ(grid.rows(), 1);
}

TEST(Grid, LeavesOutWhatWouldTakeTooManyCells) {
    Grid grid(unit_cells());
    // A million columns are possible, and then 268 rows, but no more.
    grid.add(scan_of({{1e6, 0.0}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.columns(), 1000001);
    EXPECT_EQ(grid.scans_left_out(), 0U);
    grid.add(scan_of({{0.0, 1e5}, {3.0, 4.0}, {0.0, -1e5}, {1e9, 0.0}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(grid.rows(), 5);
    EXPECT_EQ(grid.log_odds(3, 4), 1.0F);
    EXPECT_EQ(grid.log_odds(1000000, 0), 1.0F);
    // Not even the laser fits.
    EXPECT_EQ(grid.scans_left_out(), 1U);
    grid.add(scan_of({{1.0, 0.0}, {2.0, 0.0}}), {0.5, 1e5, 0.0});
    EXPECT_EQ(grid.rows(), 5);
    EXPECT_EQ(grid.scans_left_out(), 2U);
    EXPECT_GT(grid.resolution_for_all(), 10.0);
    // One that holds all of it, and hardly a coarser one than it takes.
    GridParams fine = unit_cells();
    fine.resolution_m = 0.001;
    const auto draw = [](Grid& drawn) {
        for (const double x : {-30.0, 0.0, 30.0, 60.0})
            drawn.add(scan_of({{5.0, 0.0}, {0.0, 12.0}}), {x, 0.0, 0.0});
    };
    Grid beyond(fine);
    draw(beyond);
    EXPECT_GT(beyond.scans_left_out(), 0U);
    fine.resolution_m = beyond.resolution_for_all();
    EXPECT_LT(fine.resolution_m, 0.01);
    Grid all(fine);
    draw(all);
    EXPECT_EQ(all.scans_left_out(), 0U);
    // Ten million cells in a row are few, but need tiles of 640 million.
    Grid strip(unit_cells());
    strip.add(scan_of({{1e7, 0.0}, {3.0, 0.0}}), {0.5, 0.5, 0.0});
    EXPECT_EQ(strip.columns(), 4);
}

TEST(Grid, WorksFarFromTheOrigin) {
    GridParams params;
    params.resolution_m = 0.05;
    Grid near(params);
    Grid far(params);
    const Scan scan = scan_of({{1.03, 0.52}, {-0.71, 0.33}, {0.12, -0.93}});
    near.add(scan, {0.02, 0.01, 0.4});
    const double offset = 1e6;
    far.add(scan, {0.02 + offset, 0.01 - offset, 0.4});
    EXPECT_EQ(near.columns(), far.columns());
    EXPECT_EQ(near.rows(), far.rows());
    for (int row = 0; row < near.rows(); ++row) {
        for (int column = 0; column < near.columns(); ++column) {
            EXPECT_EQ(near.log_odds(column, row), far.log_odds(column, row));
        }
    }
}

TEST(Grid, ClearForgetsTheCells) {
    Grid grid(unit_cells());
    grid.add(scan_of({{2.0, 0.0}, {kNan, 0.0}}), {0.5, 0.5, 0.0});
    grid.clear();
    EXPECT_TRUE(grid.empty());
    grid.add(scan_of({{2.0, 0.0}}), {10.5, 0.5, 0.0});
    EXPECT_EQ(grid.origin(), (Point2{10.0, 0.0}));
    EXPECT_EQ(grid.log_odds(0, 0), -0.5F);
}

TEST(Grid, AnEmptyScanChangesNothing) {
    Grid grid;
    grid.add({}, {});
    EXPECT_TRUE(grid.empty());
}

TEST(Grid, RefusesParametersThatNoGridCanHave) {
    const auto refusal = [](double GridParams::*field, double value) {
        GridParams params;
        params.*field = value;
        return message_of<ConfigError>([&] { const Grid grid(params); });
    };
    EXPECT_EQ(refusal(&GridParams::resolution_m, 0.0),
              "grid.resolution: 0 is out of range; allowed: 0.001 to 10 m");
    EXPECT_THAT(refusal(&GridParams::resolution_m, kNan), HasSubstr("grid.resolution: nan"));
    EXPECT_THAT(refusal(&GridParams::log_odds_hit, -0.1), HasSubstr("grid.hit: -0.1"));
    EXPECT_THAT(refusal(&GridParams::log_odds_miss, 0.1), HasSubstr("grid.miss: 0.1"));
    EXPECT_THAT(refusal(&GridParams::log_odds_limit, 0.0), HasSubstr("grid.limit: 0 "));
    EXPECT_THAT(refusal(&GridParams::max_range_m, HUGE_VAL), HasSubstr("grid.max_range: inf"));
}

TEST(GridPicture, HasTheTopRowFirst) {
    GridParams params = unit_cells();
    params.log_odds_hit = std::log(3.0);    // p = 3/4
    params.log_odds_miss = -std::log(4.0);  // p = 1/5
    Grid grid(params);
    grid.add(scan_of({{1.0, 0.0}, {0.0, 1.0}}), {0.5, 0.5, 0.0});
    const Grid::Picture picture = grid.picture();
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 2);
    // The start was passed twice: odds 1/16, limited to e^-3 at the least.
    // What is likelier free than not is lighter than what nobody saw.
    const auto start = static_cast<int>(std::lround(205.0 + 50.0 * (2.0 * 16.0 / 17.0 - 1.0)));
    const auto hit = static_cast<int>(grey_of(std::log(3.0F)));
    EXPECT_NEAR(hit, 205.0 * 2.0 * 0.25, 1.0);
    EXPECT_THAT(picture.grey, ::testing::ElementsAre(hit, 205, start, hit));
}

TEST(GridPicture, GreysFollowWhatIsKnown) {
    EXPECT_EQ(grey_of(0.0F), kUnknownGrey);
    EXPECT_EQ(grey_of(20.0F), 0);
    EXPECT_EQ(grey_of(-20.0F), 255);
    for (int quarter = -24; quarter < 24; ++quarter) {
        const float odds = 0.25F * static_cast<float>(quarter);
        EXPECT_GE(grey_of(odds), grey_of(odds + 0.25F)) << odds;
    }
}

TEST(GridPicture, SureCellsAreWhiteAndBlack) {
    GridParams params = unit_cells();
    params.log_odds_hit = 50.0;
    params.log_odds_miss = -50.0;
    params.log_odds_limit = 100.0;
    Grid grid(params);
    grid.add(scan_of({{1.0, 0.0}}), {0.5, 0.5, 0.0});
    EXPECT_THAT(grid.picture().grey, ::testing::ElementsAre(255, 0));
}

}  // namespace
}  // namespace hitos
