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
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/path_crispness.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
#include "hitos/services/run/kept_run.hpp"
#include "hitos/services/run/results.hpp"
#include "hitos/workbench/open_tour.hpp"
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
    double tolerance_s = kSameStamp;
};

std::filesystem::path out_file(const EvaluateOptions& options, const char* name) {
    prepare_output_folder(options.out);
    return std::filesystem::path(options.out) / name;
}

void evaluate_map(const EvaluateOptions& options) {
    const LandmarkMap map = read_map(options.map);
    const LandmarkMap reference = read_map(options.reference);
    const auto error = map_error(map, reference);
    const auto aligned = aligned_map_error(map, reference);
    if (!error || !aligned) {
        throw FormatError(options.map, 0,
                          verbatim("has no landmark of a kind that the reference holds"));
    }
    fmt::print("map_error_m {:.6f}\n", error->mean_m);
    fmt::print("map_error_aligned_m {:.6f}\n", aligned->error.mean_m);
    fmt::print("map_error_maximum_m {:.6f}\n", error->maximum_m);
    fmt::print("landmarks {}\nlines {}\ncorners {}\n", error->landmarks + error->without_reference,
               error->lines, error->corners);
    fmt::print("reference_landmarks {}\nreference_found {}\n", error->reference_landmarks,
               error->reference_found);
}

void evaluate_distances(const EvaluateOptions& options) {
    const std::vector<MeasuredDistance> measured =
        measure_distances(read_map(options.map), read_distances(options.distances));
    if (!options.out.empty()) {
        write_file(out_file(options, "distances.csv"), distances_csv(measured));
    }
    fmt::print("{}", distance_table(measured));
}

[[noreturn]] void fail_without_common_stamp(const EvaluateOptions& options, const char* what) {
    throw FormatError(
        options.trajectory, 0,
        verbatim(fmt::format("has no pose within {} s of {}; are the clocks the same?",
                             options.tolerance_s, what)));
}

void evaluate_trajectory(const EvaluateOptions& options) {
    const auto error =
        trajectory_error(read_trajectory(options.trajectory),
                         read_trajectory(options.reference_trajectory), options.tolerance_s);
    if (!error) fail_without_common_stamp(options, "one of the reference");
    fmt::print("ate_rmse_m {:.6f}\nate_mean_m {:.6f}\nate_maximum_m {:.6f}\n", error->rmse_m,
               error->mean_m, error->maximum_m);
    fmt::print("heading_rmse_rad {:.6f}\nposes {}\n", error->heading_rmse_rad, error->poses);
}

void print_figures(const std::string& what, const char* unit, const ErrorFigures& figures,
                   double scale = 1.0) {
    fmt::print("{}_rmse_{} {:.9f}\n", what, unit, figures.rmse * scale);
    fmt::print("{}_mean_{} {:.9f}\n", what, unit, figures.mean * scale);
    fmt::print("{}_deviation_{} {:.9f}\n", what, unit, figures.deviation * scale);
    fmt::print("{}_median_{} {:.9f}\n", what, unit, figures.median * scale);
    fmt::print("{}_maximum_{} {:.9f}\n", what, unit, figures.maximum * scale);
}

void print_squares(const char* what, const char* unit, const ErrorFigures& squares) {
    fmt::print("{0}_mean_{1} {2:.9f}\n{0}_deviation_{1} {3:.9f}\n{0}_maximum_{1} {4:.9f}\n", what,
               unit, squares.mean, squares.deviation, squares.maximum);
}

void print_errors(const std::string& what, const ErrorFigures& translation_m,
                  const ErrorFigures& rotation_rad) {
    constexpr double kDegrees = 180.0 / kPi;
    print_figures(what + "_translation", "m", translation_m);
    print_figures(what + "_rotation", "rad", rotation_rad);
    print_figures(what + "_rotation", "deg", rotation_rad, kDegrees);
}

void evaluate_relative(const EvaluateOptions& options, PairSpacing::By by, double length) {
    const bool time = by == PairSpacing::By::time;
    PairSpacing spacing = options.rpe;
    spacing.by = by;
    spacing.length = length;
    const Trajectory estimate = read_trajectory(options.trajectory);
    const auto error = relative_error(estimate, read_trajectory(options.reference_trajectory),
                                      spacing, options.tolerance_s);
    if (!error) {
        throw FormatError(options.trajectory, 0,
                          verbatim(fmt::format("has no two poses, both with one of the reference, "
                                               "that are {:g} {} apart; take a smaller {}",
                                               length, time ? "s" : "m of way",
                                               time ? "--rpe-time" : "--rpe-distance")));
    }
    const std::string name = time ? "rpe_time" : "rpe_distance";
    fmt::print("{}_{} {:g}\n{}_pairs {}\n", name, time ? "s" : "m", length, name, error->pairs);
    print_errors(name, error->translation_m, error->rotation_rad);
}

