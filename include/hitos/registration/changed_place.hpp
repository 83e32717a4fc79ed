// SPDX-License-Identifier: GPL-3.0-or-later
// Where a second tour saw something else than the first one.
#pragma once

#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Walls that only one of two tours saw, though the other one looked where they are.
struct ChangedPlace {
    bool gone = false;           ///< seen by the first tour alone; else by the second alone
    std::vector<Point2> points;  ///< in the world, one for each decimetre of wall about [m]

    Bounds bounds() const {
        Bounds bounds;
        for (const Point2& point : points) bounds.hold(point);
        return bounds;
    }
};

}  // namespace hitos
