// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/thread_clock.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "hitos/slam/filters.hpp"
#include "json_input.hpp"
#include "loop_json.hpp"
#include "output_crew.hpp"
#include "report_json.hpp"
#include "results_summary.hpp"
#include "run_outputs.hpp"
#include "version.hpp"
#include "written_files.hpp"

namespace hitos {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const MapError& error) {
    return {{"mean_m", error.mean_m},
            {"maximum_m", error.maximum_m},
            {"landmarks", error.landmarks},
            {"without_reference", error.without_reference},
            {"reference_landmarks", error.reference_landmarks},
            {"reference_found", error.reference_found}};
}

ordered_json json_of(const TrajectoryError& error) {
    ordered_json json{{"ate_rmse_m", error.rmse_m},
                      {"ate_mean_m", error.mean_m},
                      {"ate_maximum_m", error.maximum_m}};
    if (error.heading_rmse_rad) json["heading_rmse_rad"] = *error.heading_rmse_rad;
    json["poses"] = error.poses;
    return json;
}

ordered_json json_of(const MeasuredDistance& measured) {
    ordered_json json{{"name", measured.distance.name}, {"true_m", measured.distance.true_m()}};
    if (measured.slam_m) {
        json["slam_m"] = *measured.slam_m;
        json["error_percent"] = *measured.error_percent();
    } else {
        json["missing"] = measured.missing;
    }
    return json;
}

ordered_json json_of(const ChangesByHand& counts) {
    return {{"closed", counts.closed},   {"refused", counts.refused},
            {"fixed", counts.fixed},     {"slips", counts.slips},
            {"anchors", counts.anchors}, {"met_nothing", counts.met_nothing}};
}

/// The drawing that the map is anchored to, in the map's frame, and what each anchor came to.
ordered_json json_of_drawing(const RegistrationFigures& figures) {
    ordered_json json{{"firm", figures.drawing->firm},
                      {"x", figures.drawing->pose.x},
                      {"y", figures.drawing->pose.y},
                      {"theta", figures.drawing->pose.theta}};
    const Pose start = inverse(figures.drawing->pose);
    json["start"] = {{"x", start.x}, {"y", start.y}, {"theta", start.theta}};
    json["anchors"] = ordered_json::array();
    for (const AnchorFigures& anchor : figures.anchors) {
        ordered_json& one = json["anchors"].emplace_back();
        one["change"] = anchor.change + 1;
        one["scan"] = anchor.scan + 1;
        one["off_m"] = anchor.off_m;
        if (anchor.off_rad) one["off_rad"] = *anchor.off_rad;
        one["chi_square"] = anchor.chi_square;
        one["chi_square_limit"] = anchor.chi_square_limit;
    }
    return json;
}

ordered_json json_of(const RunQuality& quality) {
    ordered_json json;
    if (quality.cells_per_point) {
        json["cells_per_point"] = *quality.cells_per_point;
        json["odometry_cells_per_point"] = *quality.odometry_cells_per_point;
    }
    if (const auto& figures = quality.registration) {
        json["mean_score"] = figures->mean_score;
        json["scans_compared"] = figures->scans;
        json["scans_unmatched"] = figures->unmatched;
        json["scans_breaking"] = ordered_json::array();
        for (const std::uint64_t scan : figures->breaks) json["scans_breaking"].push_back(scan + 1);
        for (const SecondTour& tour : figures->later_tours) {
            ordered_json& one = json["later_tours"].emplace_back();
            one["begin"] = tour.begin + 1;
            if (!tour.found) continue;
            one["found"] = *tour.found + 1;
            one["found_after_m"] = tour.way_m;
            one["found_beside"] = tour.beside + 1;
            if (tour.laid_from != tour.begin) one["laid_from"] = tour.laid_from + 1;
        }
        json["key_scans"] = figures->keys;
        json["loops_closed"] = std::ranges::count_if(quality.loops, &RunLoop::closed);
        json["loops"] = json_of(quality.loops, true);
        json["refused_loops"] = json_of(quality.loops, false);
        json["loop_searches"] = figures->loop_searches;
        json["loops_refused"] = figures->loops_refused;
        json["largest_correction_m"] = figures->largest_correction_m;
        if (figures->by_hand) json["by_hand"] = json_of(*figures->by_hand);
        if (figures->drawing) json["drawing"] = json_of_drawing(*figures);
        if (const LoopPrecision precision = precision_of(quality.loops); precision.judged > 0) {
            json["loops_judged"] = precision.judged;
            json["loops_false"] = precision.wrong;
            json["worst_loop_m"] = precision.worst_m;
            json["worst_loop_rad"] = precision.worst_rad;
        }
    }
    json["warnings"] = ordered_json::array();
    for (const Advice& warning : quality.warnings) json["warnings"].push_back(warning.words());
    if (quality.findings) {
        json["findings"] = ordered_json::array();
        for (const TourFinding& finding : *quality.findings)
            json["findings"].push_back(json_of(finding));
    }
    return json;
}

