// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/hand_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hitos {
namespace {

using Kind = PickedPlace::Kind;

constexpr double kGreatestAway = 0.5;              // m, of a landmark from its place
constexpr double kLeastAngle = 0.5 * kPi / 180.0;  // rad; flatter walls meet nowhere of interest

Point2 middle(const Point2& a, const Point2& b) {
    return {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
}

/// The line through a wall's place, as it was picked.
Recta line_of(const PickedPlace& wall) {
    return normalized(
        {wall.at.x * std::cos(wall.normal_rad) + wall.at.y * std::sin(wall.normal_rad),
         wall.normal_rad});
}

bool is_wall(const PickedPlace& place) {
    return place.kind == Kind::wall;
}

/// The same place on a wall that moved on, or as a point.
PickedPlace as_point(const PickedPlace& place) {
    return is_wall(place) ? PickedPlace{Kind::point, place.at} : place;
}

std::optional<Recta> wall_in(const LandmarkMap& map, const PickedPlace& place) {
    const int found = nearest_line(map, place.at, place.normal_rad, kGreatestAway);
    if (found < 0) return std::nullopt;
    return std::get<Recta>(map[static_cast<std::size_t>(found)].value);
}

std::optional<Point2> point_in(const LandmarkMap& map, const PickedPlace& place) {
    if (place.kind == Kind::point) return place.at;
    std::optional<Point2> nearest;
    double least = kGreatestAway;
    for (const ICaracteristica& landmark : map) {
        if (landmark.kind() != FeatureKind::corner) continue;
        const double away = distance(landmark.point(), place.at);
        if (away > least) continue;
        least = away;
        nearest = landmark.point();
    }
    return nearest;
}

/// At b, between the ways to a and c, in [0, pi]; nothing where there is no way.
std::optional<double> angle_at(const Point2& a, const Point2& b, const Point2& c) {
    if (distance(a, b) < kLeastDistance || distance(c, b) < kLeastDistance) return std::nullopt;
    return std::abs(
        wrap_angle(std::atan2(a.y - b.y, a.x - b.x) - std::atan2(c.y - b.y, c.x - b.x)));
}

Point2 crossing(const Recta& a, const Recta& b) {
    const double turn = std::sin(b.theta - a.theta);
    return {(a.rho * std::sin(b.theta) - b.rho * std::sin(a.theta)) / turn,
            (b.rho * std::cos(a.theta) - a.rho * std::cos(b.theta)) / turn};
}

MeasuredValue distance_of_walls(const LandmarkMap& map, const HandMeasurement& measurement) {
    const std::array wanted{NamedDistance{{}, measurement.places[0].at, measurement.places[1].at}};
    const MeasuredDistance found = measure_distances(map, wanted).front();
    if (!found.slam_m) return {};
    const auto line = [&](int index) {
        return std::get<Recta>(map[static_cast<std::size_t>(index)].value);
    };
    return {
        found.slam_m,
        {projected(line(found.line_a), wanted[0].a), projected(line(found.line_b), wanted[0].b)}};
}

MeasuredValue distance_of(const LandmarkMap& map, const HandMeasurement& measurement) {
    if (measurement.between_walls()) return distance_of_walls(map, measurement);
    const PickedPlace& first = measurement.places[0];
    const PickedPlace& second = measurement.places[1];
    const bool to_wall = is_wall(first) || is_wall(second);
    const std::optional<Point2> a = point_in(map, is_wall(first) ? second : first);
    if (!a) return {};
    if (!to_wall) {
        const std::optional<Point2> b = point_in(map, second);
        if (!b) return {};
        return {distance(*a, *b), {*a, *b}};
    }
    const std::optional<Recta> wall = wall_in(map, is_wall(first) ? first : second);
    if (!wall) return {};
    return {std::abs(signed_distance(*wall, *a)), {*a, projected(*wall, *a)}};
}

MeasuredValue angle_of_walls(const LandmarkMap& map, const HandMeasurement& measurement) {
    const std::optional<Recta> a = wall_in(map, measurement.places[0]);
    const std::optional<Recta> b = wall_in(map, measurement.places[1]);
    if (!a || !b) return {};
    const double turn = difference(*a, *b).theta;
    const Point2 from = projected(*a, measurement.places[0].at);
    const Point2 to = projected(*b, measurement.places[1].at);
    if (turn < kLeastAngle) return {turn, {from, to}};
    const Point2 vertex = crossing(*a, *b);
    return {angle_at(from, vertex, to).value_or(turn), {from, vertex, to}};
}

MeasuredValue angle_of(const LandmarkMap& map, const HandMeasurement& measurement) {
    if (measurement.places.size() == 2) return angle_of_walls(map, measurement);
    std::vector<Point2> points;
    for (const PickedPlace& place : measurement.places) {
        const std::optional<Point2> point = point_in(map, place);
        if (!point) return {};
        points.push_back(*point);
    }
    return {angle_at(points[0], points[1], points[2]), points};
}

HandMeasurement between(const PickedPlace& a, const PickedPlace& b) {
    HandMeasurement made{{}, Quantity::distance, {a, b}, {}};
    if (!made.between_walls()) return made;
    const std::array lines{line_of(a), line_of(b)};
    if (difference(lines[0], lines[1]).theta > kGreatestTurn) {
        made.quantity = Quantity::angle;
        return made;
    }
    const Point2 between_both = middle(a.at, b.at);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        made.places[i].at = projected(lines[i], between_both);
    }
    if (distance(made.places[0].at, made.places[1].at) < kLeastDistance) {
        made.places = {as_point(a), as_point(b)};
    }
    return made;
}

}  // namespace

