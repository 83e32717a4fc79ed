// SPDX-License-Identifier: GPL-3.0-or-later
// Distances and angles between places that a user picks in a map, and what other maps make of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hitos/services/evaluation/distances.hpp"

namespace hitos {

/// A place in the frame of the maps: a point of the plane, or the corner or wall that is there. In
/// another map it is the corner at most 0.5 m away, or the wall as nearest_line() finds it.
struct PickedPlace {
    enum class Kind { point, corner, wall };
    Kind kind = Kind::point;
    Point2 at;                ///< [m]; on the wall
    double normal_rad = 0.0;  ///< of a wall
    friend bool operator==(const PickedPlace&, const PickedPlace&) = default;
};

/// The corner, or the point of the wall nearest to where it was picked.
PickedPlace place_on(const ICaracteristica& landmark, const Point2& picked);

enum class Quantity { distance, angle };

/// A distance [m] has two places: between points and corners, from one to a wall and square to it,
/// or between two walls as measure_distances() takes it. An angle [rad] has two walls, or three
/// points or corners with the vertex second.
struct HandMeasurement {
    std::string name;
    Quantity quantity = Quantity::distance;
    std::vector<PickedPlace> places;
    std::optional<double> true_value;  ///< as the user knows it

    /// A distance that a distances file can hold.
    bool between_walls() const;
};

/// What is measured between the places that were picked, without a name; nothing while places are
/// missing. Walls that are more than kGreatestTurn from parallel have an angle, not a distance; of
/// parallel ones the places are put opposite each other. A wall picked twice is two points, and
/// three places are points.
std::optional<HandMeasurement> measurement_of(Quantity wanted, std::span<const PickedPlace> picked);

/// What a map makes of a measurement.
struct MeasuredValue {
    std::optional<double> value;  ///< [m] or [rad]; nothing where the map lacks a place
    /// To draw it: two ends; of an angle, where it has one, its vertex between them.
    std::vector<Point2> line;
};

/// Of two walls the angle at the point where they meet, towards the places that were picked.
MeasuredValue measure(const LandmarkMap& map, const HandMeasurement& measurement);

/// The user's, else what the reference map says; nothing where neither knows, as of free points.
std::optional<double> true_value(const HandMeasurement& measurement, const LandmarkMap* reference);

/// A measurement between two walls as a file holds it, at `true_m` where that is given and else at
/// the places picked: its points are moved along their line until they are so far apart.
NamedDistance named_distance(const HandMeasurement& measurement, std::optional<double> true_m);

/// The other way round; the file's distance is the true one.
HandMeasurement measurement_of(const NamedDistance& distance);

}  // namespace hitos
