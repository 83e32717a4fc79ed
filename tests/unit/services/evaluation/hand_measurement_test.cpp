// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/hand_measurement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;
using Kind = PickedPlace::Kind;

constexpr double kHandDegree = kPi / 180.0;

// A room of 4 x 3 m with a corner at the origin.
const ICaracteristica kWest{Recta{0.0, 0.0}};
const ICaracteristica kEast{Recta{4.0, 0.0}};
const ICaracteristica kSouth{Recta{0.0, kPi / 2.0}};
const ICaracteristica kNorthWall{Recta{3.0, kPi / 2.0}};
const ICaracteristica kCorner{Esquina{0.0, 0.0}};
const LandmarkMap kRoom{kWest, kEast, kSouth, kNorthWall, kCorner};

PickedPlace at(double x, double y) {
    return {Kind::point, {x, y}};
}

std::optional<HandMeasurement> picked(Quantity wanted, const std::vector<PickedPlace>& places) {
    return measurement_of(wanted, places);
}

double value(const LandmarkMap& map, const std::optional<HandMeasurement>& measurement) {
    return measure(map, measurement.value()).value.value();
}

TEST(HandMeasurement, TakesEveryPairOfPlacesAsItsKindsAskFor) {
    const PickedPlace corner = place_on(kCorner, {0.1, 0.1});
    EXPECT_EQ(corner, (PickedPlace{Kind::corner, {0.0, 0.0}}));
    const PickedPlace east = place_on(kEast, {4.2, 1.0});
    EXPECT_EQ(east, (PickedPlace{Kind::wall, {4.0, 1.0}, 0.0}));
    EXPECT_NEAR(value(kRoom, picked(Quantity::distance, {at(1.0, 1.0), at(4.0, 5.0)})), 5.0, 1e-12);
    EXPECT_NEAR(value(kRoom, picked(Quantity::distance, {corner, at(3.0, 4.0)})), 5.0, 1e-12);
    // Square to the wall, whichever comes first.
    EXPECT_NEAR(value(kRoom, picked(Quantity::distance, {corner, east})), 4.0, 1e-12);
    EXPECT_NEAR(value(kRoom, picked(Quantity::distance, {east, at(1.5, 2.0)})), 2.5, 1e-12);
    EXPECT_FALSE(picked(Quantity::distance, {corner}));
    // The same wall twice: along it.
    const PickedPlace below = place_on(kEast, {4.0, 0.25});
    EXPECT_NEAR(value(kRoom, picked(Quantity::distance, {east, below})), 0.75, 1e-12);
}

TEST(HandMeasurement, WallToWallIsTheDistanceOfTheFile) {
    const auto made =
        picked(Quantity::distance, {place_on(kWest, {0.2, 2.5}), place_on(kEast, {3.9, 0.5})});
    ASSERT_TRUE(made && made->between_walls());
    // Opposite each other, whatever was clicked.
    EXPECT_EQ(made->places[0].at, (Point2{0.0, 1.5}));
    EXPECT_EQ(made->places[1].at, (Point2{4.0, 1.5}));
    LandmarkMap later = kRoom;
    later[1] = {Recta{4.1, 1.0 * kHandDegree}};
    const std::vector wanted{NamedDistance{"d", made->places[0].at, made->places[1].at}};
    EXPECT_DOUBLE_EQ(value(later, made), *measure_distances(later, wanted).front().slam_m);
    // A map without the wall.
    later.erase(later.begin());
    EXPECT_FALSE(measure(later, *made).value);
    EXPECT_TRUE(measure(later, *made).line.empty());
}

TEST(HandMeasurement, AnglesAreOfTwoWallsOrThreePoints) {
    const PickedPlace west = place_on(kWest, {0.0, 2.0});
    const PickedPlace south = place_on(kSouth, {3.0, 0.0});
    // Walls that are not parallel have no distance.
    for (const Quantity wanted : {Quantity::distance, Quantity::angle}) {
        const auto made = picked(wanted, {west, south});
        ASSERT_TRUE(made);
        EXPECT_EQ(made->quantity, Quantity::angle);
        EXPECT_NEAR(value(kRoom, made), 90.0 * kHandDegree, 1e-12);
        const MeasuredValue found = measure(kRoom, *made);
        ASSERT_EQ(found.line.size(), 3U);
        EXPECT_NEAR(std::hypot(found.line[1].x, found.line[1].y), 0.0, 1e-12);
    }
    // An obtuse one stays obtuse: the wall from (0, 0) up to the left, 100 degrees from the south.
    const ICaracteristica slanted{normalized({0.0, 10.0 * kHandDegree})};
    const LandmarkMap map{slanted, kSouth};
    const PickedPlace up = place_on(
        slanted, {-2.0 * std::sin(10.0 * kHandDegree), 2.0 * std::cos(10.0 * kHandDegree)});
    EXPECT_NEAR(value(map, picked(Quantity::angle, {up, south})), 100.0 * kHandDegree, 1e-9);
    EXPECT_NEAR(value(map, picked(Quantity::angle, {up, place_on(kSouth, {-3.0, 0.0})})),
                80.0 * kHandDegree, 1e-9);
    // They meet where both are: x = 2, and 3 m from the origin at 60 degrees.
    const ICaracteristica right{Recta{2.0, 0.0}};
    const ICaracteristica leaning{Recta{3.0, 60.0 * kHandDegree}};
    const LandmarkMap pair{right, leaning};
    const MeasuredValue met = measure(
        pair, picked(Quantity::angle, {place_on(right, {2.0, 0.0}), place_on(leaning, {6.0, 0.0})})
                  .value());
    ASSERT_EQ(met.line.size(), 3U);
    EXPECT_NEAR(met.line[1].x, 2.0, 1e-12);
    EXPECT_NEAR(met.line[1].y, 4.0 / std::sqrt(3.0), 1e-12);
    // Parallel ones meet nowhere.
    EXPECT_NEAR(value(kRoom, picked(Quantity::angle, {west, place_on(kEast, {4.0, 2.0})})), 0.0,
                1e-12);
    // The vertex is the second; a wall among three is a point of it.
    EXPECT_FALSE(picked(Quantity::angle, {at(1.0, 0.0), at(0.0, 0.0)}));
    EXPECT_NEAR(
        value(kRoom, picked(Quantity::angle, {at(1.0, 0.0), place_on(kCorner, {}), at(2.0, 2.0)})),
        45.0 * kHandDegree, 1e-12);
    EXPECT_NEAR(value(kRoom, picked(Quantity::angle, {at(1.0, 2.0), at(0.0, 1.0), west})),
                45.0 * kHandDegree, 1e-12);
    EXPECT_FALSE(
        measure(kRoom, picked(Quantity::angle, {at(1.0, 0.0), at(1.0, 0.0), at(2.0, 2.0)}).value())
            .value);
}

