// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_from.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

constexpr std::size_t kMost = 256;  // at once

/// Where some points lie, as the laser of the earlier scan sees them.
struct Seen {
    std::array<double, kMost> distances_m;  ///< below 0: no ray of its goes there
    std::array<double, kMost> bins;         ///< of the earlier scan's ranges
};

/// Whose rays go where they are told to (`kTold`): for most hypotheses that is half the work.
template <bool kTold>
HITOS_INLINE void look(const SeenFrom& from, const Points& points, std::size_t begin,
                       std::size_t count, Seen& seen) {
    const double laser_x = from.lasers.x;  // what is a member's is read again in each round
    const double laser_y = from.lasers.y;
    const double cosine = std::cos(from.lasers.theta);
    const double sine = std::sin(from.lasers.theta);
    const Rays wide = from.fan;
    const Rays first_wide = from.first_fan;
    const double is_told = wide.told() ? 1.0 : 0.0;
    const double first_is_told = first_wide.told() ? 1.0 : 0.0;
    const double way_round = from.sign;
    const double longer = from.range_offset_m;
    const double first = from.first_rad;
    const double step = from.step_rad;
    const auto last = static_cast<double>(from.ranges.size() - 1);
    const float* const angles = points.directions.data() + begin;
    const float* const distances = points.distances + begin;
    const double* const cosines = points.cosines + begin;
    const double* const sines = points.sines + begin;
    double* const out_m = seen.distances_m.data();
    double* const bins = seen.bins.data();
    HITOS_LANES
    for (std::size_t i = 0; i < count; ++i) {
        const double range = static_cast<double>(distances[i]) + longer;
        double px = 0.0;
        double py = 0.0;
        if constexpr (kTold) {
            px = range * cosines[i];
            py = range * (way_round * sines[i]);
        } else {
            const auto angle = static_cast<double>(angles[i]);
            const double widened =
                wide.middle + wide.scale * elementary::wrap(angle - wide.middle) + wide.offset;
            const elementary::SineCosine towards =
                elementary::sine_cosine(way_round * (is_told > 0.0 ? angle : widened));
            px = range * towards.cosine;
            py = range * towards.sine;
        }
        const double x = laser_x + cosine * px - sine * py;
        const double y = laser_y + sine * px + cosine * py;
        const double straight = way_round * elementary::angle_of(y, x);
        const double distance = std::sqrt(x * x + y * y);
        if constexpr (kTold) {
            bins[i] = nearest_bin(straight, first, step, last);
            out_m[i] = distance;
        } else {
            const double off = elementary::wrap(straight - first_wide.middle - first_wide.offset) /
                               first_wide.scale;
            const double away = first_is_told > 0.0 ? 0.0 : (off < 0.0 ? -off : off);
            const double seen_rad = first_is_told > 0.0 ? straight : first_wide.middle + off;
            bins[i] = nearest_bin(seen_rad, first, step, last);
            out_m[i] = away > kPi ? -1.0 : distance;
        }
    }
}

HITOS_INLINE SeenFrom::Count count_of(const SeenFrom& from, const Seen& seen, std::size_t count) {
    const float* const ranges = from.ranges.data();
    const double longer = from.range_offset_m;
    const double near_m = from.near_m;
    const double near_per_range = from.near_per_range;
    const double* const distances_m = seen.distances_m.data();
    const double* const bins = seen.bins.data();
    std::int32_t asked = 0;
    std::int32_t lie = 0;
    HITOS_LANES
    for (std::size_t i = 0; i < count; ++i) {
        const float range = ranges[static_cast<std::int32_t>(bins[i])];
        const double expected = distances_m[i];
        const double off = (static_cast<double>(range) + longer) - expected;
        // What is added to the readings does not make them less exact.
        const double read_m = expected - longer > 0.0 ? expected - longer : 0.0;
        const std::int32_t known = (range != 0.0F ? 1 : 0) & (expected >= 0.0 ? 1 : 0);
        const double away = off < 0.0 ? -off : off;
        asked += known;
        lie += known & (away < near_m + near_per_range * read_m ? 1 : 0);
    }
    return {asked, lie};
}

}  // namespace

SeenFrom::Count SeenFrom::count(const Points& points) const {
    const bool told = fan.told() && first_fan.told();
    const std::size_t all = points.directions.size();
    Count sum;
    Seen seen;
    vectorised([&]() HITOS_INLINED {
        for (std::size_t begin = 0; begin < all; begin += kMost) {
            const std::size_t some = std::min(kMost, all - begin);
            if (told) {
                look<true>(*this, points, begin, some, seen);
            } else {
                look<false>(*this, points, begin, some, seen);
            }
            const Count found = count_of(*this, seen, some);
            sum.asked += found.asked;
            sum.lie += found.lie;
        }
    });
    return sum;
}

}  // namespace hitos
