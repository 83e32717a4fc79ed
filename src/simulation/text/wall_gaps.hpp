// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of walls that doors take the place of.
#pragma once

#include <vector>

#include "hitos/simulation/text/world_text.hpp"

namespace hitos {

/// The walls without what lies along the stretch from a to b (within a centimetre); walls that are
/// not touched are the same.
std::vector<Polyline> without_stretch(const std::vector<Polyline>& walls, const Point2& a,
                                      const Point2& b);

/// The walls with that stretch again where a wall ends at a and one at b, and one of them leads
/// straight along it; else the same.
std::vector<Polyline> with_stretch(const std::vector<Polyline>& walls, const Point2& a,
                                   const Point2& b);

}  // namespace hitos