void evaluate_relations(const EvaluateOptions& options) {
    const std::vector<MeasuredRelation> measured =
        measure_relations(read_trajectory(options.trajectory), read_relations(options.relations),
                          options.tolerance_s);
    const RelationErrors errors = relation_errors(measured);
    if (!options.out.empty()) {
        write_file(out_file(options, "relations.csv"), relations_csv(measured));
    }
    if (errors.used == 0) {
        fail_without_common_stamp(options, "both times of any of the relations");
    }
    fmt::print("relations {}\nrelations_used {}\n", measured.size(), errors.used);
    fmt::print(
        "relations_without_pose_at_t1 {}\nrelations_without_pose_at_t2 {}\n"
        "relations_without_both_poses {}\n",
        errors.without_from, errors.without_to, errors.without_both);
    print_errors("relation", errors.translation_m, errors.rotation_rad);
    print_squares("relation_translation_squared", "m2", errors.translation_squared_m2);
    print_squares("relation_rotation_squared", "rad2", errors.rotation_squared_rad2);
}

void print_crispness(const char* before, const PathCrispness& crispness) {
    fmt::print("{}cells_per_point {:.6f}\n", before, crispness.cells_per_point);
    if (!crispness.grid_blur_m2) return;
    fmt::print("{}grid_blur_m2 {:.6f}\n", before, *crispness.grid_blur_m2);
    fmt::print("{}grid_entropy_bits {:.3f}\n", before, *crispness.grid_entropy_bits);
}

void evaluate_crispness(const EvaluateOptions& options) {
    const KeptRun run = read_results(options.run);
    const std::unique_ptr<TourReader> tour = open_tour(run.configuration);
    const PathCrispness path = path_crispness(*tour, run.path, run.configuration.grid);
    const PathCrispness odometry = path_crispness(*tour, run.odometry, run.configuration.grid);
    fmt::print("scans {}\n", path.scans);
    print_crispness("", path);
    print_crispness("odometry_", odometry);
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
    if (!options.out.empty() && options.distances.empty() && options.relations.empty()) {
        refuse("--out takes distances.csv and relations.csv and needs --distances or --relations");
    }
    if ((options.rpe_distance_m || options.rpe_time_s) && !by_reference) {
        refuse("--rpe-distance and --rpe-time need --reference-trajectory");
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
    if (!options.run.empty()) {
        const std::filesystem::path run = options.run;
        const bool of_map = !options.reference.empty() || !options.distances.empty();
        const bool of_path = !options.reference_trajectory.empty() || !options.relations.empty();
        if (options.map.empty() && of_map) options.map = (run / "map.txt").string();
        if (options.trajectory.empty() && of_path) {
            options.trajectory = (run / "trajectory.tum").string();
        }
    }
    check_choices(options);
    if (!options.run.empty()) evaluate_crispness(options);
    if (!options.reference.empty()) evaluate_map(options);
    if (!options.distances.empty()) evaluate_distances(options);
    if (!options.reference_trajectory.empty()) evaluate_trajectory(options);
    if (options.rpe_distance_m) {
        evaluate_relative(options, PairSpacing::By::distance, *options.rpe_distance_m);
    }
    if (options.rpe_time_s) {
        evaluate_relative(options, PairSpacing::By::time, *options.rpe_time_s);
    }
    if (!options.relations.empty()) evaluate_relations(options);
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
    command->add_option("--out", options->out,
                        "Folder for distances.csv and relations.csv, made if missing");
    command->add_option("--trajectory", options->trajectory, "Trajectory to measure (TUM)");
    command->add_option("--reference-trajectory", options->reference_trajectory,
                        "Reference trajectory (TUM)");
    command->add_option("--relations", options->relations,
                        "Relations between poses (docs/formats.md) to measure the trajectory by");
    command
        ->add_option("--rpe-distance", options->rpe_distance_m,
                     "Relative pose error over so much way [m], against the reference trajectory")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--rpe-time", options->rpe_time_s,
                     "Relative pose error over so much time [s], likewise")
        ->check(CLI::PositiveNumber);
    add_spacing_options(*command, "rpe-", options->rpe);
    command->add_option("--tolerance", options->tolerance_s,
                        "Greatest difference of stamps of a pair of poses [s] (default: 0.02)");
    command->callback([options] { evaluate(*options); });
}

}  // namespace hitos::cli
