// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_curves.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/base/geometry.hpp"

namespace hitos::dxf {
namespace {

constexpr int kMostChords = 2000;     // of one arc
constexpr double kWidest = kPi / 12;  // of an arc's chord, however small the arc

int chords_in(double radius, double sweep_rad, double chord) {
    const double half = chord < radius ? std::acos(1.0 - chord / radius) : kPi;
    const double count = std::ceil(std::abs(sweep_rad) / std::min(2.0 * half, kWidest) - 1e-9);
    return count >= 1.0 ? static_cast<int>(std::min<double>(count, kMostChords)) : 1;
}

/// De Boor's algorithm in homogeneous coordinates at the parameter `t` of the span that begins at
/// knot `span`.
Eigen::Vector3d spline_at(const Spline& spline, std::size_t span, double t) {
    const auto p = static_cast<std::size_t>(spline.degree);
    std::vector<Eigen::Vector4d> d(p + 1);
    for (std::size_t j = 0; j <= p; ++j) {
        const std::size_t i = span - p + j;
        const double w = spline.weights.empty() ? 1.0 : spline.weights[i];
        d[j] << w * spline.points[i], w;
    }
    for (std::size_t r = 1; r <= p; ++r) {
        for (std::size_t j = p; j >= r; --j) {
            const double low = spline.knots[span - p + j];
            const double high = spline.knots[span + 1 + j - r];
            const double a = high > low ? (t - low) / (high - low) : 0.0;
            d[j] = (1.0 - a) * d[j - 1] + a * d[j];
        }
    }
    return d[p].head<3>() / d[p].w();
}

/// By the bound of a chord's distance, an eighth of the second derivative, taken from the control
/// points as if their knots were evenly spaced, and doubled because they need not be.
int chords_in(const Spline& spline, std::size_t span, double chord) {
    constexpr double kMost = 64.0;
    const auto p = static_cast<std::size_t>(spline.degree);
    double bend = 0.0;
    for (std::size_t i = span - p + 1; i < span; ++i) {
        bend = std::max(
            bend, (spline.points[i - 1] - 2.0 * spline.points[i] + spline.points[i + 1]).norm());
    }
    const double second = 2.0 * spline.degree * (spline.degree - 1) * bend;
    const double count = std::ceil(std::sqrt(second / (8.0 * chord)));
    return static_cast<int>(count >= 1.0 ? std::min(count, kMost) : 1.0);
}

}  // namespace

double sweep_between(double from_rad, double to_rad) {
    constexpr double kTurn = 2.0 * kPi;
    constexpr double kSame = 1e-12;
    const double sweep = std::remainder(to_rad - from_rad, kTurn);
    return sweep > kSame ? sweep : sweep + kTurn;
}

Curve chords_of(const Arc& arc, double chord) {
    const int count = chords_in(std::max(arc.u.norm(), arc.v.norm()), arc.sweep_rad, chord);
    Curve curve;
    for (int i = 0; i <= count; ++i) {
        const double angle = arc.from_rad + arc.sweep_rad * i / count;
        curve.emplace_back(arc.middle + std::cos(angle) * arc.u + std::sin(angle) * arc.v);
    }
    return curve;
}

void append_bulge(Curve& curve, const Eigen::Vector3d& to, double bulge, double chord) {
    constexpr double kStraight = 1e-9;
    if (!curve.empty() && curve.size() <= kMostPoints && std::abs(bulge) > kStraight) {
        const Eigen::Vector3d from = curve.back();
        const Eigen::Vector3d half = (to - from) / 2.0;
        const Eigen::Vector3d left(-half.y(), half.x(), 0.0);
        const Eigen::Vector3d middle = from + half + left * ((1.0 / bulge - bulge) / 2.0);
        if (middle.allFinite() && half.norm() > 0.0) {
            const Eigen::Vector3d u = from - middle;
            const Curve arc =
                chords_of({middle, u, {-u.y(), u.x(), 0.0}, 0.0, 4.0 * std::atan(bulge)}, chord);
            curve.insert(curve.end(), arc.begin() + 1, arc.end() - 1);
        }
    }
    curve.push_back(to);
}

Curve chords_of(const Spline& spline, double chord) {
    constexpr int kHighest = 30;
    const std::size_t n = spline.points.size();
    if (spline.degree < 1 || spline.degree > kHighest) return {};
    const auto p = static_cast<std::size_t>(spline.degree);
    if (n < p + 1 || spline.knots.size() != n + p + 1 || !std::ranges::is_sorted(spline.knots) ||
        (!spline.weights.empty() && spline.weights.size() != n)) {
        return {};
    }
    Curve curve;
    for (std::size_t span = p; span < n && curve.size() <= kMostPoints; ++span) {
        const double from = spline.knots[span];
        const double to = spline.knots[span + 1];
        if (!(to > from)) continue;
        const int count = chords_in(spline, span, chord);
        for (int i = curve.empty() ? 0 : 1; i <= count; ++i)
            curve.push_back(spline_at(spline, span, from + (to - from) * i / count));
    }
    return curve;
}

}  // namespace hitos::dxf
