// SPDX-License-Identifier: GPL-3.0-or-later
// The laser that sees cells: against a brute-force search of the cells, against the exact laser,
// and by what thickness, fitting and whole cells must do.
#include "laser/raster_laser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2.0;

RasterParams raster(double cell_m, double wall_m = 0.0, bool fit = false,
                    RasterRanges ranges = RasterRanges::exact) {
    RasterParams params;
    params.cell_m = cell_m;
    params.wall_m = wall_m;
    params.fit = fit;
    params.ranges = ranges;
    return params;
}

Fan raster_fan(std::uint32_t count = 181, double most = 8.0) {
    Fan result;
    result.min_angle_rad = -kHalfPi;
    result.max_angle_rad = kHalfPi;
    result.count = count;
    result.max_range_m = most;
    return result;
}

/// Range of one ray straight ahead.
double ahead(const std::vector<WallSegment>& walls, const RasterParams& params, const Pose& pose) {
    std::vector<RayHit> hits;
    RasterLaser(walls, params, raster_fan(3)).cast(pose, hits);
    return hits[1].range_m;
}

std::vector<WallSegment> random_walls(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    std::vector<WallSegment> walls;
    walls.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        walls.push_back({{place(random), place(random)}, {place(random), place(random)}, i, 0});
    }
    return walls;
}

/// Where the ray enters the square, by its two slabs; infinity where it passes.
double enters(const Point2& from, double cosine, double sine, const Point2& least, double size) {
    const double x1 = (least.x - from.x) / cosine;
    const double x2 = (least.x + size - from.x) / cosine;
    const double y1 = (least.y - from.y) / sine;
    const double y2 = (least.y + size - from.y) / sine;
    const double in = std::max(std::min(x1, x2), std::min(y1, y2));
    const double out = std::min(std::max(x1, x2), std::max(y1, y2));
    return in <= out && out >= 0.0 ? std::max(in, 0.0) : std::numeric_limits<double>::infinity();
}

TEST(WallRaster, HoldsACellWhereAPartOfTheDrawnWallLiesInIt) {
    std::mt19937 random(5);
    constexpr double kCell = 0.13;
    constexpr double kWall = 0.3;
    constexpr int kSamples = 24;
    int occupied = 0;
    for (int round = 0; round < 6; ++round) {
        const std::vector<WallSegment> walls = random_walls(random, 1);
        const WallRaster cells(walls, raster(kCell, kWall));
        const Point2& a = walls[0].a;
        const double length = std::hypot(walls[0].b.x - a.x, walls[0].b.y - a.y);
        const double ux = (walls[0].b.x - a.x) / length;
        const double uy = (walls[0].b.y - a.y) / length;
        /// How far outside the drawn rectangle a point lies, at most 0 inside.
        const auto outside = [&](double x, double y) {
            const double along = (x - a.x) * ux + (y - a.y) * uy;
            const double across = (y - a.y) * ux - (x - a.x) * uy;
            return std::max(std::abs(along - length / 2.0) - length / 2.0, std::abs(across)) -
                   kWall / 2.0;
        };
        for (int y = -30; y < 30; ++y) {
            for (int x = -30; x < 30; ++x) {
                double nearest = 1e9;
                for (int i = 0; i <= kSamples; ++i) {
                    for (int k = 0; k <= kSamples; ++k) {
                        nearest = std::min(nearest, outside((x + i / double{kSamples}) * kCell,
                                                            (y + k / double{kSamples}) * kCell));
                    }
                }
                const bool held = cells.occupied(x, y);
                occupied += held ? 1 : 0;
                if (nearest < -1e-6) {
                    EXPECT_TRUE(held) << x << " " << y;
                }
                if (nearest > kCell / kSamples) {
                    EXPECT_FALSE(held) << x << " " << y;
                }
            }
        }
    }
    EXPECT_GT(occupied, 300);
}

