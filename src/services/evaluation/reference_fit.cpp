// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/reference_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/features/control.hpp"
#include "reference_doubts.hpp"
#include "stamp_pairs.hpp"

namespace hitos {
namespace {

constexpr std::size_t kFewest = 3;   // poses: two fit any two others but for their distance
constexpr double kLeastShare = 0.1;  // of the path's time
constexpr double kByChance = 0.1;    // of the stamps of two clocks some agree,
constexpr std::size_t kFew = 10;     // but not many

/// The earliest and the latest stamp [s]; whoever calls has one that is finite.
std::pair<double, double> times_of(std::span<const StampedPose> path) {
    std::pair<double, double> times{INFINITY, -INFINITY};
    for (const StampedPose& pose : path) {
        if (!std::isfinite(pose.time_s)) continue;
        times.first = std::min(times.first, pose.time_s);
        times.second = std::max(times.second, pose.time_s);
    }
    return times;
}

/// Calls `take` with the first and the end of each tour's poses.
template <class Take>
void for_each_tour(const Trajectory& path, Take take) {
    for (std::size_t begin = 0; begin < path.size();) {
        std::size_t end = begin + 1;
        while (end < path.size() && !path[end].begins) ++end;
        take(begin, end);
        begin = end;
    }
}

/// Of the tours of which the reference tells anything.
std::size_t poses_of_tours(const Trajectory& path, const std::vector<Matched>& matched) {
    std::size_t poses = 0;
    for_each_tour(path, [&](std::size_t begin, std::size_t end) {
        const auto first = std::ranges::lower_bound(matched, begin, {}, &Matched::estimate);
        if (first != matched.end() && first->estimate < end) poses += end - begin;
    });
    return poses > 0 ? poses : path.size();
}

/// What the path's tours and a reference have in common, and how long those tours are that it
/// meets [s]: one may have the truth of a single tour, and the hours between two are none's.
/// Nothing where it meets none.
std::optional<std::pair<double, double>> time_in_common(const Trajectory& path, double from,
                                                        double to) {
    double common = 0.0;
    double met = 0.0;
    bool meets = false;
    for_each_tour(path, [&](std::size_t begin, std::size_t end) {
        const auto [first, last] = times_of(std::span(path).subspan(begin, end - begin));
        const double shared = std::min(last, to) - std::max(first, from);
        if (!(shared >= 0.0)) return;
        common += shared;
        met += last - first;
        meets = true;
    });
    return meets ? std::optional(std::pair(common, met)) : std::nullopt;
}

/// Stamps that it has twice, with two places.
std::optional<Advice> doubt_of_doubles(Trajectory reference) {
    constexpr double kApart = 0.1;  // [m]
    constexpr double kMany = 0.01;
    std::erase_if(reference, [](const StampedPose& pose) { return !std::isfinite(pose.time_s); });
    std::ranges::stable_sort(reference, {}, &StampedPose::time_s);
    std::size_t doubles = 0;
    double farthest_m = 0.0;
    for (std::size_t i = 1; i < reference.size(); ++i) {
        if (reference[i].time_s != reference[i - 1].time_s) continue;
        const Pose step = between(reference[i - 1].pose, reference[i].pose);
        const double apart_m = std::hypot(step.x, step.y);
        if (apart_m <= kApart) continue;
        ++doubles;
        farthest_m = std::max(farthest_m, apart_m);
    }
    if (static_cast<double>(doubles) <= kMany * static_cast<double>(reference.size())) return {};
    return Advice{
        HITOS_TEXT("Advice",
                   "The reference trajectory has two places at one stamp, up to %1 "
                   "apart: it is of two robots or tours, and errors against it are none."),
        fmt::format("{:.2f} m", farthest_m),
        {}};
}

}  // namespace

std::vector<Advice> ReferenceFit::doubts() const {
    std::vector<Advice> doubts;
    if (misfit) doubts.push_back(*misfit);
    if (headings) doubts.push_back(*headings);
    if (2 * common < poses) {
        doubts.push_back(
            {HITOS_TEXT("Advice",
                        "The reference trajectory tells of less than half of the scans (%1), and "
                        "the errors are of these alone: is it of this whole tour?"),
             fmt::format("{}/{}", common, poses),
             {}});
    }
    return doubts;
}

ReferenceFit fit_of_path(const Trajectory& path, const Trajectory& reference, double tolerance_s) {
    const std::vector<Matched> matched = matched_by_stamp(path, reference, tolerance_s);
    ReferenceFit fit{poses_of_tours(path, matched), matched.size()};
    PathPoints own;
    PathPoints there;
    for (const Matched& pair : matched) {
        own.emplace_back(path[pair.estimate].pose.x, path[pair.estimate].pose.y);
        there.emplace_back(pair.reference.x, pair.reference.y);
    }
    fit.misfit = doubt_of_doubles(reference);
    if (!fit.misfit) fit.misfit = doubt_of_clock(path, reference, tolerance_s);
    if (!fit.misfit) fit.misfit = doubt_of_shape(own, there);
    const HeadingsFit headings = fit_of_headings(path, matched);
    // What is mirrored turns the other way.
    if (!fit.misfit || headings.headings == Headings::none) fit.headings = headings.doubt();
    return fit;
}

ReferenceFit fit_of_reference(const Trajectory& path, const Trajectory& reference,
                              double tolerance_s) {
    ReferenceFit fit = fit_of_path(path, reference, tolerance_s);
    const auto [from, to] = times_of(path);
    const auto [other_from, other_to] = times_of(reference);
    const double begin = std::max(from, other_from);
    const double end = std::min(to, other_to);
    const auto shared = time_in_common(path, other_from, other_to);
    const bool brief = to > from && !(shared && shared->first >= kLeastShare * shared->second);
    const auto meanwhile = [&](const Trajectory& poses) {
        return std::ranges::count_if(poses, [&](const StampedPose& pose) {
            return pose.time_s >= begin && pose.time_s <= end;
        });
    };
    const auto most = static_cast<double>(std::min(meanwhile(path), meanwhile(reference)));
    const bool by_chance = fit.common < kFew && static_cast<double>(fit.common) < kByChance * most;
    if (fit.common >= std::min(kFewest, path.size()) && !brief && !by_chance) return fit;
    const auto seconds = [](double time_s) { return fmt::format("{:.3f}", time_s); };
    throw Error(message(
        HITOS_TEXT("Errors",
                   "the reference trajectory is not one of this tour: %1 of %2 poses have one of "
                   "it within %3 s; the tour goes from second %4 to %5, the reference from %6 to "
                   "%7; expected the true path of this very tour, of a tenth of its time at least, "
                   "with stamps of the same clock in seconds (hitos-cli run and evaluate take "
                   "poses that are further away with --tolerance)"),
        fit.common, path.size(), fmt::format("{:g}", tolerance_s), seconds(from), seconds(to),
        seconds(other_from), seconds(other_to)));
}

ReferenceFit fit_by_odometry(const TourReader& tour, const Trajectory& reference,
                             double tolerance_s) {
    OdometryPath path;
    const std::unique_ptr<TourReader> reader = tour.reopen();
    ControlTrack track([&reader] { return reader->next_odometry(); });
    std::vector<Control> controls;
    while (const std::optional<Scan> scan = reader->next_scan()) {
        track.controls_until(*scan, controls);
        path.add(scan->stamp_s(), controls, scan->begins_tour.has_value());
    }
    if (path.trajectory().empty()) return {};  // whoever runs it says so
    return fit_of_reference(path.trajectory(), reference, tolerance_s);
}

ReferenceFit fit_of_reference(const TourReader& tour, const Trajectory& reference,
                              double tolerance_s) {
    Trajectory stamps;
    const std::unique_ptr<TourReader> reader = tour.reopen();
    while (const std::optional<Scan> scan = reader->next_scan()) {
        stamps.push_back({scan->stamp_s(), {}, scan->begins_tour.has_value()});
    }
    if (stamps.empty()) return {};  // whoever runs it says so
    return fit_of_reference(stamps, reference, tolerance_s);
}

}  // namespace hitos
