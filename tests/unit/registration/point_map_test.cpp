// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_map.hpp"

#include <gtest/gtest.h>

#include <random>

namespace hitos {
namespace {

TEST(PointMap, FindsWhatTryingAllPointsFinds) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<float> place(-6.0F, 6.0F);
    for (const Point2 centre : {Point2{0.0, 0.0}, Point2{-5000.0, 12000.0}}) {
        PointMap map;
        map.begin(centre, 5.0);
        std::vector<SurfacePoint> points;
        for (int i = 0; i < 700; ++i) points.push_back({place(engine), place(engine)});
        map.add(points, {centre.x, centre.y, 0.0}, 7);
        map.build();
        for (std::size_t n = 0; n < map.size(); ++n) {
            const MapPoint& p = map.point(n);
            EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 5.0F);
            EXPECT_EQ(p.source, 7U);
        }
        for (int i = 0; i < 500; ++i) {
            const auto x = static_cast<double>(place(engine)) * 1.3;
            const auto y = static_cast<double>(place(engine)) * 1.3;
            for (const double radius : {0.2, 0.7, 3.0}) {
                double best = radius * radius;
                for (std::size_t n = 0; n < map.size(); ++n) {
                    const MapPoint& p = map.point(n);
                    best = std::min(best, std::pow(static_cast<double>(p.x) - x, 2.0) +
                                              std::pow(static_cast<double>(p.y) - y, 2.0));
                }
                double found = radius * radius;
                map.nearest(x, y, radius, &found);
                EXPECT_NEAR(found, best, 1e-4 * best + 1e-9);
            }
        }
    }
}

TEST(PointMap, OfPointsAsNearTheFirstOfTheRowIsTaken) {
    // Wherever one begins to look: in the bucket of the middle, from -0.1 on, lies the other one.
    PointMap map;
    map.begin({0.0, 0.0}, 5.0);
    map.add(std::vector<SurfacePoint>{{0.0625F, 0.0F}}, {}, 0);
    map.add(std::vector<SurfacePoint>{{-0.1875F, 0.0F}}, {}, 1);
    map.add(std::vector<SurfacePoint>{{-1.0F, 0.0F}}, {}, 2);
    map.build();
    const MapPoint* const nearest = map.nearest(-0.0625, 0.0, 1.0);
    ASSERT_NE(nearest, nullptr);
    EXPECT_EQ(nearest->source, 1U);
}

TEST(PointMap, AnEmptyMapHasNoNearest) {
    PointMap map;
    map.begin({1.0, 2.0}, 5.0);
    map.build();
    EXPECT_EQ(map.nearest(0.0, 0.0, 1.0), nullptr);
}

}  // namespace
}  // namespace hitos
