// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of one scan lie, as the laser of an earlier one sees them.
#pragma once

#include <cstddef>
#include <span>

#include "hitos/base/elementary.hpp"
#include "hitos/base/geometry.hpp"

namespace hitos {

/// The nearest of the bins that part a whole turn from `first_rad` on, 0 … last_bin.
HITOS_INLINE double nearest_bin(double direction_rad, double first_rad, double step_rad,
                                double last_bin) {
    constexpr double kTurn = 2.0 * kPi;
    const double off = direction_rad - first_rad;
    const double turns = (off + 0.5 * step_rad) / kTurn;
    const double nearest = elementary::nearest_whole(turns);
    const double whole = nearest > turns ? nearest - 1.0 : nearest;
    const double bin = elementary::nearest_whole((off - kTurn * whole) / step_rad);
    const double low = bin > 0.0 ? bin : 0.0;
    return low < last_bin ? low : last_bin;
}

/// Where rays truly go by where they are told to. One that is measured later, while the robot turns
/// on, looks further round: the fan of such a scan is wider, from its first ray on.
struct Rays {
    double middle;
    double scale;
    double offset;
    bool told() const { return scale == 1.0 && offset == 0.0; }
};

/// The points of the later scan, as its laser says where they are.
struct Points {
    std::span<const float> directions;
    const float* distances;
    const double* cosines;  ///< of the directions
    const double* sines;
};

struct SeenFrom {
    double first_rad;               ///< of the earlier scan's bins,
    double step_rad;                ///< and from one to the next
    std::span<const float> ranges;  ///< of its bins, 0 where nothing is known
    Rays first_fan;
    Rays fan;     ///< of the later scan
    double sign;  ///< -1 where rays go the other way round
    double range_offset_m;
    Pose lasers;            ///< of the later one in the earlier one's frame
    double near_m;          ///< how far apart two points may be that are one
    double near_per_range;  ///< and for each metre of their range

    struct Count {
        int asked = 0;  ///< points where the earlier scan knows something
        int lie = 0;    ///< those of them that lie on it
    };
    Count count(const Points& points) const;
};

}  // namespace hitos
