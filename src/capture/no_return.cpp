// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the value by which a log says "no return", where the format does not state it.
#include <cstddef>

#include "hitos/capture/greatest_ranges.hpp"
#include "range_conversor.hpp"

namespace hitos {

std::optional<double> find_no_return(const Fuente& fuente, RangeConversor& scratch) {
    GreatestRanges greatest;
    bool stated = false;
    look_at_readings(fuente, scratch, [&](const RangeConversor::Readings& readings) {
        stated = readings.max_is_exact;
        for (std::size_t i = 0; i < readings.ranges_m.size(); ++i) {
            const double range = readings.ranges_m[i];
            if (range > 0.0) greatest.note(range, i);
        }
        return !stated;
    });
    const std::optional<GreatestRanges::Code> code = greatest.code();
    return stated || !code ? std::nullopt : std::optional(code->range_m);
}

}  // namespace hitos
