// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the value by which a log says "no return", where the format does not state it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include "range_conversor.hpp"

namespace hitos {
namespace {

/// A code comes over and over, on many rays. A far corner seen by a robot at rest repeats its
/// distance too, but on a ray or two, and a far wall has other readings just below.
constexpr std::size_t kRepetitions = 10;
constexpr std::size_t kDistinctRays = 5;
constexpr std::size_t kTimesMoreThanBelow = 3;
constexpr double kJustBelow = 0.5;

struct Reading {
    double range_m;
    std::size_t ray;
};

std::optional<double> repeated_maximum(const std::vector<Reading>& readings) {
    if (readings.empty()) return std::nullopt;
    const double greatest =
        std::max_element(readings.begin(), readings.end(), [](const Reading& a, const Reading& b) {
            return a.range_m < b.range_m;
        })->range_m;
    std::size_t repetitions = 0;
    std::size_t just_below = 0;
    std::set<std::size_t> rays;
    for (const Reading& reading : readings) {
        if (reading.range_m == greatest) {
            ++repetitions;
            rays.insert(reading.ray);
        } else if (reading.range_m > greatest - kJustBelow) {
            ++just_below;
        }
    }
    const bool is_code = repetitions >= kRepetitions && rays.size() >= kDistinctRays &&
                         repetitions > kTimesMoreThanBelow * just_below;
    return is_code ? std::optional(greatest) : std::nullopt;
}

}  // namespace

std::optional<double> find_no_return(const Fuente& fuente, RangeConversor& scratch) {
    std::vector<Reading> collected;
    bool stated = false;
    look_at_readings(fuente, scratch, [&](const RangeConversor::Readings& readings) {
        stated = readings.max_is_exact;
        for (std::size_t i = 0; i < readings.ranges_m.size(); ++i) {
            const double range = readings.ranges_m[i];
            if (range > 0.0 && std::isfinite(range)) collected.push_back({range, i});
        }
        return !stated;
    });
    return stated ? std::nullopt : repeated_maximum(collected);
}

}  // namespace hitos
