// Readings that are no metres.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hitos/base/median.hpp"
#include "hitos/base/translatable.hpp"
#include "range_conversor.hpp"

namespace hitos {
namespace {

/// How often the value is there that is there most often.
std::size_t most_alike(std::vector<double> values) {
    std::ranges::sort(values);
    std::size_t most = 0;
    for (auto at = values.begin(); at != values.end();) {
        const auto end = std::upper_bound(at, values.end(), *at);
        most = std::max(most, static_cast<std::size_t>(end - at));
        at = end;
    }
    return most;
}

}  // namespace

std::optional<TourFinding> doubt_units(const Fuente& fuente, RangeConversor& conversor) {
    constexpr double kNearlyAll = 0.8;   // of centimetres a few lie within
    constexpr double kFar = 100.0;       // less may be metres
    constexpr std::size_t kOneCode = 2;  // half of them are alike
    constexpr std::size_t kLeastReadings = 100;
    std::vector<double> all;
    std::size_t beyond = 0;
    double limit_m = 0.0;
    bool stated = false;
    look_at_readings(fuente, conversor, [&](const RangeConversor::Readings& readings) {
        limit_m = conversor.limit(readings);
        stated = readings.fan.max_range_m > 0.0;
        for (const double range : readings.ranges_m) {
            if (!(range > 0.0) || !std::isfinite(range)) continue;
            all.push_back(range);
            if (range >= limit_m) ++beyond;
        }
        return true;
    });
    const double typical = median(all);
    const double share = static_cast<double>(beyond) / static_cast<double>(all.size());
    if (all.size() < kLeastReadings || share < kNearlyAll ||
        kOneCode * most_alike(all) > all.size()) {
        return std::nullopt;
    }
    if (typical < kFar) {
        if (!stated) return std::nullopt;  // outdoors
        return TourFinding{
            TourFinding::Kind::blind_laser, share,
            message(HITOS_TEXT("Errors",
                               "%1 % of the readings lie beyond the greatest range of %2 m and are "
                               "no points; half of them are above %3 m"),
                    std::lround(100.0 * share), fmt::format("{:.4g}", limit_m),
                    fmt::format("{:.1f}", typical)),
            marked(HITOS_TEXT("Errors", "set the greatest range: --set source.max_range=METRES"))};
    }
    return TourFinding{
        TourFinding::Kind::laser_units, typical,
        message(HITOS_TEXT("Errors",
                           "%1 % of the readings lie beyond the greatest range of %2 m and are no "
                           "points; half of them are above %3, as millimetres or centimetres are"),
                std::lround(100.0 * share), fmt::format("{:.4g}", limit_m),
                fmt::format("{:.0f}", typical)),
        marked(HITOS_TEXT("Errors", "write the readings in metres, which they are read as"))};
}

}  // namespace hitos
