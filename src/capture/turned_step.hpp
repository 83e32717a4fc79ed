// SPDX-License-Identifier: GPL-3.0-or-later
// The step of an arc that turns otherwise.
#pragma once

#include <cmath>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// The same way, driven as an arc that turns by `turn_rad`: half the turn's difference bends it.
inline Pose with_turn(const Pose& step, double turn_rad) {
    const double bend = (turn_rad - step.theta) / 2.0;
    const double c = std::cos(bend);
    const double s = std::sin(bend);
    return {c * step.x - s * step.y, s * step.x + c * step.y, turn_rad};
}

}  // namespace hitos
