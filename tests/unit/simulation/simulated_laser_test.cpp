// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/laser/simulated_laser.hpp"

#include <cmath>
#include <random>

#include "worlds.hpp"

namespace hitos {
namespace {

/// Every ray against every wall, by the signs of the ends' distances from the ray and the wall's
/// own line equation, in long double.
double oracle(const std::vector<WallSegment>& walls, const Pose& laser, double angle, double most) {
    using Real = long double;
    const auto real = [](double value) { return static_cast<Real>(value); };
    const Real bearing = real(laser.theta) + real(angle);
    const Real c = std::cos(bearing);
    const Real s = std::sin(bearing);
    auto best = std::numeric_limits<Real>::infinity();
    for (const WallSegment& wall : walls) {
        const Real ax = real(wall.a.x) - real(laser.x);
        const Real ay = real(wall.a.y) - real(laser.y);
        const Real bx = real(wall.b.x) - real(laser.x);
        const Real by = real(wall.b.y) - real(laser.y);
        const Real side_a = c * ay - s * ax;
        const Real side_b = c * by - s * bx;
        if ((side_a > 0) == (side_b > 0)) continue;
        const Real t = side_a / (side_a - side_b);
        const Real range = (ax + t * (bx - ax)) * c + (ay + t * (by - ay)) * s;
        if (range >= 0 && range < best) best = range;
    }
    return best <= real(most) ? static_cast<double>(best) : std::numeric_limits<double>::infinity();
}

Fan fan(double from, double to, std::uint32_t count, double most = 8.0, Pose mount = {}) {
    Fan result;
    result.min_angle_rad = from;
    result.max_angle_rad = to;
    result.count = count;
    result.max_range_m = most;
    result.pose_robot_laser = mount;
    return result;
}

TEST(SimulatedLaser, AgreesWithASlowOracleInRandomWorlds) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-10.0, 10.0);
    std::uniform_real_distribution<double> angle(-kPi, kPi);
    const std::vector<Fan> fans = {fan(-kPi / 2, kPi / 2, 181),
                                   fan(-kPi, kPi, 361, 30.0),
                                   fan(-kPi / 2, kPi / 2, 181, 8.0, {0.3, -0.1, 2.0}),
                                   fan(-0.2, 0.3, 2, 30.0),
                                   fan(kPi / 2, -kPi / 2, 181),
                                   fan(2.0, 2.0 - 2.0 * kPi, 361, 30.0)};
    int compared = 0;
    int hits = 0;
    int differ = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<WallSegment> walls;
        walls.reserve(12);
        for (int i = 0; i < 12; ++i) {
            walls.push_back({{place(random), place(random)}, {place(random), place(random)}, i, 0});
        }
        const Pose robot{place(random), place(random), angle(random)};
        for (const Fan& f : fans) {
            std::vector<RayHit> found;
            SimulatedLaser(walls, f).cast(robot, found);
            ASSERT_EQ(found.size(), f.count);
            const Pose laser = compose(robot, f.pose_robot_laser);
            for (std::uint32_t i = 0; i < f.count; ++i) {
                const double ray =
                    f.min_angle_rad + i * (f.max_angle_rad - f.min_angle_rad) / (f.count - 1);
                const double expected = oracle(walls, laser, ray, f.max_range_m);
                ++compared;
                if (std::isfinite(expected)) ++hits;
                const bool same = std::isfinite(expected)
                                      ? std::abs(found[i].range_m - expected) < 1e-9
                                      : !std::isfinite(found[i].range_m);
                differ += same ? 0 : 1;
            }
        }
    }
    EXPECT_EQ(differ, 0) << "of " << compared;
    EXPECT_GT(hits, compared / 4);
}

TEST(SimulatedLaser, LeaksAtNoJointOfTwoWalls) {
    const World world = test::small_world();
    // Rays aimed at the corners themselves, from many places.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1.5, 3.5);
    for (int round = 0; round < 500; ++round) {
        const Point2 at{place(random), place(random)};
        for (const WallSegment& wall : world.walls) {
            const double to = std::atan2(wall.a.y - at.y, wall.a.x - at.x);
            std::vector<RayHit> hits;
            SimulatedLaser(world.walls, fan(0.0, 1.0, 2, 30.0)).cast({at.x, at.y, to}, hits);
            EXPECT_NEAR(hits[0].range_m, std::hypot(wall.a.x - at.x, wall.a.y - at.y), 1e-9);
        }
    }
}

TEST(SimulatedLaser, NamesTheWallAndKeepsToTheGreatestRange) {
    const std::vector<WallSegment> walls = {{{5, -1}, {5, 1}, 1, 0}, {{3, 0.5}, {3, 2}, 2, 0}};
    std::vector<RayHit> hits;
    SimulatedLaser(walls, fan(-0.1, 0.3, 3, 5.0)).cast({}, hits);
    EXPECT_EQ(hits[0].segment, -1);  // 5 / cos(0.1) is beyond 5 m
    EXPECT_EQ(hits[1].segment, -1);
    EXPECT_EQ(hits[2].segment, 1);
    EXPECT_NEAR(hits[2].range_m, 3.0 / std::cos(0.3), 1e-12);
    SimulatedLaser(walls, fan(0.0, 0.3, 2, 5.0)).cast({}, hits);
    EXPECT_EQ(hits[0].segment, 0);
    EXPECT_DOUBLE_EQ(hits[0].range_m, 5.0);
}

TEST(SimulatedLaser, SeesTheEndOfAWallItLooksAlong) {
    std::vector<RayHit> hits;
    SimulatedLaser({{{4, 0}, {2, 0}, 1, 0}}, fan(0.0, 1.0, 2)).cast({}, hits);
    EXPECT_DOUBLE_EQ(hits[0].range_m, 2.0);
    EXPECT_EQ(hits[1].segment, -1);
    SimulatedLaser({{{-4, 0}, {-2, 0}, 1, 0}}, fan(0.0, 1.0, 2)).cast({}, hits);
    EXPECT_EQ(hits[0].segment, -1);
}

}  // namespace
}  // namespace hitos