/// What does not stand there yet, beside others of its kind.
void state(const RunFigures& figures, ordered_json& json) {
    for (const Measure* measure : taken_measures()) {
        const std::optional<double>& value = figures[*measure];
        if (!value || measure->place.empty()) continue;
        const ordered_json::json_pointer place(measure->place);
        if (!json.contains(place)) json[place] = json_of(value, *measure);
    }
}

/// Of a path that is worse than what it was made of; there is a reference that tells of both.
void warn_of_worse_path(const Algoritmo& run, RunSummary& summary) {
    constexpr double kHardly = 0.01;  // [m]
    constexpr double kAsMuch = 1.05;
    const double path_m = summary.trajectory_error->rmse_m;
    const double odometry_m = summary.odometry_error->rmse_m;
    if (path_m <= std::max(odometry_m * kAsMuch, odometry_m + kHardly)) return;
    const bool registered = run.registration() != nullptr;
    // Which is for recordings: what a world is to show, it may show on purpose.
    const bool may_be = !run.configuration().extraction.circles.find &&
                        !run.shows_landmarks_alone() && !run.reader().truth();
    summary.quality.warnings.push_back(
        {registered ? HITOS_TEXT("Advice",
                                 "Odometry alone is nearer to the reference than the path (%1): "
                                 "look where the path breaks, and at its loops.")
                    : HITOS_TEXT("Advice",
                                 "Odometry alone is nearer to the reference than the path (%1): "
                                 "these parameters do not suit this tour."),
         fmt::format("{:.3f} < {:.3f} m", odometry_m, path_m),
         registered || !may_be ? std::string_view() : std::string_view("recorded")});
}

/// Of a path of the run; there is a reference.
std::optional<TrajectoryError> error_of(const Trajectory& path, const References& references) {
    return trajectory_error(path, *references.trajectory, references.tolerance_s);
}

/// Writes everything but the summary.
void write_files(const FinishedRun& finished, RunSummary& summary, const StagedFolder& folder,
                 const WritingObserver& told) {
    std::vector<const RunOutput*> wanted;
    for (const RunOutput& output : run_outputs()) {
        if (!output.wanted || output.wanted(finished)) wanted.push_back(&output);
    }
    const int threads = finished.run.configuration().run.threads;
    const std::size_t count = wanted.size() + 1;  // the summary too
    OutputCrew crew(finished, folder.path(), told, count);
    const std::vector<Message> reasons = crew.write(wanted, threads);
    for (std::size_t i = 0; summary.times && i < wanted.size(); ++i) {
        if (!reasons[i].empty()) continue;
        summary.times->files.push_back({wanted[i]->files(finished).front(), crew.seconds()[i]});
    }
    // Once more after all that may have read the tour again.
    if (told) told({kSummaryFile, count, count});
    std::vector<NotWritten> not_written;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (reasons[i].empty()) continue;
        not_written.push_back(
            {wanted[i]->files(finished).front(),
             reasons[i].replaced(folder.path().string(), folder.target().string())});
    }
    summary.not_written = std::move(not_written);
    summary.files = written_files(folder.path());
}

}  // namespace

std::string version() {
    return kVersion;
}

RunErrors errors_of(const Algoritmo& run, const LandmarkMap& map, const Trajectory& whole,
                    const References& references) {
    RunErrors errors;
    const std::vector<SecondTour> later_tours = run.later_tours();
    const Trajectory path = in_one_frame(whole, later_tours);
    if (references.map) {
        errors.map_error = map_error(map, *references.map);
        errors.aligned_map_error = aligned_map_error(map, *references.map);
    }
    if (references.trajectory) {
        errors.trajectory_error = error_of(path, references);
        errors.odometry_error = tour_by_tour_error(run.odometry_trajectory(), later_tours,
                                                   *references.trajectory, references.tolerance_s);
        const auto relative = [&](double length_m) {
            return relative_error(path, *references.trajectory, {.length = length_m},
                                  references.tolerance_s);
        };
        errors.relative_error_1m = relative(1.0);
        errors.relative_error_10m = relative(10.0);
    }
    if (!references.relations.empty()) {
        const RelationErrors measured =
            relation_errors(measure_relations(path, references.relations, references.tolerance_s));
        if (measured.used > 0) errors.relation_errors = measured;
    }
    return errors;
}

