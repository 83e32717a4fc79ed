// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks of graph-slam: where they are, in coordinates that suit a least-squares step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hitos/registration/pose_graph_solver.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {

/// A corner, or a line by one of its points and the direction of its normal, which points away from
/// whoever saw it: the two faces of a wall are two landmarks.
struct LandmarkPlace {
    Point2 point;        ///< [m]
    double angle = 0.0;  ///< [rad]; of a line
};

/// The two coordinates by which a landmark of a kind is moved in a step, and what they do to the
/// state of its kind.
template <Sensor S>
struct LocalCoordinates;

/// A line is shifted along its normal and turned about its own point, which lies in the middle of
/// what was seen of it. In (rho, theta) it would turn about the origin: 300 m away a turn of 1 mrad
/// moves a wall by 0.3 m, rho and theta are correlated to the last digits, and a step of
/// 0.05 rad misses by 300 m * 0.05^2 / 2 = 0.4 m, for rho depends on theta by a cosine.
template <>
struct LocalCoordinates<SensorRecta> {
    static Recta landmark(const LandmarkPlace& place) {
        return {place.point.x * std::cos(place.angle) + place.point.y * std::sin(place.angle),
                place.angle};
    }
    /// d(rho, theta)/d(shift, turn).
    static Matrix2 jacobian(const LandmarkPlace& place) {
        Matrix2 j;
        j << 1.0, place.point.y * std::cos(place.angle) - place.point.x * std::sin(place.angle),
            0.0, 1.0;
        return j;
    }
    static void move(LandmarkPlace& place, const Vector2& step) {
        place.point.x += step(0) * std::cos(place.angle);
        place.point.y += step(0) * std::sin(place.angle);
        place.angle = wrap_angle(place.angle + step(1));
    }
    static LandmarkPlace place(const Recta& recta) {
        return {{recta.rho * std::cos(recta.theta), recta.rho * std::sin(recta.theta)},
                wrap_angle(recta.theta)};
    }
};

/// A corner is moved in x and y.
template <>
struct LocalCoordinates<SensorEsquina> {
    static Esquina landmark(const LandmarkPlace& place) { return {place.point.x, place.point.y}; }
    static Matrix2 jacobian(const LandmarkPlace& /*place*/) { return Matrix2::Identity(); }
    static void move(LandmarkPlace& place, const Vector2& step) {
        place.point.x += step(0);
        place.point.y += step(1);
    }
    static LandmarkPlace place(const Esquina& esquina) { return {{esquina.x, esquina.y}, 0.0}; }
};

/// Calls body.operator()<S>() for the one kind.
template <class Body>
void for_kind(FeatureKind kind, Body&& body) {
    for_each_kind([&]<class S>() {
        if (S::kKind == kind) body.template operator()<S>();
    });
}

struct GraphLandmark {
    FeatureKind kind = FeatureKind::line;
    LandmarkPlace place;
    Extent extent;                         ///< of a line
    std::vector<std::uint32_t> sightings;  ///< in the order of their keys
    std::int32_t identity = kNameless;
};

/// A feature of a key's scan, taken to a landmark.
struct Sighting {
    std::uint32_t key = 0;
    std::uint32_t landmark = 0;
    Vector2 z;
    Matrix2 information;  ///< R^-1
    Point2 low, high;     ///< ends of what was seen of a line, in the robot's frame
    bool known = false;   ///< it said itself which landmark it is of: no outlier

    double weight(double mahalanobis_squared) const {
        return known ? 1.0 : robust_weight(mahalanobis_squared);
    }
    double loss(double mahalanobis_squared) const {
        return known ? mahalanobis_squared : robust_loss(mahalanobis_squared);
    }
};

/// The error of a sighting, h - z, with its derivatives by the pose and by the landmark's local
/// coordinates.
struct SightingError {
    Vector2 value;
    Matrix23 by_pose;
    Matrix2 by_landmark;
};

inline SightingError sighting_error(const Vector2& z, const Pose& pose,
                                    const GraphLandmark& landmark) {
    SightingError error;
    for_kind(landmark.kind, [&]<class S>() {
        using Local = LocalCoordinates<S>;
        const JointInnovation seen = S::joint_innovation(z, pose, Local::landmark(landmark.place));
        error = {-seen.nu, seen.by_pose, seen.by_landmark * Local::jacobian(landmark.place)};
    });
    return error;
}

inline void move(GraphLandmark& landmark, const Vector2& step) {
    for_kind(landmark.kind, [&]<class S>() { LocalCoordinates<S>::move(landmark.place, step); });
}

/// Where two world points lie along a line.
inline Extent extent_along(const LandmarkPlace& line, const Point2& a, const Point2& b) {
    const double c = std::cos(line.angle);
    const double s = std::sin(line.angle);
    const auto along = [&](const Point2& p) {
        return c * (p.y - line.point.y) - s * (p.x - line.point.x);
    };
    const auto [low, high] = std::minmax({along(a), along(b)});
    return {low, high};
}

/// The extent of a landmark along another line.
inline Extent extent_along(const LandmarkPlace& line, const GraphLandmark& landmark) {
    const double c = std::cos(landmark.place.angle);
    const double s = std::sin(landmark.place.angle);
    const auto at = [&](double t) {
        return Point2{landmark.place.point.x - t * s, landmark.place.point.y + t * c};
    };
    return extent_along(line, at(landmark.extent.low), at(landmark.extent.high));
}

}  // namespace hitos
