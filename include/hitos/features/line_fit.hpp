// Straight lines through many points.
#pragma once

#include <span>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// Total least squares: the line that minimises the sum of squared perpendicular distances (its
/// normal is the eigenvector of the smaller eigenvalue of the points' scatter) [P 2]. Normal form;
/// needs two points or more.
Recta fit_least_squares(std::span<const Point2> points);

}  // namespace hitos
