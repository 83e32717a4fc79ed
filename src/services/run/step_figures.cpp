// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/step_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "hitos/base/atomic_file.hpp"
#include "hitos/services/evaluation/nees.hpp"
#include "hitos/services/files/tour_time.hpp"

namespace hitos {
namespace {

constexpr const char* kHeading =
    "scan,stamp_s,time_s,x_m,y_m,theta_rad,neff,best_log_weight,lines,corners,seen_lines,"
    "seen_corners,matched,created,ignored,unseen_s,skipped,resampled,best_changed,loop_closed,"
    "step_s";

/// Empty where there is nothing.
std::string cell(const std::optional<double>& value) {
    return value ? fmt::format(",{}", *value) : ",";
}

std::string row(std::size_t scan, const StepFigures& f) {
    const Pose& pose = f.online.pose;
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:d},{:d},{:d},{}", scan,
                       f.online.time_s, f.time_s, pose.x, pose.y, pose.theta, f.neff,
                       f.best_log_weight, f.lines, f.corners, f.seen_lines, f.seen_corners,
                       f.matched, f.created, f.ignored, f.unseen_s, f.skipped, f.resampled,
                       f.best_changed, f.loop_closed, f.step_seconds);
}

}  // namespace

StepFigures figures_of(const Algoritmo& run, double step_seconds) {
    const SlamFilter& filter = run.filter();
    const FilterStatistics statistics = filter.statistics();
    StepFigures figures;
    figures.time_s = run.duration_s();
    figures.online = run.online_trajectory().back();
    figures.mean = filter.mean_pose();
    figures.covariance = filter.pose_covariance();
    figures.neff = statistics.neff;
    figures.best_log_weight = statistics.best_log_weight;
    figures.step_seconds = step_seconds;
    figures.lines = filter.best_count(FeatureKind::line);
    figures.corners = filter.best_count(FeatureKind::corner);
    figures.seen_lines = static_cast<int>(run.observation().lines.size());
    figures.seen_corners = static_cast<int>(run.observation().corners.size());
    std::uint32_t unseen = 0;
    for (const Association& association : filter.associations()) {
        using Outcome = Association::Outcome;
        int& count = association.outcome == Outcome::matched   ? figures.matched
                     : association.outcome == Outcome::created ? figures.created
                                                               : figures.ignored;
        ++count;
        unseen = std::max(unseen, association.unseen);
    }
    if (unseen > 0) {
        const Trajectory& path = run.online_trajectory();
        figures.unseen_s = tour_duration_s(std::span(path).last(unseen + 1));
    }
    figures.skipped = run.report().skipped;
    figures.resampled = statistics.resampled;
    figures.best_changed = statistics.best_changed;
    figures.loop_closed = run.registration() != nullptr && !run.registration()->loops().empty() &&
                          run.registration()->loops().back().scan + 1 == run.steps();
    return figures;
}

std::optional<double> nees_of(const StepFigures& figures, PositionError& reference) {
    const std::optional<Pose> there = reference.reference_at(figures.online);
    return there ? pose_nees(figures.mean, figures.covariance, *there) : std::nullopt;
}

std::string figures_to_csv(std::span<const StepFigures> figures, const Trajectory* reference,
                           double tolerance_s) {
    std::optional<PositionError> error;
    if (reference != nullptr) error.emplace(*reference, tolerance_s);
    std::string text = kHeading;
    text += error ? ",position_error_m,pose_nees\n" : "\n";
    std::size_t scan = 0;
    for (const StepFigures& step : figures) {
        text += row(++scan, step);
        if (error) {
            text += cell(error->at(step.online)) + cell(nees_of(step, *error));
        }
        text += '\n';
    }
    return text;
}

void write_figures(std::span<const StepFigures> figures, const Trajectory* reference,
                   const std::filesystem::path& path, double tolerance_s) {
    write_file(path, figures_to_csv(figures, reference, tolerance_s));
}

StopReason StopRules::met(const StepFigures& step, std::optional<double> position_error_m) const {
    if (time_s && step.time_s >= *time_s) return StopReason::time;
    if (neff_below && step.neff < *neff_below) return StopReason::neff;
    if (landmark_born && step.created > 0) return StopReason::landmark_born;
    if (seen_again_after_s && step.unseen_s >= *seen_again_after_s) return StopReason::seen_again;
    if (loop_closed && step.loop_closed) return StopReason::loop_closed;
    if (best_changed && step.best_changed) return StopReason::best_changed;
    if (position_error_above_m && position_error_m && *position_error_m > *position_error_above_m) {
        return StopReason::error;
    }
    return StopReason::none;
}

}  // namespace hitos
