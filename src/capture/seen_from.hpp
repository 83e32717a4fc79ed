// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of one scan lie, as the laser of an earlier one sees them.
#pragma once

#include <array>
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

/// Where points of the later scan lie, as the laser of the earlier one sees them.
struct Seen {
    static constexpr std::size_t kMost = 256;
    std::array<double, kMost> distances_m;  ///< below 0: no ray of its goes there
    std::array<double, kMost> bins;         ///< of the earlier scan's ranges
};

struct SeenFrom {
    double first_rad;  ///< of the earlier scan's bins,
    double step_rad;   ///< from one to the next
    double last_bin;
    Rays first_fan;
    Rays fan;     ///< of the later scan
    double sign;  ///< -1 where rays go the other way round
    double range_offset_m;
    Pose lasers;  ///< of the later one in the earlier one's frame

    /// Of up to Seen::kMost points of the later one, by where its laser says that they are.
    void look(std::span<const float> directions, const float* distances, Seen& seen) const;
};

}  // namespace hitos
