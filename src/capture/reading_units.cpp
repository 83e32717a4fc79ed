// SPDX-License-Identifier: GPL-3.0-or-later
// Readings that are no metres.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hitos/base/median.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "laser_units.hpp"
#include "range_conversor.hpp"
#include "remedies.hpp"
#include "walls_beyond.hpp"

namespace hitos {
namespace {

/// Without the value that comes most often, where it comes as often as a code does.
void leave_out_code(std::vector<double>& values) {
    constexpr std::size_t kCode = 20;  // one in so many is alike
    std::ranges::sort(values);
    auto most_begin = values.begin();
    auto most_end = values.begin();
    for (auto at = values.begin(); at != values.end();) {
        const auto end = std::upper_bound(at, values.end(), *at);
        if (end - at > most_end - most_begin) {
            most_begin = at;
            most_end = end;
        }
        at = end;
    }
    const auto most = static_cast<std::size_t>(most_end - most_begin);
    if (kCode * most > values.size()) values.erase(most_begin, most_end);
}

/// How much of the way the first scans show were they read so.
double way_shown(const Fuente& fuente, const ReadOptions& options) {
    constexpr int kScans = 2000;
    TourExamination examination(options);
    Procesador tour(fuente.opening(), options);
    double last_s = 0.0;
    for (int i = 0; i < kScans; ++i) {
        const std::optional<Scan> scan = tour.next_scan();
        if (!scan) break;
        last_s = scan->time_s;
        examination.note(*scan);
    }
    while (const std::optional<Odometria> reading = tour.next_odometry()) {
        examination.note(*reading);
        if (reading->time_s > last_s) break;
    }
    return examination.way_shown(1.0);
}

/// What the readings may be, all of which lie beyond the limit: metres that reach as far as they
/// do, or another unit.
struct Meant {
    const char* unit = nullptr;  ///< nothing: metres
    double scale = 1.0;
    double max_range_m = 0.0;
};

std::vector<SourceSetting> reach(double max_range_m) {
    return set("source.max_range", fmt::format("{:.4g}", max_range_m));
}

/// What the scans fit the odometry with, where there is such.
std::optional<Meant> meant_by(const Fuente& fuente, const ReadOptions& asked, double limit_m,
                              double farthest) {
    std::optional<Meant> best;
    double most = kWayShown;
    const auto try_out = [&](const Meant& meant) {
        ReadOptions options = asked;
        options.range_scale *= meant.scale;
        options.max_range_m = meant.max_range_m;
        const double shown = way_shown(fuente, options);
        if (shown <= most) return;
        most = shown;
        best = meant;
    };
    try_out({nullptr, 1.0, farthest});
    for (const LengthUnit& unit : kLengthUnits) {
        try_out({unit.name, unit.metres, std::min(limit_m, farthest * unit.metres)});
    }
    return best;
}

}  // namespace

std::optional<TourFinding> doubt_units(const Fuente& fuente, const ReadOptions& options,
                                       RangeConversor& conversor) {
    constexpr double kNearlyAll = 0.8;  // of centimetres a few lie within
    constexpr double kFar = 100.0;      // less may be metres
    constexpr std::size_t kLeastReadings = 100;
    std::vector<double> all;
    double limit_m = 0.0;
    bool stated = false;
    WallsBeyond walls;
    look_at_readings(fuente, conversor, [&](const RangeConversor::Readings& readings) {
        limit_m = conversor.limit(readings);
        stated = readings.fan.max_range_m > 0.0;
        walls.note(readings.ranges_m, limit_m);
        for (const double range : readings.ranges_m) {
            if (!(range > 0.0) || !std::isfinite(range)) continue;
            all.push_back(range);
        }
        return true;
    });
    if (all.empty()) return std::nullopt;
    const double farthest = std::ranges::max(all);
    leave_out_code(all);
    const auto beyond = std::ranges::count_if(all, [&](double range) { return range >= limit_m; });
    const double typical = median(all);
    const double share = static_cast<double>(beyond) / static_cast<double>(all.size());
    if (all.size() < kLeastReadings) return std::nullopt;
    const double seen = static_cast<double>(walls.count) / static_cast<double>(all.size());
    if (share < kNearlyAll) {
        if (!stated || options.max_range_m > 0.0 || seen < WallsBeyond::kMost) return std::nullopt;
        return TourFinding{
            TourFinding::Kind::blind_laser,
            seen,
            message(HITOS_TEXT("Errors",
                               "%1 % of the readings lie beyond the greatest range of %2 m that "
                               "the log states, where they go on from ray to ray as walls do, and "
                               "are no points"),
                    std::lround(100.0 * seen), fmt::format("{:.4g}", limit_m)),
            {{marked(HITOS_TEXT("Errors", "take them")), reach(std::ceil(walls.farthest_m))}}};
    }
    if (typical < kFar && !stated) return std::nullopt;  // outdoors
    const std::optional<Meant> meant = meant_by(fuente, options, limit_m, farthest);
    const Message what = message(
        HITOS_TEXT("Errors",
                   "%1 % of the readings lie beyond the greatest range of %2 m and are no "
                   "points; half of them are above %3"),
        std::lround(100.0 * share), fmt::format("{:.4g}", limit_m), fmt::format("{:.4g}", typical));
    if (meant && meant->unit == nullptr) {
        return TourFinding{TourFinding::Kind::blind_laser,
                           share,
                           what,
                           {{marked(HITOS_TEXT("Errors", "by the odometry they are metres")),
                             reach(meant->max_range_m)}}};
    }
    if (meant) {
        return TourFinding{
            TourFinding::Kind::laser_units,
            typical,
            what,
            {{message(HITOS_TEXT("Errors", "by the odometry they are %1"), marked(meant->unit)),
              WholeValues(options).range_scale(meant->scale) + reach(meant->max_range_m)}}};
    }
    if (typical < kFar) {
        return TourFinding{TourFinding::Kind::blind_laser,
                           share,
                           what,
                           {{marked(HITOS_TEXT("Errors", "if they are metres")), reach(farthest)}}};
    }
    return TourFinding{TourFinding::Kind::laser_units, typical, what,
                       millimetres_or_centimetres(options)};
}

}  // namespace hitos
