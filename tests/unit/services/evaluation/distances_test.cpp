// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/distances.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;

constexpr double kDegree = kPi / 180.0;

LandmarkMap map_of(const std::vector<Recta>& lines) {
    LandmarkMap map;
    for (const Recta& line : lines) map.push_back({line});
    return map;
}

MeasuredDistance one(const LandmarkMap& map, const NamedDistance& distance) {
    return measure_distances(map, std::vector{distance}).front();
}

TEST(Distances, OfParallelLinesIsTheirDistanceWhereverThePointsLie) {
    // y = -1 and y = 2.06, written with either sign of rho.
    for (const Recta& south : {Recta{1.0, -kPi / 2.0}, Recta{-1.0, kPi / 2.0}}) {
        for (const double x : {-4.0, 0.0, 25.0}) {
            const MeasuredDistance row =
                one(map_of({south, {2.06, kPi / 2.0}, {4.0, 0.0}}), {"d", {x, -1.1}, {x, 1.9}});
            ASSERT_TRUE(row.slam_m);
            EXPECT_NEAR(*row.slam_m, 3.06, 1e-12);
            EXPECT_NEAR(*row.error_m(), 0.06, 1e-12);
            EXPECT_NEAR(*row.error_percent(), 2.0, 1e-9);
            EXPECT_EQ(row.line_a, 0);
            EXPECT_EQ(row.line_b, 1);
        }
    }
    // Too short is an error of the same size, with the other sign in metres.
    const MeasuredDistance shorter =
        one(map_of({{0.0, kPi / 2.0}, {1.9, kPi / 2.0}}), {"d", {0.0, 0.0}, {0.0, 2.0}});
    EXPECT_NEAR(*shorter.error_m(), -0.1, 1e-12);
    EXPECT_NEAR(*shorter.error_percent(), 5.0, 1e-9);
}

TEST(Distances, AShortOneIsNotMeasuredBetweenTheWallsAroundIt) {
    // Two points 0.2 m apart, a wall 0.15 m off each: nearer than 0.5 m, but not half as near as
    // the points are to each other.
    const MeasuredDistance row =
        one(map_of({{0.85, kPi / 2.0}, {1.35, kPi / 2.0}}), {"d", {0.0, 1.0}, {0.0, 1.2}});
    EXPECT_FALSE(row.slam_m);
    EXPECT_EQ(row.missing, "no line across it within 0.1 m of either point");
}

TEST(Distances, TreatsBothLinesAlikeWhereTheyAreNotParallel) {
    // x = 0, and a line through (2, 0) turned by 2 degrees.
    const Recta upright{0.0, 0.0};
    const Recta slanted = normalized({2.0 * std::cos(2.0 * kDegree), 2.0 * kDegree});
    const LandmarkMap map = map_of({upright, slanted});
    const Point2 a{0.0, 1.0};
    const Point2 b{2.0, 1.0};
    const MeasuredDistance there = one(map, {"d", a, b});
    const MeasuredDistance back = one(map, {"d", b, a});
    ASSERT_TRUE(there.slam_m && back.slam_m);
    EXPECT_DOUBLE_EQ(*there.slam_m, *back.slam_m);
    // By hand: (0, 1) to the slanted line; the foot of (2, 1) on it to x = 0.
    const double c = std::cos(2.0 * kDegree);
    const double s = std::sin(2.0 * kDegree);
    const double from_a = 2.0 * c - s;
    const double from_b = 2.0 - s * c;
    EXPECT_NEAR(*there.slam_m, (from_a + from_b) / 2.0, 1e-12);
}

TEST(Distances, TakesTheNearestLineOfTheRightDirection) {
    const Recta far_off{2.4, kPi / 2.0};
    const Recta near_by{1.9, kPi / 2.0};
    const Recta other_way{0.0, 0.0};  // passes through both points
    const Recta turned = normalized({2.0, kPi / 2.0 + 20.0 * kDegree});
    const Recta floor{0.1, kPi / 2.0};
    const MeasuredDistance row =
        one(map_of({other_way, turned, far_off, near_by, floor}), {"d", {0.0, 0.0}, {0.0, 2.0}});
    EXPECT_EQ(row.line_a, 4);
    EXPECT_EQ(row.line_b, 3);
    EXPECT_NEAR(*row.slam_m, 1.8, 1e-12);
    // A corner in a map is no line, and does not change the numbers of the others.
    LandmarkMap with_corner = map_of({floor, near_by});
    with_corner.insert(with_corner.begin(), {Esquina{0.0, 2.0}});
    EXPECT_EQ(one(with_corner, {"d", {0.0, 0.0}, {0.0, 2.0}}).line_b, 2);
}

