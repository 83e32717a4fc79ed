// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli evaluate: the measures on finished files.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/path_crispness.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
#include "hitos/services/evaluation/run_loops.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "options.hpp"
#include "report.hpp"
#include "spacing_options.hpp"

namespace hitos::cli {
namespace {

struct EvaluateOptions {
    std::string run;
    std::string map;
    std::string reference;
    std::string trajectory;
    std::string reference_trajectory;
    std::string distances;
    std::string out;
    std::string relations;
    std::optional<double> rpe_distance_m;
    std::optional<double> rpe_time_s;
    PairSpacing rpe;
    CLI::Option* rpe_slack = nullptr;
    double tolerance_s = kSameStamp;
    CLI::Option* tolerance = nullptr;
    bool json = false;
    Trajectory estimate;       ///< read
    std::size_t left_out = 0;  ///< of its file, what lies in no frame with the others
};

std::filesystem::path out_file(const EvaluateOptions& options, const char* name) {
    prepare_output_folder(options.out);
    std::filesystem::path file = std::filesystem::path(options.out) / name;
    std::vector<std::filesystem::path> inputs;
    for (const std::string& input :
         {options.map, options.reference, options.trajectory, options.reference_trajectory,
          options.distances, options.relations}) {
        if (!input.empty()) inputs.emplace_back(input);
    }
    check_apart({&file, 1}, inputs);
    return file;
}

void evaluate_map(const EvaluateOptions& options, Report& report) {
    const LandmarkMap map = read_map(options.map);
    const LandmarkMap reference = read_map(options.reference);
    const auto error = map_error(map, reference);
    const auto aligned = aligned_map_error(map, reference);
    if (!error || !aligned) {
        throw FormatError(options.map, 0,
                          verbatim("has no landmark of a kind that the reference holds"));
    }
    report.figure("map_error_m", error->mean_m, 6);
    report.figure("map_error_aligned_m", aligned->error.mean_m, 6);
    report.figure("map_error_maximum_m", error->maximum_m, 6);
    report.count("landmarks", error->landmarks + error->without_reference);
    report.count("lines", error->lines);
    report.count("corners", error->corners);
    report.count("reference_landmarks", error->reference_landmarks);
    report.count("reference_found", error->reference_found);
    if (const auto doubt = doubt_of_map(map, reference)) report.warn(doubt->words());
}

void evaluate_distances(const EvaluateOptions& options, Report& report) {
    const std::vector<MeasuredDistance> measured =
        measure_distances(read_map(options.map), read_distances(options.distances));
    if (!options.out.empty()) {
        write_file(out_file(options, "distances.csv"), distances_csv(measured));
    }
    report.say("{}", distance_table(measured));
    report.object()["distances"] = parsed_object(to_json(measured));
}

std::string path_of(const std::filesystem::path& run) {
    return (run / "trajectory.tum").string();
}

/// Reads what is measured: of a run's own trajectory what lies in one frame.
void read_estimate(EvaluateOptions& options) {
    options.estimate = read_trajectory(options.trajectory);
    std::error_code none;
    if (options.run.empty() ||
        !std::filesystem::equivalent(options.trajectory, path_of(options.run), none)) {
        return;
    }
    const Trajectory known = in_one_frame(options.estimate, read_results(options.run).later_tours);
    options.left_out = options.estimate.size() - known.size();
    options.estimate = known;
}

void evaluate_trajectory(const EvaluateOptions& options, Report& report) {
    const Trajectory& estimate = options.estimate;
    const Trajectory reference = read_trajectory(options.reference_trajectory);
    const ReferenceFit fit = fit_of_reference(estimate, reference, options.tolerance_s);
    const auto error = trajectory_error(estimate, reference, options.tolerance_s);
    report.figure("ate_rmse_m", error->rmse_m, 6);
    report.figure("ate_mean_m", error->mean_m, 6);
    report.figure("ate_maximum_m", error->maximum_m, 6);
    if (error->heading_rmse_rad) report.figure("heading_rmse_rad", *error->heading_rmse_rad, 6);
    report.count("poses", error->poses);
    if (options.left_out > 0) {
        report.note(
            fmt::format("{} of the path are left out: they lie beside the map, in no frame "
                        "with the others, as of a tour that was not found in it",
                        plural(options.left_out, "pose")));
    }
    for (const Advice& doubt : fit.doubts()) report.warn(doubt.words());
}

constexpr int kErrorDecimals = 9;  // as evo prints them

void tell_figures(Report& report, const std::string& what, const char* unit,
                  const ErrorFigures& figures, double scale = 1.0) {
    const auto tell = [&](const char* which, double value) {
        report.figure(fmt::format("{}_{}_{}", what, which, unit), value * scale, kErrorDecimals);
    };
    tell("rmse", figures.rmse);
    tell("mean", figures.mean);
    tell("deviation", figures.deviation);
    tell("median", figures.median);
    tell("maximum", figures.maximum);
}

void tell_squares(Report& report, const char* what, const char* unit, const ErrorFigures& squares) {
    const auto tell = [&](const char* which, double value) {
        report.figure(fmt::format("{}_{}_{}", what, which, unit), value, kErrorDecimals);
    };
    tell("mean", squares.mean);
    tell("deviation", squares.deviation);
    tell("maximum", squares.maximum);
}

void tell_errors(Report& report, const std::string& what, const ErrorFigures& translation_m,
                 const ErrorFigures& rotation_rad) {
    tell_figures(report, what + "_translation", "m", translation_m);
    tell_figures(report, what + "_rotation", "rad", rotation_rad);
    tell_figures(report, what + "_rotation", "deg", rotation_rad, kDegreesPerRadian);
}

void evaluate_relative(const EvaluateOptions& options, PairSpacing::By by, double length,
                       Report& report) {
    const bool time = by == PairSpacing::By::time;
    PairSpacing spacing = options.rpe;
    spacing.by = by;
    spacing.length = length;
    const Trajectory& estimate = options.estimate;
    const Trajectory reference = read_trajectory(options.reference_trajectory);
    const auto error = relative_error(estimate, reference, spacing, options.tolerance_s);
    const auto whole = trajectory_error(estimate, reference, options.tolerance_s);
    if (!error && whole && !whole->heading_rmse_rad) return;  // as was said
    if (!error) {
        throw FormatError(options.trajectory, 0,
                          verbatim(fmt::format("has no two poses, both with one of the reference, "
                                               "that are {:g} {} apart; take a smaller {}",
                                               length, time ? "s" : "m of way",
                                               time ? "--rpe-time" : "--rpe-distance")));
    }
    const std::string name = time ? "rpe_time" : "rpe_distance";
    const std::string spacing_name = fmt::format("{}_{}", name, time ? "s" : "m");
    report.say("{} {:g}\n", spacing_name, length);
    report.object()[spacing_name] = length;
    report.count(name + "_pairs", error->pairs);
    tell_errors(report, name, error->translation_m, error->rotation_rad);
}

void evaluate_relations(const EvaluateOptions& options, Report& report) {
    const std::vector<MeasuredRelation> measured =
        measure_relations(options.estimate, read_relations(options.relations), options.tolerance_s);
    const RelationErrors errors = relation_errors(measured);
    if (!options.out.empty()) {
        write_file(out_file(options, "relations.csv"), relations_csv(measured));
    }
    if (errors.used == 0) {
        throw FormatError(
            options.trajectory, 0,
            verbatim(fmt::format("has no pose within {:g} s of both times of any of the relations; "
                                 "are the clocks the same? --tolerance takes poses that are "
                                 "further away",
                                 options.tolerance_s)));
    }
    report.count("relations", measured.size());
    report.count("relations_used", errors.used);
    report.count("relations_without_pose_at_t1", errors.without_from);
    report.count("relations_without_pose_at_t2", errors.without_to);
    report.count("relations_without_both_poses", errors.without_both);
    tell_errors(report, "relation", errors.translation_m, errors.rotation_rad);
    tell_squares(report, "relation_translation_squared", "m2", errors.translation_squared_m2);
    tell_squares(report, "relation_rotation_squared", "rad2", errors.rotation_squared_rad2);
}

void tell_crispness(Report& report, const std::string& before, const PathCrispness& crispness) {
    if (crispness.cells_per_point == 0.0) return;  // no laser: nothing to draw
    report.figure(before + "cells_per_point", crispness.cells_per_point, 6);
    if (!crispness.grid_blur_m2) return;
    report.figure(before + "grid_blur_m2", *crispness.grid_blur_m2, 6);
    report.figure(before + "grid_entropy_bits", *crispness.grid_entropy_bits, 3);
}

/// Of the run's own path alone: its loops say nothing of another.
void evaluate_loops(const EvaluateOptions& options, Report& report) {
    KeptRun run = read_results(options.run);
    if (!needs_registration(run.configuration.filter)) return;
    const Trajectory reference = read_trajectory(options.reference_trajectory);
    if (fit_of_path(in_one_frame(run.path, run.later_tours), reference, options.tolerance_s)
            .judges_loops())
        judge_loops(run.loops, reference, options.tolerance_s);
    const LoopPrecision precision = precision_of(run.loops);
    report.count("loops_judged", precision.judged);
    if (precision.judged > 0) {
        report.count("loops_false", precision.wrong);
        report.figure("worst_loop_m", precision.worst_m, 6);
        report.figure("worst_loop_rad", precision.worst_rad, 6);
    }
    if (!options.out.empty()) write_file(out_file(options, "loops.csv"), loops_csv(run.loops));
}

void evaluate_crispness(const EvaluateOptions& options, Report& report) {
    KeptRun run = read_results(options.run);
    run.configuration.source.file = input_named(run.configuration.source.file, "the run's log");
    const std::unique_ptr<TourReader> tour = open_tour(run.configuration);
    const PathCrispness path = path_crispness(*tour, run.path, run.configuration.grid);
    const PathCrispness odometry = path_crispness(*tour, run.odometry, run.configuration.grid);
    report.count("scans", path.scans);
    tell_crispness(report, "", path);
    tell_crispness(report, "odometry_", odometry);
}

void check_choices(const EvaluateOptions& options) {
    const auto refuse = [](const char* why) { throw ConfigError("evaluate", verbatim(why)); };
    const bool of_map = !options.reference.empty() || !options.distances.empty();
    const bool by_reference = !options.reference_trajectory.empty();
    const bool of_path = by_reference || !options.relations.empty();
    if (options.map.empty() == of_map) {
        refuse(of_map ? "--reference and --distances need --map"
                      : "--map needs --reference or --distances");
    }
    const bool of_loops = !options.run.empty() && by_reference;
    if (!options.out.empty() && options.distances.empty() && options.relations.empty() &&
        !of_loops) {
        refuse(
            "--out takes distances.csv, relations.csv and loops.csv and needs --distances, "
            "--relations, or a run and --reference-trajectory");
    }
    if ((options.rpe_distance_m || options.rpe_time_s) && !by_reference) {
        refuse("--rpe-distance and --rpe-time need --reference-trajectory");
    }
    const bool spaced = options.rpe.consecutive || options.rpe_slack->count() > 0;
    if (spaced && !options.rpe_distance_m && !options.rpe_time_s) {
        refuse(
            "--rpe-consecutive and --rpe-slack are of the pairs of --rpe-distance and --rpe-time; "
            "give one of these too");
    }
    if (options.tolerance->count() > 0 && !of_path) {
        refuse(
            "--tolerance is of the stamps of --reference-trajectory and --relations; give one of "
            "these too");
    }
    if (options.trajectory.empty() == of_path) {
        refuse(of_path ? "--reference-trajectory and --relations need --trajectory"
                       : "--trajectory needs --reference-trajectory or --relations");
    }
    if (options.run.empty() && options.map.empty() && options.trajectory.empty()) {
        refuse(
            "found nothing to measure; give the folder of a run, --map and --reference or "
            "--distances, or --trajectory and --reference-trajectory or --relations");
    }
}

void evaluate(EvaluateOptions options) {
    const std::vector<std::pair<const char*, std::string*>> inputs{
        {"--map", &options.map},
        {"--trajectory", &options.trajectory},
        {"--distances", &options.distances},
        {"--relations", &options.relations}};
    for (const auto& [option, file] : inputs) *file = input_named(*file, option);
    const ReferenceFiles references =
        reference_files(options.reference, options.reference_trajectory);
    options.reference = references.map;
    options.reference_trajectory = references.trajectory;
    if (!options.run.empty()) {
        const std::filesystem::path run = options.run;
        const bool of_map = !options.reference.empty() || !options.distances.empty();
        const bool of_path = !options.reference_trajectory.empty() || !options.relations.empty();
        if (options.map.empty() && of_map) options.map = (run / "map.txt").string();
        if (options.trajectory.empty() && of_path) {
            options.trajectory = path_of(options.run);
        }
    }
    check_choices(options);
    Report report(options.json);
    if (!options.trajectory.empty()) read_estimate(options);
    if (!options.run.empty()) evaluate_crispness(options, report);
    if (!options.reference.empty()) evaluate_map(options, report);
    if (!options.distances.empty()) evaluate_distances(options, report);
    if (!options.reference_trajectory.empty()) evaluate_trajectory(options, report);
    if (!options.run.empty() && !options.reference_trajectory.empty()) {
        evaluate_loops(options, report);
    }
    if (options.rpe_distance_m) {
        evaluate_relative(options, PairSpacing::By::distance, *options.rpe_distance_m, report);
    }
    if (options.rpe_time_s) {
        evaluate_relative(options, PairSpacing::By::time, *options.rpe_time_s, report);
    }
    if (!options.relations.empty()) evaluate_relations(options, report);
    report.end();
}

}  // namespace

void add_evaluate(CLI::App& program) {
    auto options = std::make_shared<EvaluateOptions>();
    CLI::App* command = program.add_subcommand(
        "evaluate", "Measure a finished run, map or trajectory, one figure a line");
    command->add_option("run", options->run,
                        "Folder of a run: how crisp its map is, without any truth, from its log "
                        "read anew; its map and trajectory are measured where no others are named");
    command->add_option("--map", options->map, "Map to measure");
    command->add_option("--reference", options->reference, "Reference map");
    command->add_option("--distances", options->distances,
                        "Named distances between parallel walls (docs/formats.md) to measure in "
                        "the map, printed as a table");
    command
        ->add_option("--out", options->out,
                     "Folder for distances.csv, relations.csv and loops.csv, made if missing")
        ->check(&complaint_of_output);
    command->add_option("--trajectory", options->trajectory, "Trajectory to measure (TUM)");
    command->add_option("--reference-trajectory", options->reference_trajectory,
                        "Reference trajectory (TUM)");
    command->add_option("--relations", options->relations,
                        "Relations between poses (docs/formats.md) to measure the trajectory by");
    command
        ->add_option("--rpe-distance", options->rpe_distance_m,
                     "Relative pose error over so much way [m], against the reference trajectory")
        ->check(positive());
    command
        ->add_option("--rpe-time", options->rpe_time_s,
                     "Relative pose error over so much time [s], likewise")
        ->check(positive());
    options->rpe_slack = add_spacing_options(*command, "rpe-", options->rpe);
    options->tolerance = add_tolerance_option(*command, options->tolerance_s);
    add_report_option(*command, options->json);
    command->callback([options] { evaluate(*options); });
}

}  // namespace hitos::cli
