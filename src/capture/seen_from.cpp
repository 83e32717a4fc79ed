// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_from.hpp"

#include <cmath>

#include "hitos/base/vectorised.hpp"

namespace hitos {

void SeenFrom::look(std::span<const float> directions, const float* distances, Seen& seen) const {
    const double laser_x = lasers.x;  // what is a member's is read again in each round
    const double laser_y = lasers.y;
    const double cosine = std::cos(lasers.theta);
    const double sine = std::sin(lasers.theta);
    const Rays wide = fan;
    const Rays first_wide = first_fan;
    const double is_told = fan.told() ? 1.0 : 0.0;
    const double first_is_told = first_fan.told() ? 1.0 : 0.0;
    const double way_round = sign;
    const double longer = range_offset_m;
    const double first = first_rad;
    const double step = step_rad;
    const double last = last_bin;
    const std::size_t count = directions.size();
    const float* const angles = directions.data();
    double* const out_m = seen.distances_m.data();
    double* const bins = seen.bins.data();
    vectorised([&]() HITOS_INLINED {
        HITOS_LANES
        for (std::size_t i = 0; i < count; ++i) {
            const auto angle = static_cast<double>(angles[i]);
            const double widened =
                wide.middle + wide.scale * elementary::wrap(angle - wide.middle) + wide.offset;
            const elementary::SineCosine towards =
                elementary::sine_cosine(way_round * (is_told > 0.0 ? angle : widened));
            const double range = static_cast<double>(distances[i]) + longer;
            const double px = range * towards.cosine;
            const double py = range * towards.sine;
            const double x = laser_x + cosine * px - sine * py;
            const double y = laser_y + sine * px + cosine * py;
            const double straight = way_round * elementary::angle_of(y, x);
            const double off = elementary::wrap(straight - first_wide.middle - first_wide.offset) /
                               first_wide.scale;
            const double away = first_is_told > 0.0 ? 0.0 : (off < 0.0 ? -off : off);
            const double seen_rad = first_is_told > 0.0 ? straight : first_wide.middle + off;
            bins[i] = nearest_bin(seen_rad, first, step, last);
            out_m[i] = away > kPi ? -1.0 : std::sqrt(x * x + y * y);
        }
    });
}

}  // namespace hitos