bool HandMeasurement::between_walls() const {
    return quantity == Quantity::distance && std::ranges::all_of(places, is_wall);
}

PickedPlace place_on(const ICaracteristica& landmark, const Point2& picked) {
    if (const auto* line = std::get_if<Recta>(&landmark.value)) {
        return {Kind::wall, projected(*line, picked), line->theta};
    }
    return {Kind::corner, landmark.point()};
}

std::optional<HandMeasurement> measurement_of(Quantity wanted,
                                              std::span<const PickedPlace> picked) {
    if (picked.size() < 2) return std::nullopt;
    if (wanted == Quantity::distance) return between(picked[0], picked[1]);
    if (is_wall(picked[0]) && is_wall(picked[1])) {
        return HandMeasurement{{}, Quantity::angle, {picked[0], picked[1]}, {}};
    }
    if (picked.size() < 3) return std::nullopt;
    return HandMeasurement{
        {}, Quantity::angle, {as_point(picked[0]), as_point(picked[1]), as_point(picked[2])}, {}};
}

MeasuredValue measure(const LandmarkMap& map, const HandMeasurement& measurement) {
    return measurement.quantity == Quantity::distance ? distance_of(map, measurement)
                                                      : angle_of(map, measurement);
}

std::optional<double> true_value(const HandMeasurement& measurement, const LandmarkMap* reference) {
    if (measurement.true_value || reference == nullptr) return measurement.true_value;
    const bool free = std::ranges::find(measurement.places, Kind::point, &PickedPlace::kind) !=
                      measurement.places.end();
    return free ? std::nullopt : measure(*reference, measurement).value;
}

NamedDistance named_distance(const HandMeasurement& measurement, std::optional<double> true_m) {
    NamedDistance distance{measurement.name, measurement.places[0].at, measurement.places[1].at};
    const double now = distance.true_m();
    if (true_m.value_or(now) == now) return distance;  // to the last bit
    const Point2 centre = middle(distance.a, distance.b);
    for (Point2* point : {&distance.a, &distance.b}) {
        point->x = centre.x + (point->x - centre.x) * *true_m / now;
        point->y = centre.y + (point->y - centre.y) * *true_m / now;
    }
    return distance;
}

HandMeasurement measurement_of(const NamedDistance& distance) {
    const double normal = std::atan2(distance.b.y - distance.a.y, distance.b.x - distance.a.x);
    return {distance.name,
            Quantity::distance,
            {{Kind::wall, distance.a, normal}, {Kind::wall, distance.b, normal}},
            distance.true_m()};
}

}  // namespace hitos
