// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of a run, closed and refused: where they are, and whether they are true.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/registration/loop_record.hpp"

namespace hitos {

/// A closure further from the reference, or turned further against it, is false [m], [rad].
inline constexpr double kFalseLoop = 1.0;
inline constexpr double kFalseTurn = 0.3;

/// A loop with its two scans on the path.
struct RunLoop {
    LoopRecord record;
    StampedPose scan;
    StampedPose earlier;
    /// How far the later scan lies from where the reference has it, seen from the earlier one, as
    /// the loop has it [m]; nothing where the reference does not tell.
    std::optional<double> error_m = std::nullopt;
    std::optional<double> error_rad = std::nullopt;  ///< likewise, how far it is turned

    bool is_false() const { return error_m > kFalseLoop || error_rad > kFalseTurn; }
    bool closed() const { return record.verdict == LoopVerdict::closed; }
};

/// All of them by their scans. The path has a pose for every scan.
std::vector<RunLoop> run_loops(std::span<const LoopRecord> closed,
                               std::span<const LoopRecord> refused, const Trajectory& path);

/// Sets the errors by a reference, whose poses are interpolated as trajectory_error() does it. One
/// whose headings are all the same tells nothing: it has none.
void judge_loops(std::vector<RunLoop>& loops, const Trajectory& reference, double tolerance_s);

/// Of the closed ones.
struct LoopPrecision {
    std::uint64_t judged = 0;  ///< of which the reference tells
    std::uint64_t wrong = 0;   ///< of these
    double worst_m = 0.0;
    double worst_rad = 0.0;
};
LoopPrecision precision_of(std::span<const RunLoop> loops);

/// A row a loop, scans counted from 1. A figure that there is not is an empty field.
std::string loops_csv(std::span<const RunLoop> loops);

}  // namespace hitos
