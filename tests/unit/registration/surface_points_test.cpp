// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_scan.hpp"

namespace hitos {
namespace {

TEST(SurfacePoints, NormalsStandOnTheWallsAndFaceTheLaser) {
    const Walls room = test::closed({{-3, -2}, {3, -2}, {3, 2}, {-3, 2}});
    const std::vector<SurfacePoint> points = test::drawn_points(room, {0.0, 0.0, 0.0});
    int with_normal = 0;
    for (const SurfacePoint& p : points) {
        if (!p.has_normal()) continue;
        ++with_normal;
        EXPECT_LT(p.nx * p.x + p.ny * p.y, 0.0F);
        EXPECT_NEAR(std::hypot(p.nx, p.ny), 1.0, 1e-5);
        const bool near_corner = std::abs(p.x) > 2.7F && std::abs(p.y) > 1.7F;
        if (near_corner) continue;
        const bool east = p.x > 2.99F;
        EXPECT_NEAR(east ? p.nx : p.ny * std::copysign(1.0F, p.y), -1.0F, 0.01F)
            << p.x << " " << p.y;
    }
    EXPECT_GT(with_normal, static_cast<int>(points.size()) * 9 / 10);
}

TEST(SurfacePoints, AThinPostHasNone) {
    Walls post = test::closed({{2.0, -0.02}, {2.04, -0.02}, {2.04, 0.02}, {2.0, 0.02}});
    for (const SurfacePoint& p : test::drawn_points(post, {})) EXPECT_FALSE(p.has_normal());
}

TEST(SurfacePoints, FansOfManyRaysKeepEverySecondOne) {
    const Walls room = test::recess_room();
    Scan scan = test::drawn_scan(room, {});
    std::vector<SurfacePoint> points;
    find_surface_points(scan, 80.0, points);
    EXPECT_EQ(points.size(), scan.points.size());
    scan.fan.count = 361;  // as if the other rays had seen nothing
    find_surface_points(scan, 80.0, points);
    EXPECT_EQ(points.size(), (scan.points.size() + 1) / 2);
}

TEST(SurfacePoints, ReadingsBeyondTheRangeAreLeftOut) {
    std::vector<SurfacePoint> points;
    find_surface_points(test::drawn_scan(test::recess_room(), {}), 4.0, points);
    EXPECT_FALSE(points.empty());
    for (const SurfacePoint& p : points) EXPECT_LT(std::hypot(p.x, p.y), 4.0F);
}

TEST(SurfacePoints, AClosedFanHasNoSeam) {
    // The wall behind is met by the first and the last ray.
    const Walls room = test::recess_room();
    const auto seen = [&](double first, double sign) {
        std::vector<SurfacePoint> points;
        const double turn = sign * 359.0 * kRadiansPerDegree;
        find_surface_points(test::drawn_scan(room, {}, {first, first + turn, 360, 30.0, {}}), 80.0,
                            points);
        std::sort(points.begin(), points.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
            return std::atan2(a.y, a.x) < std::atan2(b.y, b.x);
        });
        return points;
    };
    const std::vector<SurfacePoint> whole = seen(0.0, 1.0);
    EXPECT_GE(whole.size(), 180U);
    int behind = 0;
    for (const SurfacePoint& p : whole) {
        if (p.x > -3.9F || std::abs(p.y) > 1.0F) continue;
        ++behind;
        EXPECT_NEAR(p.nx, 1.0F, 1e-3F) << p.y;
    }
    EXPECT_GT(behind, 10);
    for (int first = 0; first < 360; first += 6) {  // even, as the rays that are kept
        for (const double sign : {1.0, -1.0}) {
            const std::vector<SurfacePoint> turned = seen(first * kRadiansPerDegree, sign);
            ASSERT_EQ(turned.size(), whole.size());
            // A ray at pi may be the first by its bearing, or the last.
            for (std::size_t i = 2; i + 2 < whole.size(); ++i) {
                ASSERT_NEAR(turned[i].nx, whole[i].nx, 1e-3F) << whole[i].x << " " << whole[i].y;
                ASSERT_NEAR(turned[i].ny, whole[i].ny, 1e-3F) << whole[i].x << " " << whole[i].y;
            }
        }
    }
}

}  // namespace
}  // namespace hitos
