// SPDX-License-Identifier: GPL-3.0-or-later
#include "split_and_merge.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace hitos {
namespace {

/// Whether the laser sees further round than half a turn, as the thesis's does not. Of a fan that
/// is not known the points tell: it has some well to either side of the first.
bool beyond_half_a_turn(const Scan& scan) {
    const Fan& fan = scan.fan;
    if (fan.count > 0) {
        return std::abs(fan.max_angle_rad - fan.min_angle_rad) > kPi + std::abs(fan.step_rad());
    }
    constexpr double kWell = 0.1;  // [rad]
    bool left = false;
    bool right = false;
    for (const Point2& p : scan.points) {
        const Point2& first = scan.points.front();
        const double side = first.x * p.y - first.y * p.x;
        const double well = kWell * std::hypot(first.x, first.y) * std::hypot(p.x, p.y);
        left |= side > well;
        right |= side < -well;
    }
    return left && right;
}

}  // namespace

bool SplitAndMerge::gap_between(const Point2& a, const Point2& b, const Point2& laser) const {
    if (params_.gap_m == 0.0 && params_.gap_per_range == 0.0) return false;
    const double range = std::min(distance(a, laser), distance(b, laser));
    return distance(a, b) > params_.gap_m + params_.gap_per_range * range;
}

std::span<const Point2> SplitAndMerge::without_strangers(std::span<const Point2> points) const {
    std::span<const Point2> most;
    std::size_t first = 0;
    for (std::size_t i = 1; i <= points.size(); ++i) {
        if (i < points.size() && distance(points[i - 1], points[i]) <= lines_.min_length_m)
            continue;
        if (i - first > most.size()) most = points.subspan(first, i - first);
        first = i;
    }
    return most;
}

bool SplitAndMerge::split_at_far_side(const Scan& scan, std::uint32_t begin, std::uint32_t end) {
    // Where the ends are neighbours, the line through them has the direction of their errors, or
    // that of a wall that another one faces, all of it equally far.
    const Point2& a = scan.points[begin];
    double farthest = 2.0 * distance(a, scan.points[end]);
    std::uint32_t at = end;
    for (std::uint32_t i = begin + 1; i < end; ++i) {
        const double d = distance(a, scan.points[i]);
        if (d > farthest) {
            farthest = d;
            at = i;
        }
    }
    if (at == end) return false;
    pending_.emplace_back(at + 1, end);
    pending_.emplace_back(begin, at);
    return true;
}

void SplitAndMerge::split(const Scan& scan, std::uint32_t first, std::uint32_t last) {
    // A stack of index ranges instead of recursion: a scan of many rays must not grow the call
    // stack. The left half is taken first, so pieces come in scan order.
    pending_.assign(1, {first, last});
    while (!pending_.empty()) {
        const auto [begin, end] = pending_.back();
        pending_.pop_back();
        if (end - begin + 1 < static_cast<std::uint32_t>(lines_.min_points)) continue;
        const Point2& a = scan.points[begin];
        const Point2& b = scan.points[end];
        const double length = distance(a, b);
        const bool long_enough = length >= lines_.min_length_m && length > 0.0;
        // Before it is split [T table 4.3]; but the ends of a run that leads round the laser may
        // lie side by side, however long its walls are.
        if (!long_enough && !beyond_half_a_turn_) continue;
        // Distance from the chord, as a cross product: no angle is needed to split.
        const double nx = length > 0.0 ? (b.y - a.y) / length : 0.0;
        const double ny = length > 0.0 ? (a.x - b.x) / length : 0.0;
        double farthest = -1.0;
        std::uint32_t at = begin;
        for (std::uint32_t i = begin + 1; i < end; ++i) {
            const double d =
                std::abs((scan.points[i].x - a.x) * nx + (scan.points[i].y - a.y) * ny);
            if (d > farthest) {
                farthest = d;
                at = i;
            }
        }
        if (!long_enough && split_at_far_side(scan, begin, end)) continue;
        if (farthest < params_.dmax_m) {
            if (!long_enough) continue;
            std::span<const Point2> points(&scan.points[begin], end - begin + 1);
            if (beyond_half_a_turn_) {
                points = without_strangers(points);
                if (points.size() < static_cast<std::size_t>(lines_.min_points) ||
                    distance(points.front(), points.back()) < lines_.min_length_m) {
                    continue;
                }
            }
            pieces_.push_back(
                {points, fit_line(points, {points.front(), points.back()}, params_.fit)});
        } else {
            // Disjoint halves, the first up to the point of the split [T tables 4.1, 4.3].
            pending_.emplace_back(at + 1, end);
            pending_.emplace_back(begin, at);
        }
    }
}

void SplitAndMerge::extract_lines(const Scan& scan, Observation& out) {
    pieces_.clear();
    beyond_half_a_turn_ = beyond_half_a_turn(scan);
    const Point2 laser{scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y};
    for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
        const std::uint32_t run_end = scan.run_end(run);
        std::uint32_t begin = scan.run_starts[run];
        for (std::uint32_t i = begin + 1; i <= run_end; ++i) {
            if (i == run_end || gap_between(scan.points[i - 1], scan.points[i], laser)) {
                split(scan, begin, i - 1);
                begin = i;
            }
        }
    }

    merge_collinear(pieces_, lines_.collinear, params_.fit, scan.fan.closed(), out);
}

LineMethodEntry split_and_merge_method() {
    LineMethodEntry entry;
    entry.word = "split-merge";
    entry.label = HITOS_TEXT("ParameterChoice", "Split and Merge");
    entry.purpose = "divides runs of points at the farthest one";
    entry.reads = {"split_merge.dmax", "split_merge.fit", "split_merge.gap",
                   "split_merge.gap_per_range"};
    entry.random = false;
    entry.make = [](const ExtractionParams& params, std::uint64_t /*seed*/) {
        return std::make_unique<SplitAndMerge>(params.lines, params.split_merge);
    };
    return entry;
}

}  // namespace hitos
