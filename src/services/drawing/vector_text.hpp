// What the writers of vector files share.
#pragma once

#include <array>
#include <string>

#include "vector_drawing.hpp"

namespace hitos {

/// Micrometres are finer than any printer.
inline constexpr int kMillimetreDecimals = 3;

/// With at most three decimals and none that say nothing, whatever the locale.
std::string short_number(double value);

/// An ellipse as four Bezier curves: where it begins, then two control points and an end for each.
/// They are off the ellipse by less than 0.03 % of its half diameter.
std::array<Point2, 13> bezier_of(const DrawnEllipse& ellipse);

}  // namespace hitos
