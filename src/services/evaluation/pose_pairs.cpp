// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/pose_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hitos {
namespace {

constexpr double kStampStep = 1e-6;  // [s]

/// From pose to pose [m] or [s], one less than poses.
std::vector<double> steps_of(const Trajectory& trajectory, PairSpacing::By by) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
        const StampedPose& a = trajectory[i - 1];
        const StampedPose& b = trajectory[i];
        const double dx = b.pose.x - a.pose.x;
        const double dy = b.pose.y - a.pose.y;
        // Between two tours no time of a tour passes.
        steps.push_back(by == PairSpacing::By::time ? (b.begins ? 0.0 : b.time_s - a.time_s)
                                                    : std::sqrt(dx * dx + dy * dy));
    }
    return steps;
}

std::vector<PosePair> overlapping(const std::vector<double>& steps, const PairSpacing& spacing) {
    std::vector<double> place(1, 0.0);
    for (const double step : steps) place.push_back(place.back() + step);
    std::vector<PosePair> pairs;
    for (std::size_t i = 0; i + 1 < place.size(); ++i) {
        const auto away = [&](double there) { return there - place[i]; };
        const auto begin = place.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        auto best = std::ranges::lower_bound(begin, place.end(), spacing.length, {}, away);
        // The one before may be nearer; of several at its place the first.
        if (best != begin && (best == place.end() || spacing.length - away(*std::prev(best)) <=
                                                         away(*best) - spacing.length)) {
            best = std::ranges::lower_bound(begin, best, away(*std::prev(best)), {}, away);
        }
        if (!(std::abs(away(*best) - spacing.length) <= spacing.length * spacing.tolerance))
            continue;
        pairs.push_back({i, static_cast<std::size_t>(best - place.begin())});
    }
    return pairs;
}

std::vector<PosePair> consecutive(const std::vector<double>& steps, const PairSpacing& spacing) {
    const double slack = spacing.by == PairSpacing::By::time ? kStampStep : 0.0;
    std::vector<std::size_t> marks;
    double way = 0.0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        way += steps[i];
        if (!(way >= spacing.length - slack)) continue;
        marks.push_back(i + 1);
        way = 0.0;
    }
    std::vector<PosePair> pairs;
    for (std::size_t k = 1; k < marks.size(); ++k) pairs.push_back({marks[k - 1], marks[k]});
    return pairs;
}

}  // namespace

std::vector<PosePair> pose_pairs(const Trajectory& trajectory, const PairSpacing& spacing) {
    if (!(spacing.length > 0.0) || !std::isfinite(spacing.length)) return {};
    const std::vector<double> steps = steps_of(trajectory, spacing.by);
    return spacing.consecutive ? consecutive(steps, spacing) : overlapping(steps, spacing);
}

}  // namespace hitos
