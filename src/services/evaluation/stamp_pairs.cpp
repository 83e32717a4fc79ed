// SPDX-License-Identifier: GPL-3.0-or-later
#include "stamp_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <queue>
#include <tuple>

namespace hitos {
namespace {

/// A pose of one of two trajectories in the order of all stamps.
struct Stamp {
    double time_s = 0.0;
    bool of_reference = false;
    std::size_t index = 0;
};

// [s] A robot indoors drives straight enough for so long.
constexpr double kLongestGap = 0.5;

/// Strictly between two poses that are near enough.
std::optional<Pose> interpolated(const Trajectory& by_stamp, double time_s, double tolerance_s) {
    const auto after = std::ranges::lower_bound(by_stamp, time_s, {}, &StampedPose::time_s);
    if (after == by_stamp.begin() || after == by_stamp.end() || !(after->time_s > time_s))
        return std::nullopt;
    const StampedPose& before = *std::prev(after);
    const double gap = after->time_s - before.time_s;
    if (!(gap <= std::max(kLongestGap, 2.0 * tolerance_s))) return std::nullopt;
    const double share = (time_s - before.time_s) / gap;
    const Pose& a = before.pose;
    const Pose& b = after->pose;
    return Pose{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
                wrap_angle(a.theta + share * wrap_angle(b.theta - a.theta))};
}

}  // namespace

// The two nearest that are left always stand side by side in the order of stamps, so a list of what
// is left and a queue of its neighbours suffice.
std::vector<std::pair<std::size_t, std::size_t>> pairs_by_stamp(const Trajectory& estimate,
                                                                const Trajectory& reference,
                                                                double tolerance_s) {
    std::vector<Stamp> stamps;
    for (std::size_t i = 0; i < estimate.size(); ++i) {
        if (std::isfinite(estimate[i].time_s)) stamps.push_back({estimate[i].time_s, false, i});
    }
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (std::isfinite(reference[i].time_s)) stamps.push_back({reference[i].time_s, true, i});
    }
    std::ranges::stable_sort(stamps, {}, &Stamp::time_s);

    const std::size_t none = stamps.size();
    std::vector<std::size_t> before(stamps.size());
    std::vector<std::size_t> after(stamps.size());
    std::vector<char> used(stamps.size(), 0);
    using Candidate = std::tuple<double, std::size_t, std::size_t>;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
    const auto consider = [&](std::size_t left, std::size_t right) {
        if (left == none || right == none) return;
        if (stamps[left].of_reference == stamps[right].of_reference) return;
        const double apart = stamps[right].time_s - stamps[left].time_s;
        if (apart <= tolerance_s) candidates.emplace(apart, left, right);
    };
    for (std::size_t i = 0; i < stamps.size(); ++i) {
        before[i] = i == 0 ? none : i - 1;
        after[i] = i + 1;
        consider(i, after[i]);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    while (!candidates.empty()) {
        const auto [apart, left, right] = candidates.top();
        candidates.pop();
        if (used[left] != 0 || used[right] != 0) continue;
        used[left] = used[right] = 1;
        const auto& [of_estimate, of_reference] =
            stamps[left].of_reference ? std::pair(right, left) : std::pair(left, right);
        pairs.emplace_back(stamps[of_estimate].index, stamps[of_reference].index);
        const std::size_t outer_left = before[left];
        const std::size_t outer_right = after[right];
        if (outer_left != none) after[outer_left] = outer_right;
        if (outer_right != none) before[outer_right] = outer_left;
        consider(outer_left, outer_right);
    }
    std::ranges::sort(pairs);
    return pairs;
}

std::vector<Matched> matched_by_stamp(const Trajectory& estimate, const Trajectory& reference,
                                      double tolerance_s) {
    Trajectory by_stamp = reference;
    std::erase_if(by_stamp, [](const StampedPose& pose) { return !std::isfinite(pose.time_s); });
    std::ranges::stable_sort(by_stamp, {}, &StampedPose::time_s);
    std::vector<Matched> matched;
    Trajectory rest;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < estimate.size(); ++i) {
        if (const auto there = interpolated(by_stamp, estimate[i].time_s, tolerance_s)) {
            matched.push_back({i, *there});
        } else {
            rest.push_back(estimate[i]);
            places.push_back(i);
        }
    }
    for (const auto& [own, other] : pairs_by_stamp(rest, by_stamp, tolerance_s)) {
        matched.push_back({places[own], by_stamp[other].pose});
    }
    std::ranges::sort(matched, {}, &Matched::estimate);
    return matched;
}

std::optional<Pose> pose_at(const Trajectory& by_stamp, double time_s, double tolerance_s) {
    if (const auto there = interpolated(by_stamp, time_s, tolerance_s)) return there;
    const StampedPose* nearest = nearest_pose(by_stamp, time_s, tolerance_s);
    return nearest != nullptr ? std::optional(nearest->pose) : std::nullopt;
}

const StampedPose* nearest_pose(const Trajectory& by_stamp, double time_s, double tolerance_s) {
    const auto after = std::ranges::lower_bound(by_stamp, time_s, {}, &StampedPose::time_s);
    const StampedPose* nearest = nullptr;
    double apart = tolerance_s;
    const auto offer = [&](const StampedPose& pose) {
        const double away = std::abs(pose.time_s - time_s);
        if (!(away <= apart)) return;
        apart = away;
        nearest = &pose;
    };
    if (after != by_stamp.begin()) offer(*std::prev(after));
    if (after != by_stamp.end()) offer(*after);
    return nearest;
}

}  // namespace hitos
