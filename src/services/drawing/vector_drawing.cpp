// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/vector_drawing.hpp"

#include <utility>

namespace hitos {

ShapeStyle line_style(const Colour& colour, double width, std::vector<double> dashes) {
    return {{}, colour, width, std::move(dashes)};
}

ShapeStyle word_style(const Colour& colour, double letters) {
    return {colour, {}, 0.0, {}, letters};
}

DrawnLine rectangle(const Point2& corner, const Point2& opposite) {
    return {corner, {opposite.x, corner.y}, opposite, {corner.x, opposite.y}};
}

DrawnEllipse disc(const Point2& centre, double radius) {
    return {centre, {radius, 0.0}, {0.0, radius}};
}

std::array<Point2, 13> bezier_of(const DrawnEllipse& ellipse) {
    constexpr double kReach = 0.5522847498307936;  // 4/3 (sqrt(2) - 1)
    const Point2& centre = ellipse.centre;
    const Point2& first = ellipse.first;
    const Point2& second = ellipse.second;
    const auto at = [&](double u, double v) {
        return Point2{centre.x + u * first.x + v * second.x, centre.y + u * first.y + v * second.y};
    };
    return {at(1.0, 0.0),      at(1.0, kReach),  at(kReach, 1.0),  at(0.0, 1.0),
            at(-kReach, 1.0),  at(-1.0, kReach), at(-1.0, 0.0),    at(-1.0, -kReach),
            at(-kReach, -1.0), at(0.0, -1.0),    at(kReach, -1.0), at(1.0, -kReach),
            at(1.0, 0.0)};
}

}  // namespace hitos
