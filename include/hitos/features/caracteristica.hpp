// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks and observed features: infinite lines and corners [T 7.4.2, 9.2.3].
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <variant>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// The infinite line rho = x cos(theta) + y sin(theta) [T eq 7.24]: rho [m] is the distance from
/// the frame's origin, theta [rad] the direction of the normal. Normal form: rho >= 0, theta in
/// (-pi, pi].
struct Recta {
    double rho = 0.0;
    double theta = 0.0;
    friend bool operator==(const Recta&, const Recta&) = default;
};

/// A corner point [m].
struct Esquina {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Esquina&, const Esquina&) = default;
};

enum class FeatureKind { line, corner };

/// "line", "corner".
std::string_view to_string(FeatureKind kind);

/// The same line in normal form; (rho, theta) and (-rho, theta + pi) are one line.
Recta normalized(const Recta& recta);

/// The line through two points that differ; normal form.
Recta line_through(const Point2& a, const Point2& b);

/// How far two lines are apart once the second is flipped to the side of the first where their
/// normals differ by more than pi/2: |rho1 - rho2| [m] and |theta1 - theta2| in [0, pi/2] [rad].
struct LineDifference {
    double rho = 0.0;
    double theta = 0.0;
};
LineDifference difference(const Recta& a, const Recta& b);

/// The point of the line nearest the origin, (rho cos theta, rho sin theta) [T eq 10.1, 10.2].
Point2 foot(const Recta& recta);

/// The distance [m] of a point from the line, with the sign of the side away from the origin.
double signed_distance(const Recta& recta, const Point2& point);

/// A line prepared for many points: cosine and sine are computed once.
struct PreparedRecta {
    double rho = 0.0;
    double c = 1.0;  ///< of theta
    double s = 0.0;

    PreparedRecta() = default;
    explicit PreparedRecta(const Recta& recta)
        : rho(recta.rho), c(std::cos(recta.theta)), s(std::sin(recta.theta)) {}

    /// As the function of that name.
    double signed_distance(const Point2& p) const { return p.x * c + p.y * s - rho; }
    /// The place [m] along the line of the point's foot, from the line's own foot; it grows to the
    /// left of the normal.
    double along(const Point2& p) const { return p.y * c - p.x * s; }
    /// The point of the line at a place along it.
    Point2 at(double t) const { return {rho * c - t * s, rho * s + t * c}; }
};

/// The feature in frame a from its values in frame b [T eq 7.23, 7.27 corrected: see
/// docs/algorithm.md].
Recta transform(const Pose& pose_a_b, const Recta& recta_b);
Esquina transform(const Pose& pose_a_b, const Esquina& esquina_b);

/// A landmark as it leaves a filter, for maps, pictures and files. `covariance` is of (rho, theta)
/// [m, rad] or (x, y) [m]; all zero where it is not known.
struct ICaracteristica {
    std::variant<Recta, Esquina> value;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    int observations = 0;  ///< how often it was observed
    /// The part of a line that was seen, as places along it (PreparedRecta::along()) [m]; the whole
    /// line where its owner does not keep that. Corners have none.
    double from_m = -std::numeric_limits<double>::infinity();
    double to_m = std::numeric_limits<double>::infinity();
    std::uint32_t first_seen = 0;  ///< number of the scan that saw it first, from 0
    std::uint32_t last_seen = 0;   ///< of the one that saw it last
    std::int32_t identity = -1;    ///< which one it is, from 0, where a sensor told that

    FeatureKind kind() const {
        return std::holds_alternative<Recta>(value) ? FeatureKind::line : FeatureKind::corner;
    }
    /// Its point for the error measure [T 10.3]: the corner, or the line's foot.
    Point2 point() const;
};

/// A map of landmarks, in no particular order unless its owner states one.
using LandmarkMap = std::vector<ICaracteristica>;

/// The landmark moved as a whole: its values and its covariance.
ICaracteristica transform(const Pose& pose_a_b, const ICaracteristica& landmark_b);

}  // namespace hitos
