// hitos-cli evaluate: the measures on finished files.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/run/results.hpp"

namespace hitos::cli {
namespace {

struct EvaluateOptions {
    std::string map;
    std::string reference;
    std::string trajectory;
    std::string reference_trajectory;
    std::string distances;
    std::string out;
    double tolerance_s = 0.02;
};

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
        prepare_output_folder(options.out);
        write_file(std::filesystem::path(options.out) / "distances.csv", distances_csv(measured));
    }
    fmt::print("{}", distance_table(measured));
}

void evaluate_trajectory(const EvaluateOptions& options) {
    const auto error =
        trajectory_error(read_trajectory(options.trajectory),
                         read_trajectory(options.reference_trajectory), options.tolerance_s);
    if (!error) {
        throw FormatError(
            options.trajectory, 0,
            verbatim(fmt::format("has no pose within {} s of one of the reference; are the "
                                 "clocks the same?",
                                 options.tolerance_s)));
    }
    fmt::print("ate_rmse_m {:.6f}\nate_mean_m {:.6f}\nate_maximum_m {:.6f}\n", error->rmse_m,
               error->mean_m, error->maximum_m);
    fmt::print("heading_rmse_rad {:.6f}\nposes {}\n", error->heading_rmse_rad, error->poses);
}

void evaluate(const EvaluateOptions& options) {
    const bool map = !options.map.empty();
    const bool against_map = !options.reference.empty();
    const bool against_distances = !options.distances.empty();
    if (map != (against_map || against_distances)) {
        throw ConfigError("evaluate", verbatim(map ? "--map needs --reference or --distances"
                                                   : "--reference and --distances need --map"));
    }
    if (!options.out.empty() && !against_distances) {
        throw ConfigError("evaluate", verbatim("--out takes distances.csv and needs --distances"));
    }
    if (options.trajectory.empty() != options.reference_trajectory.empty()) {
        throw ConfigError("evaluate",
                          verbatim("--trajectory and --reference-trajectory go together"));
    }
    if (options.map.empty() && options.trajectory.empty()) {
        throw ConfigError("evaluate",
                          verbatim("found nothing to measure; give --map and --reference or "
                                   "--distances, or --trajectory and --reference-trajectory"));
    }
    if (against_map) evaluate_map(options);
    if (against_distances) evaluate_distances(options);
    if (!options.trajectory.empty()) evaluate_trajectory(options);
}

}  // namespace

void add_evaluate(CLI::App& program) {
    auto options = std::make_shared<EvaluateOptions>();
    CLI::App* command = program.add_subcommand(
        "evaluate", "Measure a finished map or trajectory, one figure a line");
    command->add_option("--map", options->map, "Map to measure");
    command->add_option("--reference", options->reference, "Reference map");
    command->add_option("--distances", options->distances,
                        "Named distances between parallel walls (docs/formats.md) to measure in "
                        "the map, printed as a table");
    command->add_option("--out", options->out, "Folder for distances.csv, made if missing");
    command->add_option("--trajectory", options->trajectory, "Trajectory to measure (TUM)");
    command->add_option("--reference-trajectory", options->reference_trajectory,
                        "Reference trajectory (TUM)");
    command->add_option("--tolerance", options->tolerance_s,
                        "Greatest difference of stamps of a pair of poses [s] (default: 0.02)");
    command->callback([options] { evaluate(*options); });
}

}  // namespace hitos::cli
