// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "drawn_scan.hpp"

namespace hitos {
namespace {

PointMap map_of(const Walls& walls, const Pose& pose) {
    PointMap map;
    map.begin({pose.x, pose.y}, 30.0);
    map.add(test::drawn_points(walls, pose), pose, 0);
    map.build();
    return map;
}

/// The greatest score of all cells and angles of the window, each tried.
double tried(const std::vector<SurfacePoint>& points, const CorrelationMap& map, const Pose& centre,
             const SearchWindow& window) {
    double far = 1.0;
    for (const SurfacePoint& p : points) {
        far = std::max(far, static_cast<double>(std::hypot(p.x, p.y)));
    }
    const double step = std::clamp(0.12 / std::min(far, 10.0), 0.012, 0.03);
    const int angles = static_cast<int>(std::ceil(window.heading_rad / step));
    const int reach = static_cast<int>(std::ceil(window.position_m / CorrelationMap::kCell));
    int best = 0;
    for (int a = -angles; a <= angles; ++a) {
        std::vector<CorrelationMap::Cell> cells;
        for (const SurfacePoint& p : points) {
            const Point2 at = transform({centre.x, centre.y, centre.theta + a * step},
                                        Point2{static_cast<double>(p.x), static_cast<double>(p.y)});
            cells.push_back(map.cell(at.x, at.y));
        }
        const CorrelationMap::Pattern pattern(std::move(cells));
        for (int x = -reach; x <= reach; ++x) {
            for (int y = -reach; y <= reach; ++y) best = std::max(best, map.sum(pattern, x, y, 0));
        }
    }
    return best / 255.0 / static_cast<double>(points.size());
}

TEST(Correlation, ASumIsExactUnlessItIsTooSmall) {
    const Walls room = test::recess_room();
    const PointMap map = map_of(room, {0.0, 0.0, 0.3});
    const CorrelationMap picture(map, 20.0, 2);
    std::vector<CorrelationMap::Cell> cells;
    for (const SurfacePoint& p : test::drawn_points(room, {0.2, -0.1, 0.5})) {
        const Point2 at =
            transform({0.2, -0.1, 0.5}, Point2{static_cast<double>(p.x), static_cast<double>(p.y)});
        cells.push_back(picture.cell(at.x, at.y));
    }
    ASSERT_GT(cells.size(), 128U);  // else there is nothing to leave out
    const CorrelationMap::Pattern pattern(std::move(cells));
    int ended_early = 0;
    for (int x = -20; x <= 20; x += 4) {
        for (int level = 0; level <= 2; ++level) {
            const int exact = picture.sum(pattern, x, 0, level);
            for (const int least : {1, exact, exact + 1, 20000, 60000}) {
                const int told = picture.sum(pattern, x, 0, level, least);
                if (exact >= least) {
                    EXPECT_EQ(told, exact);
                } else {
                    EXPECT_LT(told, least);
                    if (told < exact) ++ended_early;
                }
            }
        }
    }
    EXPECT_GT(ended_early, 0);
}

TEST(Correlation, QuartersAreTheSumsOfTheirCellsInTheMapAndBeyondItsEdge) {
    const Walls room = test::recess_room();
    const CorrelationMap picture(map_of(room, {}), 20.0, 3);
    std::vector<CorrelationMap::Cell> cells;
    std::vector<CorrelationMap::Pattern> single;
    for (const SurfacePoint& p : test::drawn_points(room, {})) {
        cells.push_back(picture.cell(static_cast<double>(p.x), static_cast<double>(p.y)));
        single.emplace_back(std::vector{cells.back()});
    }
    const CorrelationMap::Pattern all(std::move(cells));
    const auto summed = [&](int x, int y, int level) {
        int sum = 0;
        for (const CorrelationMap::Pattern& one : single) sum += picture.sum(one, x, y, level);
        return sum;
    };
    // Where all lies in the map its edges are not looked at.
    int nothing = 0;
    for (int x = -300; x <= 300; x += 23) {
        for (int y = -300; y <= 300; y += 19) {
            for (int level = 0; level <= 3; ++level) {
                const int side = 1 << level;
                const std::array<int, 4> four = picture.quarters(all, x, y, level, 0);
                EXPECT_EQ(four[0], summed(x, y, level));
                EXPECT_EQ(four[1], summed(x, y + side, level));
                EXPECT_EQ(four[2], summed(x + side, y, level));
                EXPECT_EQ(four[3], summed(x + side, y + side, level));
                if (four[0] == 0) ++nothing;
            }
        }
    }
    EXPECT_GT(nothing, 0);
    EXPECT_GT(summed(0, 0, 0), 255 * static_cast<int>(single.size()) / 2);
}

TEST(Correlation, ALatticeBoundsTheSumsOfARowOfSquaresInTheMapAndBeyondItsEdge) {
    const Walls room = test::recess_room();
    PointMap point;  // narrower than a square
    point.begin({0.0, 0.0}, 30.0);
    point.add(std::vector{test::drawn_points(room, {}).front()}, {}, 0);
    point.build();
    const auto holds = [&](const CorrelationMap& picture) {
        const SquareLattice lattice(picture);
        const int level = picture.levels();
        const int side = 1 << level;
        std::vector<CorrelationMap::Cell> cells;
        for (const SurfacePoint& p : test::drawn_points(room, {0.2, -0.1, 0.5})) {
            if (cells.size() < SquareLattice::kMostCells)
                cells.push_back(picture.cell(static_cast<double>(p.x), static_cast<double>(p.y)));
        }
        const CorrelationMap::Pattern all(cells);
        const CorrelationMap::Pattern one({cells.front()});
        int nothing = 0;
        for (int y = -300; y <= 300; y += 17) {
            for (int x = -700; x <= 300; x += 61) {
                const SquareLattice::Sums bounds = lattice.bounds(all, x, y);
                const SquareLattice::Sums of_one = lattice.bounds(one, x, y);
                for (int i = 0; i < static_cast<int>(SquareLattice::kAcross); ++i) {
                    const auto place = static_cast<std::size_t>(i);
                    const int sum = picture.sum(all, x + i * side, y, level);
                    EXPECT_GE(bounds[place], sum);
                    if (bounds[place] == 0) ++nothing;
                    // No cell reaches further than what four cells of the picture are joined to.
                    int most = 0;
                    for (int v = -3; v <= 3; ++v) {
                        for (int u = -3; u <= 3; ++u)
                            most = std::max(most, picture.sum(one, x + i * side + u, y + v, level));
                    }
                    EXPECT_LE(of_one[place], most);
                }
            }
        }
        EXPECT_GT(nothing, 0);
    };
    for (const int levels : {2, 3, 4}) {
        holds(CorrelationMap(map_of(room, {}), 20.0, levels));
        holds(CorrelationMap(point, 20.0, levels));
    }
}

TEST(Correlation, IsTheBestOfAllThatCouldBeTried) {
    const Walls room = test::recess_room();
    const PointMap map = map_of(room, {0.0, 0.0, 0.3});
    for (const int levels : {1, 3, 4}) {
        const CorrelationMap picture(map, 20.0, levels);
        for (const Pose& off :
             {Pose{0.0, 0.0, 0.0}, Pose{0.83, -0.4, 0.2}, Pose{-0.9, 0.7, -0.3}}) {
            const std::vector<SurfacePoint> scan = test::drawn_points(room, {0.2, -0.1, 0.5});
            const Pose centre{0.2 + off.x, -0.1 + off.y, 0.5 + off.theta};
            const SearchWindow window{1.1, 0.35};
            const auto found = correlate(scan, picture, centre, window, 0.3);
            ASSERT_TRUE(found);
            EXPECT_DOUBLE_EQ(found->score, tried(scan, picture, centre, window));
            EXPECT_NEAR(found->pose.x, 0.2, 0.15);
            EXPECT_NEAR(found->pose.y, -0.1, 0.15);
            EXPECT_NEAR(found->pose.theta, 0.5, 0.03);
        }
    }
}

TEST(Correlation, SaysNothingBelowTheLeastScore) {
    const PointMap map = map_of(test::recess_room(), {});
    const CorrelationMap picture(map, 20.0, 3);
    const std::vector<SurfacePoint> other =
        test::drawn_points(test::closed({{-9, -8}, {9, -1}, {5, 7}}), {});
    const SearchWindow window{0.5, 0.1};
    const double best = tried(other, picture, {}, window);
    EXPECT_FALSE(correlate(other, picture, {}, window, best + 0.02));
    EXPECT_TRUE(correlate(other, picture, {}, window, best - 0.02));
}

TEST(Correlation, FindsAllPlacesThatAreAlikeAndNoneElsewhere) {
    const Walls room = test::recess_room();
    const Pose second{20.0, 3.0, 2.0};
    PointMap map;
    map.begin({10.0, 0.0}, 40.0);
    map.add(test::drawn_points(room, {}), {}, 0);
    map.add(test::drawn_points(room, {}), second, 1);
    map.build();
    const CorrelationMap picture(map, 40.0, 4);
    const SquareLattice squares(picture);
    const Pose inside{0.2, -0.1, 0.3};
    const std::vector<SurfacePoint> scan = test::drawn_points(room, inside);
    const auto near = [](const Pose& a, const Pose& b) {
        return std::hypot(a.x - b.x, a.y - b.y) < 0.15 &&
               std::abs(wrap_angle(a.theta - b.theta)) < 0.03;
    };
    const PlacesWanted wanted{.least_score = 0.5};
    const std::vector<Point2> everywhere{{0.0, 0.0}, {20.0, 3.0}, {10.0, -15.0}};
    const std::vector<Correlation> both =
        best_places(scan, picture, squares, everywhere, wanted).places;
    ASSERT_GE(both.size(), 2U);
    for (const Pose& pose : {inside, compose(second, inside)}) {
        EXPECT_TRUE(near(both[0].pose, pose) || near(both[1].pose, pose));
    }
    EXPECT_GT(both[0].score, 0.8);
    for (std::size_t i = 1; i < both.size(); ++i) {
        EXPECT_LE(both[i].score, both[i - 1].score);
        EXPECT_GE(both[i].score, 0.8 * both[0].score);
    }

    const std::vector<Correlation> one =
        best_places(scan, picture, squares, std::vector<Point2>{{19.0, 4.0}}, wanted).places;
    ASSERT_FALSE(one.empty());
    EXPECT_TRUE(near(one[0].pose, compose(second, inside)));
    for (const Correlation& place : one) {
        EXPECT_LT(std::abs(place.pose.x - 19.0), 4.0);  // within 3 m, and a square's side
    }
    const BestPlaces none =
        best_places(scan, picture, squares, std::vector<Point2>{{10.0, -15.0}}, wanted);
    EXPECT_TRUE(none.places.empty());
    EXPECT_TRUE(none.all);
}

}  // namespace
}  // namespace hitos