TEST(HandMeasurement, FollowsWhatWasPickedHalfAMetreFar) {
    const auto to_corner = picked(Quantity::distance, {place_on(kCorner, {}), at(3.0, 4.0)});
    LandmarkMap later = kRoom;
    later[4] = {Esquina{0.3, 0.0}};
    EXPECT_NEAR(value(later, to_corner), std::hypot(2.7, 4.0), 1e-12);
    later[4] = {Esquina{0.51, 0.0}};
    EXPECT_FALSE(measure(later, *to_corner).value);
    const auto to_wall = picked(Quantity::distance, {at(1.0, 1.0), place_on(kEast, {4.0, 1.0})});
    later[1] = {Recta{4.4, 0.0}};
    EXPECT_NEAR(value(later, to_wall), 3.4, 1e-12);
    later[1] = {Recta{4.6, 0.0}};
    EXPECT_FALSE(measure(later, *to_wall).value);
}

TEST(HandMeasurement, TheTruthIsTheUsersElseTheReferenceMaps) {
    auto made =
        picked(Quantity::distance, {place_on(kWest, {0.0, 1.0}), place_on(kEast, {4.0, 1.0})});
    LandmarkMap reference = kRoom;
    reference[1] = {Recta{4.2, 0.0}};
    EXPECT_FALSE(true_value(*made, nullptr));
    EXPECT_NEAR(true_value(*made, &reference).value(), 4.2, 1e-12);
    made->true_value = 4.1;
    EXPECT_EQ(true_value(*made, &reference), 4.1);
    // No map knows where a free point truly is.
    EXPECT_FALSE(true_value(*picked(Quantity::distance, {at(0.0, 0.0), at(1.0, 0.0)}), &reference));
}

TEST(HandMeasurement, ADistancesFileHoldsItToTheLastBit) {
    auto made = picked(Quantity::distance,
                       {place_on(kWest, {0.0, 1.0 / 3.0}), place_on(kEast, {4.0, 1.0})});
    made->name = "hall";
    const std::vector written{named_distance(*made, 4.1),
                              NamedDistance{"d2", {0.1, 0.2}, {0.3, 1.0 / 7.0}}};
    EXPECT_NEAR(written[0].true_m(), 4.1, 1e-12);
    EXPECT_NEAR(written[0].a.x, -0.05, 1e-12);
    const auto read = parse_distances(distances_text(written), "f");
    EXPECT_EQ(read, written);
    // And as it was read it is written again.
    const HandMeasurement again = measurement_of(read[0]);
    EXPECT_TRUE(again.between_walls());
    EXPECT_EQ(named_distance(again, again.true_value.value()), written[0]);
    EXPECT_NEAR(measure(kRoom, again).value.value(), 4.0, 1e-12);
}

TEST(HandMeasurement, WhatNoFileCouldHoldIsRefused) {
    const auto message = [](const std::vector<NamedDistance>& distances) {
        return message_of<Error>([&] { static_cast<void>(distances_text(distances)); });
    };
    EXPECT_THAT(message({}), HasSubstr("no distance"));
    for (const char* name : {"", "two words", "a,b", "a\"b", "#1", " a"}) {
        EXPECT_FALSE(is_distance_name(name)) << name;
        EXPECT_THAT(message({{name, {0.0, 0.0}, {1.0, 0.0}}}), HasSubstr("expected a word"));
    }
    EXPECT_TRUE(is_distance_name("pasillo-ñ_1"));
    EXPECT_THAT(message({{"d", {0.0, 0.0}, {1.0, 0.0}}, {"d", {0.0, 0.0}, {2.0, 0.0}}}),
                HasSubstr("two distances are named \"d\""));
    EXPECT_THAT(message({{"d", {0.0, 0.0}, {1e-4, 0.0}}}), HasSubstr("at least 0.001 m"));
}

}  // namespace
}  // namespace hitos
