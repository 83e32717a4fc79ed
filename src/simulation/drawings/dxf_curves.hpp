// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as chords.
#pragma once

#include <span>
#include <vector>

#include "dxf_shapes.hpp"

namespace hitos::dxf {

/// An ellipse from an angle on: middle + cos(a) u + sin(a) v.
struct Arc {
    Eigen::Vector3d middle;
    Eigen::Vector3d u;
    Eigen::Vector3d v;
    double from_rad = 0.0;
    double sweep_rad = 0.0;  ///< counter-clockwise, as u turns to v
};

/// From one angle on to another, counter-clockwise; equal ones are a whole turn [rad].
double sweep_between(double from_rad, double to_rad);

/// Both ends among them.
Curve chords_of(const Arc& arc, double chord);

/// Goes on from the last point of the curve to `to` by the arc that a bulge, the tangent of a
/// quarter of its angle, stands for; straight where there is none.
void append_bulge(Curve& curve, const Eigen::Vector3d& to, double bulge, double chord);

struct Spline {
    int degree = 3;
    std::vector<double> knots;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> weights;  ///< none: all are 1
};

/// Nothing where the knots do not fit the points.
Curve chords_of(const Spline& spline, double chord);

}  // namespace hitos::dxf
