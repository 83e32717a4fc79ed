// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_merging.hpp"

#include <Eigen/LU>
#include <cmath>

namespace hitos {
namespace {

constexpr double kNearLine = 0.3;     // [m] across
constexpr double kNearAngle = 0.15;   // [rad]
constexpr double kNearCorner = 0.4;   // [m]
constexpr double kShared = 0.5;       // [m], or
constexpr double kSharedPart = 0.5;   // of the shorter
constexpr double kLineSigma = 0.05;   // [m] between two passages
constexpr double kAngleSigma = 0.02;  // [rad]
constexpr double kCornerSigma = 0.1;  // [m]
constexpr double kKnownSigma = 0.25;  // [m]: beyond it nothing is said

}  // namespace

PlaceDifference difference(const GraphLandmark& a, const GraphLandmark& b) {
    if (a.kind != FeatureKind::line) {
        return {{b.place.point.x - a.place.point.x, b.place.point.y - a.place.point.y},
                -Matrix2::Identity(),
                Matrix2::Identity()};
    }
    const Extent other = extent_along(a.place, b);
    const double t =
        0.5 * (std::max(a.extent.low, other.low) + std::min(a.extent.high, other.high));
    const Point2 middle{a.place.point.x - t * std::sin(a.place.angle),
                        a.place.point.y + t * std::cos(a.place.angle)};
    // Where a line passes the middle: -n.(middle - point), which a shift along n moves by itself.
    const auto pass = [&](const LandmarkPlace& line, Matrix2& j) {
        const double c = std::cos(line.angle);
        const double s = std::sin(line.angle);
        const double dx = middle.x - line.point.x;
        const double dy = middle.y - line.point.y;
        j << 1.0, s * dx - c * dy, 0.0, 1.0;
        return -(c * dx + s * dy);
    };
    PlaceDifference apart;
    const double first = pass(a.place, apart.by_first);
    const double second = pass(b.place, apart.by_second);
    apart.by_first *= -1.0;
    apart.value << second - first, wrap_angle(b.place.angle - a.place.angle);
    return apart;
}

bool may_be_one(const GraphLandmark& a, const GraphLandmark& b) {
    if (a.kind != b.kind) return false;
    if (a.kind != FeatureKind::line) {
        return std::hypot(b.place.point.x - a.place.point.x, b.place.point.y - a.place.point.y) <
               kNearCorner;
    }
    if (std::abs(wrap_angle(b.place.angle - a.place.angle)) > kNearAngle) return false;
    const double shorter = std::min(a.extent.length(), b.extent.length());
    return -a.extent.gap(extent_along(a.place, b)) >= std::min(kShared, kSharedPart * shorter);
}

bool is_plain(const PlaceDifference& apart, FeatureKind kind) {
    return std::abs(apart.value(0)) > (kind == FeatureKind::line ? kNearLine : kNearCorner);
}

bool is_none(const PlaceDifference& apart, const Matrix2& covariance, FeatureKind kind,
             double gate) {
    const bool line = kind == FeatureKind::line;
    const Vector2 sigma =
        line ? Vector2(kLineSigma, kAngleSigma) : Vector2(kCornerSigma, kCornerSigma);
    if (is_plain(apart, kind)) return false;
    const double known = kKnownSigma * kKnownSigma;
    if (covariance(0, 0) > known || (!line && covariance(1, 1) > known)) return false;
    Matrix2 s = covariance;
    s.diagonal() += sigma.cwiseAbs2();
    return apart.value.dot(s.inverse() * apart.value) <= gate;
}

}  // namespace hitos
