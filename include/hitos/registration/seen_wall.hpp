// SPDX-License-Identifier: GPL-3.0-or-later
// Straight walls that a scan sees, to be laid on those of a drawing.
#pragma once

#include <optional>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// A straight piece of wall, in the robot's frame [m].
struct SeenWall {
    Point2 left;  ///< its ends, as whoever looks at it from the laser has them
    Point2 right;
    double bearing = 0.0;  ///< of a point in its middle, by which it is found again [rad]

    Point2 middle() const { return {0.5 * (left.x + right.x), 0.5 * (left.y + right.y)}; }
};

/// The wall that a scan sees at a bearing from the robot, 3 degrees aside at most: the points about
/// there that lie within 0.1 m of one line, no more than 0.6 m from each other and half a metre in
/// all at least; nothing where there is none. Readings count up to `range_m`.
std::optional<SeenWall> seen_wall(const Scan& scan, double range_m, double bearing_rad);

/// All of them, each once, in the order of the scan's points; those that one line holds and a gap
/// parts are several.
std::vector<SeenWall> seen_walls(const Scan& scan, double range_m);

}  // namespace hitos