TEST(RasterLaser, EndsRaysAtTheNearestCellThatASearchOfAllCellsFinds) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-4.0, 4.0);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    constexpr double kCell = 0.1;
    int hit = 0;
    for (int round = 0; round < 10; ++round) {
        const std::vector<WallSegment> walls = random_walls(random, 4);
        const RasterParams params = raster(kCell, 0.05);
        const WallRaster cells(walls, params);
        const Pose pose{place(random), place(random), angle(random)};
        std::vector<RayHit> hits;
        const Fan f = raster_fan(61, 5.0);
        RasterLaser(walls, params, f).cast(pose, hits);
        for (std::uint32_t k = 0; k < f.count; ++k) {
            const double at = pose.theta + f.min_angle_rad + k * f.step_rad();
            double nearest = std::numeric_limits<double>::infinity();
            for (int y = -40; y < 40; ++y) {
                for (int x = -40; x < 40; ++x) {
                    if (!cells.occupied(x, y)) continue;
                    nearest = std::min(nearest, enters({pose.x, pose.y}, std::cos(at), std::sin(at),
                                                       {x * kCell, y * kCell}, kCell));
                }
            }
            if (nearest > f.max_range_m) {
                EXPECT_TRUE(std::isinf(hits[k].range_m));
                continue;
            }
            ++hit;
            EXPECT_NEAR(hits[k].range_m, nearest, 1e-9);
        }
    }
    EXPECT_GT(hit, 200);
}

TEST(RasterLaser, ComesToTheExactRangesAsCellsGetFineAndWallsThin) {
    const World world = test::small_world();
    const Pose pose{1.237, 0.481, 0.3};
    std::vector<RayHit> exact;
    SimulatedLaser(world.walls, raster_fan()).cast(pose, exact);
    double before = 1e9;
    for (const double cell : {0.1, 0.01, 0.001}) {
        std::vector<RayHit> hits;
        RasterLaser(world.walls, raster(cell), raster_fan()).cast(pose, hits);
        double worst = 0.0;
        for (std::size_t k = 0; k < hits.size(); ++k) {
            ASSERT_EQ(std::isfinite(hits[k].range_m), std::isfinite(exact[k].range_m)) << k;
            if (std::isfinite(exact[k].range_m)) {
                worst = std::max(worst, std::abs(hits[k].range_m - exact[k].range_m));
            }
        }
        // No ray of this pose meets a wall flatter than about 1 : 6.
        EXPECT_LT(worst, 8.0 * cell);
        EXPECT_LT(worst, before / 5.0);
        before = worst;
    }
}

TEST(RasterLaser, SeesAThickWallHalfItsThicknessNearerFromBothSides) {
    const std::vector<WallSegment> walls{{{4.0, -3.0}, {4.0, 3.0}, 1, 0}};
    EXPECT_NEAR(ahead(walls, raster(0.02, 0.08), {1.003, 0.001, 0.0}), 2.957, 1e-9);
    EXPECT_NEAR(ahead(walls, raster(0.02, 0.08), {6.003, 0.001, kHalfPi * 2.0}), 1.963, 1e-9);
    // What does not end on the border of a cell fills that cell.
    EXPECT_NEAR(ahead(walls, raster(0.02, 0.05), {1.003, 0.001, 0.0}), 2.957, 1e-9);
    // Without thickness the cells on both sides of the line hold it.
    EXPECT_NEAR(ahead(walls, raster(0.02), {1.003, 0.001, 0.0}), 2.977, 1e-9);
    EXPECT_NEAR(ahead(walls, raster(0.02), {6.003, 0.001, kHalfPi * 2.0}), 1.983, 1e-9);
}

TEST(RasterLaser, FittedDrawingsEndAtTheOutermostWalls) {
    const World world = test::small_world();  // 10 x 6 m
    constexpr double kWall = 0.06;
    const RasterParams params = raster(0.001, kWall, true);
    const Pose east{3.0, 1.0, 0.0};
    const Pose north{3.0, 1.0, kHalfPi};
    // The whole thickness lies inside; all lengths shrink by 10 / 10.06 and 6 / 6.06.
    EXPECT_NEAR(ahead(world.walls, params, east), 5.0 - kWall * 10.0 / 10.06, 0.002);
    EXPECT_NEAR(ahead(world.walls, params, north), 3.0 - kWall * 6.0 / 6.06, 0.002);
    EXPECT_NEAR(ahead(world.walls, raster(0.001, kWall), east), 5.0 - kWall / 2.0, 0.002);
}

