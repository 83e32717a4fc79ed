// Finds the value by which a log says "no return", where the format does not state it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include "hitos/base/error.hpp"
#include "range_conversor.hpp"

namespace hitos {
namespace {

constexpr int kScansLookedAt = 50;
constexpr int kLinesLookedAt = 2000;

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
    const std::unique_ptr<Fuente> ahead = fuente.reopen();
    RangeConversor::Readings readings;
    std::vector<Reading> collected;
    int scans = 0;
    for (int lines = 0; lines < kLinesLookedAt && scans < kScansLookedAt; ++lines) {
        const std::optional<RawLine> line = ahead->read_scan_line();
        if (!line) break;
        readings.clear();
        try {
            if (!scratch.parse_scan(*line, readings)) continue;
        } catch (const FormatError&) {
            continue;  // counted when the line is read in earnest
        }
        if (readings.max_is_exact) return std::nullopt;
        ++scans;
        for (std::size_t i = 0; i < readings.ranges_m.size(); ++i) {
            const double range = readings.ranges_m[i];
            if (range > 0.0 && std::isfinite(range)) collected.push_back({range, i});
        }
    }
    return repeated_maximum(collected);
}

}  // namespace hitos