TEST(Distances, SaysWhereALineIsMissing) {
    const NamedDistance d{"d", {0.0, 0.0}, {0.0, 1.0}};
    const auto missing = [&](const std::vector<Recta>& lines) {
        const MeasuredDistance row = one(map_of(lines), d);
        EXPECT_FALSE(row.slam_m || row.error_m() || row.error_percent());
        return row.missing;
    };
    EXPECT_THAT(missing({}), HasSubstr("either point"));
    EXPECT_THAT(missing({{0.0, kPi / 2.0}}),
                HasSubstr("no line across it within 0.5 m of its second point"));
    EXPECT_THAT(missing({{1.0, kPi / 2.0}, {1.6, kPi / 2.0}}), HasSubstr("its first point"));
    EXPECT_THAT(missing({{0.5, kPi / 2.0}}), HasSubstr("one line is nearest to both"));
    const auto rows = measure_distances(map_of({{0.0, kPi / 2.0}}), std::vector{d});
    EXPECT_THAT(distance_table(rows),
                HasSubstr("no line across it within 0.5 m of its second point"));
    EXPECT_EQ(distances_csv(rows),
              "name,true_m,slam_m,error_m,error_percent,line_a,line_b\nd,1.000000,,,,1,\n");
}

TEST(Distances, TableAndCsvHoldThePapersRow) {
    const auto rows = measure_distances(
        map_of({{0.0, kPi / 2.0}, {2.066, kPi / 2.0}, {1.002, kPi / 2.0}}),
        std::vector<NamedDistance>{{"d4", {1.0, 0.0}, {1.0, 2.0}}, {"d1", {0.0, 0.0}, {0.0, 1.0}}});
    EXPECT_EQ(distance_table(rows),
              "distance  SLAM [m]  true [m]  error [m]  error [%]\n"
              "d4           2.066     2.000      0.066       3.30\n"
              "d1           1.002     1.000      0.002       0.20\n"
              "mean |e|                          0.034       1.75\n");
    EXPECT_EQ(distances_csv(rows),
              "name,true_m,slam_m,error_m,error_percent,line_a,line_b\n"
              "d4,2.000000,2.066000,0.066000,3.300000,1,2\n"
              "d1,1.000000,1.002000,0.002000,0.200000,1,3\n");
}

TEST(Distances, ANameIsNoFormulaOfASpreadsheet) {
    const NamedDistance distance{"=1+cmd()", {0, 0}, {1, 0}};
    EXPECT_THAT(distances_csv(measure_distances({}, {&distance, 1})), HasSubstr("\n'=1+cmd(),1.0"));
}

TEST(Distances, ReadsItsFileAndNamesMistakes) {
    const auto read =
        parse_distances("# walls\n\nd1 0 1 0 2 # a comment\r\n  width\t-1 0.5 2e0 0.5\n", "f");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].name, "d1");
    EXPECT_DOUBLE_EQ(read[0].true_m(), 1.0);
    EXPECT_EQ(read[1].b, (Point2{2.0, 0.5}));
    const auto message = [](const char* text) {
        return message_of<FormatError>([&] { static_cast<void>(parse_distances(text, "f")); });
    };
    EXPECT_THAT(message("# none\n"), HasSubstr("f: no distance in the file; expected 5 fields"));
    EXPECT_THAT(message("d 1 2 3\n"), HasSubstr("f:1: found 4 fields; expected 5"));
    EXPECT_THAT(message("d 1 2 3 inf\n"), HasSubstr("y2 is \"inf\"; expected a finite number"));
    EXPECT_THAT(message("d 0 0 1 1\nd 1e308 1 2 3\n"),
                HasSubstr("f:2: x1 is \"1e308\"; expected a number from -1e+12 to 1e+12"));
    EXPECT_THAT(message("d 1 2 1 2\n"), HasSubstr("0 m apart"));
    EXPECT_THAT(message("a,b 1 2 1 3\n"), HasSubstr("expected a word without commas"));
    EXPECT_THAT(message("d 1 2 1 3\nd 1 2 1 4\n"), HasSubstr("f:2: \"d\" stands twice"));
}

}  // namespace
}  // namespace hitos