TEST(RasterLaser, CountsWholeCellsAlongTheLongerAxis) {
    const World world = test::small_world();
    constexpr double kCell = 0.02;
    const Pose pose{1.237, 0.481, 0.0};
    const Fan f = raster_fan();
    std::vector<RayHit> whole;
    std::vector<RayHit> exact;
    RasterLaser(world.walls, raster(kCell, 0.05, false, RasterRanges::whole_cells), f)
        .cast(pose, whole);
    RasterLaser(world.walls, raster(kCell, 0.05), f).cast(pose, exact);
    int steps = 0;
    for (std::uint32_t k = 0; k < f.count; ++k) {
        const double at = f.min_angle_rad + k * f.step_rad();
        const double longer = std::max(std::abs(std::cos(at)), std::abs(std::sin(at)));
        if (!std::isfinite(exact[k].range_m)) continue;
        const double cells = whole[k].range_m * longer / kCell;
        EXPECT_NEAR(cells, std::round(cells), 1e-6) << k;
        // It starts in the middle of a cell and walks whole ones: two cells at the most.
        EXPECT_NEAR(whole[k].range_m * longer, exact[k].range_m * longer, 3.0 * kCell) << k;
        // A wall that faces the ray is seen straight: as many cells for all its rays.
        if (std::abs(at) < 0.3) {
            EXPECT_DOUBLE_EQ(std::round(cells), 337.0) << k;
        } else {
            steps += std::abs(whole[k].range_m - exact[k].range_m) > 0.25 * kCell ? 1 : 0;
        }
    }
    EXPECT_GT(steps, 10);
}

TEST(RasterLaser, RefusesMoreCellsThanMemoryShouldHold) {
    World world = test::shipped("complex");
    set_world_value(world, "raster.cell=0.001");
    const std::string message = test::message_of<ConfigError>([&] { check(world); });
    EXPECT_NE(message.find("raster.cell: found 0.001 m for walls over 40 x 20 m"),
              std::string::npos)
        << message;
    EXPECT_THROW(WallRaster(world.walls, world.raster), ConfigError);
    EXPECT_THROW(WallRaster(world.walls, raster(0.0)), ConfigError);
    set_world_value(world, "raster.cell=0.02");
    EXPECT_NO_THROW(check(world));
}

TEST(SimulatedTour, TakesItsScansFromTheRasterWhereThereIsOne) {
    World world = test::small_world();
    world.laser.sigma_m = 0.0;
    world.laser.max_range_m = 12.0;
    const Scan plain = SimulatedTour(world).scan(0);
    for (const char* change : {"raster.cell=0.02", "raster.wall=0.08"}) {
        set_world_value(world, change);
    }
    const SimulatedTour tour(world);
    const Scan thick = tour.scan(0);
    ASSERT_EQ(thick.points.size(), plain.points.size());
    double left = 0.0;
    double right = 0.0;
    for (const Point2& p : thick.points) {
        left = std::max(left, p.y);
        right = std::min(right, p.y);
    }
    EXPECT_NEAR(left, 3.96, 1e-9) << "the wall y = 4, drawn 8 cm thick";
    EXPECT_NEAR(right, -1.96, 1e-9);
    EXPECT_NE(thick.points, plain.points);
    EXPECT_EQ(SimulatedTour(world).scan(7).points, tour.scan(7).points);
    // The way itself is driven among the walls, not among the cells.
    World thin = test::small_world();
    EXPECT_EQ(SimulatedTour(thin).path().poses().size(), tour.path().poses().size());
}

}  // namespace
}  // namespace hitos