namespace {

RunSummary summary_of(const Algoritmo& run, const LandmarkMap& map, const Trajectory& path,
                      const References& references, const std::function<bool()>& stop) {
    RunSummary summary;
    summary.source = run.reader().name();
    summary.format = run.reader().format();
    summary.scans = run.steps();
    summary.finished = run.finished();
    summary.duration_s = run.duration_s();
    summary.algorithm = find_parameter("filter.algorithm").text(run.configuration());
    const FilterParams& filter = run.configuration().filter;
    summary.particles =
        slam_algorithms().reads(filter.algorithm, "filter.particles") ? filter.particles : 0;
    summary.seed = run.configuration().run.seed;
    if (const auto truth = run.reader().truth()) summary.tour_seed = truth->seed;
    summary.searches_cut = run.filter().statistics().searches_cut;
    summary.report = run.report();
    summary.suitability = run.suitability().figures();
    summary.advice = run.advice();
    summary.quality = judge(run.evidence(), path, stop);
    static_cast<RunErrors&>(summary) = errors_of(run, map, path, references);
    ReferenceFit fit;
    if (references.trajectory) {
        fit = fit_of_path(in_one_frame(path, run.later_tours()), *references.trajectory,
                          references.tolerance_s);
        if (fit.judges_loops())
            judge_loops(summary.quality.loops, *references.trajectory, references.tolerance_s);
    }
    summary.figures = figures_of({run.evidence(), run.filter(), map, path, summary, nullptr,
                                  summary.quality.registration ? &summary.quality.loops : nullptr});
    summary.distances = measure_distances(map, references.distances);
    if (references.trajectory) {
        summary.online_error =
            error_of(known_while_driving(run.online_trajectory(), run.later_tours()), references);
        const double delay_s = run.scan().delay_s;
        if (delay_s != 0.0 && !run.reader().truth()) {
            summary.advice.push_back(
                {HITOS_TEXT("Advice",
                            "Paths keep the scans' own stamps, without the %1 of the scan delay, "
                            "and the reference is compared by these: where its clock is the "
                            "odometry's, subtract them from its stamps."),
                 fmt::format("{:g} s", delay_s),
                 {}});
        }
        if (!summary.trajectory_error && error_of(path, references)) {
            summary.quality.warnings.push_back(
                {HITOS_TEXT("Advice",
                            "The reference trajectory tells only of a tour that was not found in "
                            "the map, so no error is told."),
                 {},
                 {}});
        } else if (!summary.trajectory_error) {
            summary.quality.warnings.push_back(
                {HITOS_TEXT("Advice",
                            "No pose of the reference trajectory is within %1 of a scan, so no "
                            "error is told: are the clocks the same? Of a slow reference "
                            "--tolerance takes poses that are further away."),
                 fmt::format("{:g} s", references.tolerance_s),
                 {}});
        } else {
            summary.reference_doubts = fit.doubts();
            // Of several tours odometry is measured one by one.
            if (summary.reference_doubts.empty() && run.later_tours().empty())
                warn_of_worse_path(run, summary);
        }
    }
    if (references.map) {
        if (const auto doubt = doubt_of_map(map, *references.map))
            summary.reference_doubts.push_back(*doubt);
    }
    std::ranges::copy(summary.reference_doubts, std::back_inserter(summary.quality.warnings));
    return summary;
}

}  // namespace

RunSummary summarize(const Algoritmo& run, const References& references,
                     const std::function<bool()>& stop) {
    return summary_of(run, run.filter().best_map(), run.best_trajectory(), references, stop);
}

