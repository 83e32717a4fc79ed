// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of straight walls that meet.
#pragma once

#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

struct Straight {
    Point2 a;
    Point2 b;
};

/// Moves ends that lie within `reach` of where two walls cross to that point: first two ends that
/// meet in a corner, nearest first, then ends that stop short of another wall's middle or stand
/// out of it. Ends of walls of nearly one direction meet half way. No end moves by more than a
/// third of its wall.
void join_corners(std::vector<Straight>& walls, double reach);

}  // namespace hitos
