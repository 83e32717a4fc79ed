// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/run_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "hitos/base/text_table.hpp"
#include "stamp_pairs.hpp"

namespace hitos {

std::vector<RunLoop> run_loops(std::span<const LoopRecord> closed,
                               std::span<const LoopRecord> refused, const Trajectory& path) {
    std::vector<LoopRecord> records;
    // Both are in the order of their scans.
    std::ranges::merge(closed, refused, std::back_inserter(records), {}, &LoopRecord::scan,
                       &LoopRecord::scan);
    std::vector<RunLoop> loops;
    loops.reserve(records.size());
    for (const LoopRecord& record : records) {
        loops.push_back({record, path.at(record.scan), path.at(record.earlier)});
    }
    return loops;
}

void judge_loops(std::vector<RunLoop>& loops, const Trajectory& reference, double tolerance_s) {
    if (!std::ranges::is_sorted(reference, {}, &StampedPose::time_s)) {
        Trajectory sorted = reference;
        std::ranges::stable_sort(sorted, {}, &StampedPose::time_s);
        judge_loops(loops, sorted, tolerance_s);
        return;
    }
    const bool turns = std::ranges::any_of(reference, [&](const StampedPose& one) {
        return one.pose.theta != reference.front().pose.theta;
    });
    for (RunLoop& loop : loops) {
        loop.error_m.reset();
        loop.error_rad.reset();
        if (!turns) continue;
        const auto earlier = pose_at(reference, loop.earlier.time_s, tolerance_s);
        const auto later = pose_at(reference, loop.scan.time_s, tolerance_s);
        if (!earlier || !later) continue;
        const Pose there = between(*earlier, *later);
        const Pose& said = loop.record.pose_earlier_scan;
        loop.error_m = std::hypot(there.x - said.x, there.y - said.y);
        loop.error_rad = std::abs(wrap_angle(there.theta - said.theta));
    }
}

LoopPrecision precision_of(std::span<const RunLoop> loops) {
    LoopPrecision precision;
    for (const RunLoop& loop : loops) {
        if (!loop.closed() || !loop.error_m) continue;
        ++precision.judged;
        if (loop.is_false()) ++precision.wrong;
        precision.worst_m = std::max(precision.worst_m, *loop.error_m);
        precision.worst_rad = std::max(precision.worst_rad, loop.error_rad.value_or(0.0));
    }
    return precision;
}

std::string loops_csv(std::span<const RunLoop> loops) {
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{:.6f}", *value) : std::string();
    };
    std::string text = csv_line({"scan",         "earlier",        "verdict",
                                 "time_s",       "earlier_time_s", "x_m",
                                 "y_m",          "earlier_x_m",    "earlier_y_m",
                                 "seen_x_m",     "seen_y_m",       "seen_theta_rad",
                                 "way_m",        "score",          "overlap",
                                 "seen_through", "chi_square",     "chi_square_limit",
                                 "move_m",       "weight",         "error_m",
                                 "error_rad",    "by_hand",        "reason"});
    for (const RunLoop& loop : loops) {
        const LoopRecord& record = loop.record;
        const Pose& seen = record.pose_earlier_scan;
        text += csv_line({std::to_string(record.scan + 1),
                          std::to_string(record.earlier + 1),
                          std::string(word_of(record.verdict)),
                          number(loop.scan.time_s),
                          number(loop.earlier.time_s),
                          number(loop.scan.pose.x),
                          number(loop.scan.pose.y),
                          number(loop.earlier.pose.x),
                          number(loop.earlier.pose.y),
                          number(seen.x),
                          number(seen.y),
                          number(seen.theta),
                          number(record.way_m),
                          number(record.score),
                          number(record.overlap),
                          number(record.seen_through),
                          number(record.chi_square),
                          number(record.chi_square_limit),
                          loop.closed() ? number(record.move_m) : std::string(),
                          number(record.weight),
                          number(loop.error_m),
                          number(loop.error_rad),
                          record.by_hand ? "yes" : "",
                          reason_of(record).english()});
    }
    return text;
}

}  // namespace hitos
