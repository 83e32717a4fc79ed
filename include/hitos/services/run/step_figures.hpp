// SPDX-License-Identifier: GPL-3.0-or-later
// What a run's single steps say in numbers, and the conditions on them by which a run stops.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "hitos/services/evaluation/position_error.hpp"
#include "hitos/services/run/algoritmo.hpp"

namespace hitos {

/// The figures of one scan. All but step_seconds are the same in every run.
struct StepFigures {
    double time_s = 0.0;  ///< stamp of the scan, since that of the first one
    StampedPose online;   ///< as Algoritmo::online_trajectory()
    Pose mean;            ///< as SlamFilter::mean_pose(), and its covariance
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double neff = 0.0;
    double best_log_weight = 0.0;
    double step_seconds = 0.0;  ///< of wall time, for the whole step
    int lines = 0;              ///< landmarks of the best hypothesis
    int corners = 0;
    int seen_lines = 0;  ///< features found in the scan
    int seen_corners = 0;
    int matched = 0;  ///< what the best hypothesis made of them
    int created = 0;
    int ignored = 0;
    double unseen_s = 0.0;      ///< the longest that a landmark matched now had not been seen
    std::uint64_t skipped = 0;  ///< damaged lines of the log so far
    bool resampled = false;
    bool best_changed = false;  ///< as FilterStatistics::best_changed
    bool loop_closed = false;   ///< by registration
};

/// Of the last step.
StepFigures figures_of(const Algoritmo& run, double step_seconds);

/// Against the reference: the NEES of a scan's pose (pose_nees()); nothing where it says nothing.
std::optional<double> nees_of(const StepFigures& figures, PositionError& reference);

/// A table with one line a scan and a heading, comma separated, RFC 4180: the members of
/// StepFigures but mean and covariance, and where there is a reference the position error [m]
/// (PositionError) and the NEES of the pose.
std::string figures_to_csv(std::span<const StepFigures> figures, const Trajectory* reference,
                           double tolerance_s = kSameStamp);
/// Writes it atomically. Throws FileError.
void write_figures(std::span<const StepFigures> figures, const Trajectory* reference,
                   const std::filesystem::path& path, double tolerance_s = kSameStamp);

/// What stopped a run.
enum class StopReason : std::uint8_t {
    none,
    time,
    neff,
    landmark_born,
    seen_again,
    loop_closed,
    best_changed,
    error,
};

/// The conditions by which a run stops; those that are not set do not count.
struct StopRules {
    std::optional<std::uint64_t> scan = std::nullopt;  ///< after so many scans; that is no reason
    std::optional<double> time_s = std::nullopt;  ///< at the first scan so long after the first one
    std::optional<double> neff_below = std::nullopt;  ///< before resampling
    bool landmark_born = false;                       ///< in the best hypothesis
    std::optional<double> seen_again_after_s =
        std::nullopt;           ///< a landmark that was not seen for so long
    bool loop_closed = false;   ///< by registration
    bool best_changed = false;  ///< another hypothesis becomes the best
    std::optional<double> position_error_above_m = std::nullopt;  ///< PositionError

    /// The first one that the step meets.
    StopReason met(const StepFigures& step, std::optional<double> position_error_m) const;
};

}  // namespace hitos
