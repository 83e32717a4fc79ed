#include "hitos/services/run/step_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "hitos/base/atomic_file.hpp"

namespace hitos {
namespace {

/// A column of the table: everything of StepFigures that is a figure.
struct FigureColumn {
    const char* name;
    std::string (*text)(const StepFigures&);
};

const std::array kColumns = {
    FigureColumn{"stamp_s",
                 [](const StepFigures& f) { return fmt::format("{}", f.online.time_s); }},
    FigureColumn{"time_s", [](const StepFigures& f) { return fmt::format("{}", f.time_s); }},
    FigureColumn{"x_m", [](const StepFigures& f) { return fmt::format("{}", f.online.pose.x); }},
    FigureColumn{"y_m", [](const StepFigures& f) { return fmt::format("{}", f.online.pose.y); }},
    FigureColumn{"theta_rad",
                 [](const StepFigures& f) { return fmt::format("{}", f.online.pose.theta); }},
    FigureColumn{"neff", [](const StepFigures& f) { return fmt::format("{}", f.neff); }},
    FigureColumn{"best_log_weight",
                 [](const StepFigures& f) { return fmt::format("{}", f.best_log_weight); }},
    FigureColumn{"lines", [](const StepFigures& f) { return fmt::format("{}", f.lines); }},
    FigureColumn{"corners", [](const StepFigures& f) { return fmt::format("{}", f.corners); }},
    FigureColumn{"seen_lines",
                 [](const StepFigures& f) { return fmt::format("{}", f.seen_lines); }},
    FigureColumn{"seen_corners",
                 [](const StepFigures& f) { return fmt::format("{}", f.seen_corners); }},
    FigureColumn{"matched", [](const StepFigures& f) { return fmt::format("{}", f.matched); }},
    FigureColumn{"created", [](const StepFigures& f) { return fmt::format("{}", f.created); }},
    FigureColumn{"ignored", [](const StepFigures& f) { return fmt::format("{}", f.ignored); }},
    FigureColumn{"unseen_s", [](const StepFigures& f) { return fmt::format("{}", f.unseen_s); }},
    FigureColumn{"skipped", [](const StepFigures& f) { return fmt::format("{}", f.skipped); }},
    FigureColumn{"resampled",
                 [](const StepFigures& f) { return std::string(f.resampled ? "1" : "0"); }},
    FigureColumn{"best_changed",
                 [](const StepFigures& f) { return std::string(f.best_changed ? "1" : "0"); }},
    FigureColumn{"loop_closed",
                 [](const StepFigures& f) { return std::string(f.loop_closed ? "1" : "0"); }},
    FigureColumn{"step_s", [](const StepFigures& f) { return fmt::format("{}", f.step_seconds); }},
};

}  // namespace

StepFigures figures_of(const Algoritmo& run, double step_seconds) {
    const SlamFilter& filter = run.filter();
    const FilterStatistics statistics = filter.statistics();
    StepFigures figures;
    figures.time_s = run.duration_s();
    figures.online = run.online_trajectory().back();
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
        figures.unseen_s = path.back().time_s - path[path.size() - 1 - unseen].time_s;
    }
    figures.skipped = run.report().skipped;
    figures.resampled = statistics.resampled;
    figures.best_changed = statistics.best_changed;
    figures.loop_closed = run.registration() != nullptr && !run.registration()->loops().empty() &&
                          run.registration()->loops().back().scan + 1 == run.steps();
    return figures;
}

std::string figures_to_csv(std::span<const StepFigures> figures, const Trajectory* reference) {
    std::optional<PositionError> error;
    if (reference != nullptr) error.emplace(*reference);
    std::string text = "scan";
    for (const FigureColumn& column : kColumns) text += fmt::format(",{}", column.name);
    text += error ? ",position_error_m\n" : "\n";
    std::size_t scan = 0;
    for (const StepFigures& step : figures) {
        text += fmt::format("{}", ++scan);
        for (const FigureColumn& column : kColumns) text += "," + column.text(step);
        if (error) {
            const std::optional<double> away = error->at(step.online);
            text += away ? fmt::format(",{}", *away) : ",";
        }
        text += '\n';
    }
    return text;
}

void write_figures(std::span<const StepFigures> figures, const Trajectory* reference,
                   const std::filesystem::path& path) {
    write_file(path, figures_to_csv(figures, reference));
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
