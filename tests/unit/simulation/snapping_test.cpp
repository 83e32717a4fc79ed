// SPDX-License-Identifier: GPL-3.0-or-later
// Where a drawn point is meant to be.
#include "hitos/simulation/text/snapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hitos {
namespace {

const std::vector<WallSegment> kSnapWalls = {{{0.0, 0.0}, {4.03, 0.0}, 1, 1},
                                             {{4.03, 0.0}, {4.03, 3.0}, 1, 1}};

Snapped snapped(const Point2& cursor, const SnapFrom& from = {}, const SnapOptions& options = {}) {
    return snap(kSnapWalls, {}, cursor, from, options);
}

void expect_at(const Snapped& found, SnappedTo to, double x, double y) {
    EXPECT_EQ(found.to, to);
    EXPECT_DOUBLE_EQ(found.at.x, x);
    EXPECT_DOUBLE_EQ(found.at.y, y);
}

TEST(Snapping, EndsComeFirst) {
    expect_at(snapped({4.1, 0.1}), SnappedTo::end, 4.03, 0.0);
    const std::vector<Point2> drawn = {{1.234567891, 2.0}};
    const Snapped own = snap(kSnapWalls, drawn, {1.3, 2.1}, {}, {});
    EXPECT_EQ(own.to, SnappedTo::end);
    EXPECT_EQ(own.at, drawn[0]);  // to the last bit
    // Of two the nearer one.
    const std::vector<Point2> two = {{1.0, 2.0}, {1.1, 2.0}};
    EXPECT_EQ(snap({}, two, {1.06, 2.0}, {}, {}).at, two[1]);
}

TEST(Snapping, WallsAndGrid) {
    expect_at(snapped({1.52, 0.11}), SnappedTo::wall, 1.5, 0.0);
    expect_at(snapped({1.52, 0.91}), SnappedTo::grid, 1.5, 0.9);
    expect_at(snapped({1.52, 0.11}, {}, {0.1, 0.2, false, true}), SnappedTo::grid, 1.5, 0.1);
    expect_at(snapped({1.52, 0.91}, {}, {0.0, 0.2, false, true}), SnappedTo::nothing, 1.52, 0.91);
    expect_at(snapped({-0.04, -0.96}), SnappedTo::grid, 0.0, -1.0);
    EXPECT_FALSE(std::signbit(snapped({-0.04, -0.96}).at.x));
}

TEST(Snapping, RightAnglesToTheAxesAndToThePieceBefore) {
    expect_at(snapped({1.26, 1.58}, {Point2{-1.0, 1.5}, {}}), SnappedTo::right_angle, 1.3, 1.5);
    expect_at(snapped({-0.95, 2.44}, {Point2{-1.0, 1.5}, {}}), SnappedTo::right_angle, -1.0, 2.4);
    // A piece at 30 degrees: across it.
    const double c = std::cos(kPi / 6.0);
    const double s = 0.5;
    const Point2 before{-3.0, 1.0};
    const Point2 point{before.x + 2.0 * c, before.y + 2.0 * s};
    const Snapped across = snapped({point.x - 1.03 * s, point.y + 1.03 * c}, {point, before});
    EXPECT_EQ(across.to, SnappedTo::right_angle);
    EXPECT_NEAR(std::hypot(across.at.x - point.x, across.at.y - point.y), 1.0, 2e-6);
    EXPECT_NEAR((across.at.x - point.x) * c + (across.at.y - point.y) * s, 0.0, 2e-6);
    // Not asked for.
    expect_at(snapped({1.26, 1.58}, {Point2{-1.0, 1.5}, {}}, {0.1, 0.2, true, false}),
              SnappedTo::grid, 1.3, 1.6);
}

TEST(Snapping, ARightAngleEndsAtAWallThatIsThere) {
    // The grid would end it 3 cm before the wall at x = 4.03.
    expect_at(snapped({4.0, 1.52}, {Point2{2.0, 1.5}, {}}), SnappedTo::wall, 4.03, 1.5);
    // The wall behind is not meant.
    expect_at(snapped({4.5, 1.52}, {Point2{5.0, 1.5}, {}}), SnappedTo::right_angle, 4.5, 1.5);
}

}  // namespace
}  // namespace hitos