std::string to_json(const RunSummary& summary, double seconds) {
    ordered_json json{
        {"hitos_version", version()},
        {"source", summary.source},
        {"format", summary.format},
        {"seed", summary.seed},
        {"algorithm", summary.algorithm},
        {"scans", summary.scans},
        {"finished", summary.finished},
        {"duration_s", summary.duration_s},
        {"run_seconds", seconds},
        {"scans_per_second", seconds > 0.0 ? static_cast<double>(summary.scans) / seconds : 0.0},
        {"landmarks", ordered_json::object()},
        {"log", json_of(summary.report)}};
    if (summary.tour_seed) json["tour_seed"] = *summary.tour_seed;
    if (summary.particles > 0) json["particles"] = summary.particles;
    if (summary.searches_cut > 0) json["association_searches_cut"] = summary.searches_cut;
    if (summary.map_error) json["map_error"] = json_of(*summary.map_error);
    if (summary.aligned_map_error) {
        json["map_error_aligned"] = json_of(summary.aligned_map_error->error);
    }
    if (summary.trajectory_error) json["trajectory_error"] = json_of(*summary.trajectory_error);
    if (summary.online_error) json["online_error"] = json_of(*summary.online_error);
    if (summary.odometry_error) json["odometry_error"] = json_of(*summary.odometry_error);
    for (const MeasuredDistance& measured : summary.distances)
        json["distances"].push_back(json_of(measured));
    json["suitability"] = {{"step_m", summary.suitability.step_m},
                           {"scatter_m", summary.suitability.scatter_m},
                           {"unmatched", summary.suitability.unmatched},
                           {"empty", summary.suitability.empty},
                           {"advice", ordered_json::array()}};
    for (const Advice& advice : summary.advice)
        json["suitability"]["advice"].push_back(advice.words());
    json["quality"] = json_of(summary.quality);
    for (const Advice& doubt : summary.reference_doubts)
        json["reference_doubts"].push_back(doubt.words());
    state(summary.figures, json);
    if (summary.times) json["times"] = json_of(*summary.times);
    json["not_written"] = ordered_json::array();
    for (const NotWritten& missing : summary.not_written) {
        json["not_written"].push_back(
            {{"file", missing.file}, {"reason", missing.reason.english()}});
    }
    json["files"] = json_of(summary.files);
    return json_text(json) + "\n";
}

std::string to_json(const ReadReport& report) {
    return json_text(json_of(report)) + "\n";
}

std::string to_json(std::span<const TourFinding> findings) {
    ordered_json json = ordered_json::array();
    for (const TourFinding& finding : findings) json.push_back(json_of(finding));
    return json_text(json) + "\n";
}

std::string to_json(std::span<const RunLoop> loops) {
    return json_text(json_of(loops)) + "\n";
}

std::string to_json(std::span<const MeasuredDistance> distances) {
    ordered_json json = ordered_json::array();
    for (const MeasuredDistance& measured : distances) json.push_back(json_of(measured));
    return json_text(json) + "\n";
}

RunSummary write_results(const Algoritmo& run, const References& references, double seconds,
                         StagedFolder& folder, const WritingObserver& told,
                         OdometryGridAhead* ahead, std::span<const std::string> also,
                         const std::function<bool()>& stop) {
    RunSummary summary;
    const Trajectory best = run.best_trajectory();
    FinishedRun finished{run,
                         references,
                         summary,
                         written_configuration(run, best),
                         best,
                         run.filter().best_map(),
                         {},
                         ahead,
                         also,
                         stop,
                         folder.target()};
    DoubtsAhead doubts;  // looked for beside the files
    if (!(stop && stop())) doubts = run.doubts();
    const double began = thread_seconds();
    summary = summary_of(run, finished.map, finished.best, references, stop);
    if (run.options().time_stages) {
        summary.times.emplace();
        summary.times->before = run.seconds_before();
        summary.times->stages = run.stages();
        summary.times->judging = thread_seconds() - began;
        if (run.registration() != nullptr)
            summary.times->registration = run.registration()->stages();
    }
    finished.segments = run.line_extents().of(finished.map, finished.best);
    try {
        write_files(finished, summary, folder, told);
        if (doubts.valid()) {
            const double waited = thread_seconds();  // or looked for now, where there is one thread
            take_findings(doubts.get(), summary.quality);
            if (summary.times) summary.times->judging += thread_seconds() - waited;
        }
        if (summary.times) summary.times->all = process_seconds();
        write_file(folder.path() / kSummaryFile, sealed(to_json(summary, seconds), kSummarySeal));
    } catch (const FileError& error) {
        // Nobody knows of the folder in which it really was.
        throw error.replaced(folder.path().string(), folder.target().string());
    } catch (const std::filesystem::filesystem_error& error) {
        const std::filesystem::path& place = error.path1().empty() ? folder.path() : error.path1();
        throw FileError(place.string(), system_message(error.code().value()))
            .replaced(folder.path().string(), folder.target().string());
    }
    folder.commit();
    return summary;
}

RunSummary write_results(const Algoritmo& run, const References& references, double seconds,
                         const std::filesystem::path& folder, const WritingObserver& told) {
    StagedFolder staged = results_folder(folder);
    return write_results(run, references, seconds, staged, told);
}

}  // namespace hitos
