// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/reference_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "stamp_pairs.hpp"

namespace hitos {
namespace {

constexpr std::size_t kFewest = 3;   // poses: two fit any two others but for their distance
constexpr double kLeastShare = 0.1;  // of the path's time
constexpr double kByChance = 0.1;    // of the stamps of two clocks some agree,
constexpr std::size_t kFew = 10;     // but not many

/// The earliest and the latest stamp [s]; whoever calls has one that is finite.
std::pair<double, double> times_of(const Trajectory& path) {
    std::pair<double, double> times{INFINITY, -INFINITY};
    for (const StampedPose& pose : path) {
        if (!std::isfinite(pose.time_s)) continue;
        times.first = std::min(times.first, pose.time_s);
        times.second = std::max(times.second, pose.time_s);
    }
    return times;
}

}  // namespace

std::optional<Advice> ReferenceFit::doubt() const {
    if (shape) return shape;
    if (2 * common >= poses) return std::nullopt;
    return Advice{HITOS_TEXT("Advice",
                             "The reference trajectory tells of less than half of the scans (%1), "
                             "and the errors are of these alone: is it of this whole tour?"),
                  fmt::format("{}/{}", common, poses),
                  {}};
}

ReferenceFit fit_of_reference(const Trajectory& path, const Trajectory& reference,
                              double tolerance_s) {
    ReferenceFit fit{path.size(), matched_by_stamp(path, reference, tolerance_s).size()};
    const auto [from, to] = times_of(path);
    const auto [other_from, other_to] = times_of(reference);
    const double begin = std::max(from, other_from);
    const double end = std::min(to, other_to);
    const bool brief = to > from && !(end - begin >= kLeastShare * (to - from));
    const auto meanwhile = [&](const Trajectory& poses) {
        return std::ranges::count_if(poses, [&](const StampedPose& pose) {
            return pose.time_s >= begin && pose.time_s <= end;
        });
    };
    const auto most = static_cast<double>(std::min(meanwhile(path), meanwhile(reference)));
    const bool by_chance = fit.common < kFew && static_cast<double>(fit.common) < kByChance * most;
    if (fit.common >= std::min(kFewest, fit.poses) && !brief && !by_chance) {
        fit.shape = doubt_of_shape(path, reference, tolerance_s);
        return fit;
    }
    const auto seconds = [](double time_s) { return fmt::format("{:.3f}", time_s); };
    throw Error(message(
        HITOS_TEXT("Errors",
                   "the reference trajectory is not one of this tour: %1 of %2 poses have one of "
                   "it within %3 s; the tour goes from second %4 to %5, the reference from %6 to "
                   "%7; expected the true path of this very tour, of a tenth of its time at least, "
                   "with stamps of the same clock in seconds (hitos-cli run and evaluate take "
                   "poses that are further away with --tolerance)"),
        fit.common, fit.poses, fmt::format("{:g}", tolerance_s), seconds(from), seconds(to),
        seconds(other_from), seconds(other_to)));
}

ReferenceFit fit_of_reference(const TourReader& tour, const Trajectory& reference,
                              double tolerance_s) {
    Trajectory stamps;
    const std::unique_ptr<TourReader> reader = tour.reopen();
    while (const std::optional<Scan> scan = reader->next_scan()) {
        stamps.push_back({scan->stamp_s(), {}});
    }
    if (stamps.empty()) return {};  // whoever runs it says so
    return fit_of_reference(stamps, reference, tolerance_s);
}

}  // namespace hitos
