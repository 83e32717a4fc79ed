// hitos-cli evaluate: the measures on finished files.

#include <fmt/core.h>

#include <memory>
#include <string>

#include "commands.hpp"
#include "hitos/capture/error.hpp"
#include "hitos/services/measures.hpp"

namespace hitos::cli {
namespace {

struct EvaluateOptions {
    std::string map;
    std::string reference;
    std::string trajectory;
    std::string reference_trajectory;
    double tolerance_s = 0.02;
};

void evaluate_map(const EvaluateOptions& options) {
    const LandmarkMap map = read_map(options.map);
    const LandmarkMap reference = read_map(options.reference);
    const auto error = map_error(map, reference);
    const auto aligned = aligned_map_error(map, reference);
    if (!error || !aligned) {
        throw FormatError(options.map, 0, "has no landmark of a kind that the reference holds");
    }
    fmt::print("map_error_m {:.6f}\n", error->mean_m);
    fmt::print("map_error_aligned_m {:.6f}\n", aligned->error.mean_m);
    fmt::print("map_error_maximum_m {:.6f}\n", error->maximum_m);
    fmt::print("landmarks {}\nlines {}\ncorners {}\n", error->landmarks + error->without_reference,
               error->lines, error->corners);
    fmt::print("reference_landmarks {}\nreference_found {}\n", error->reference_landmarks,
               error->reference_found);
}

void evaluate_trajectory(const EvaluateOptions& options) {
    const auto error =
        trajectory_error(read_trajectory(options.trajectory),
                         read_trajectory(options.reference_trajectory), options.tolerance_s);
    if (!error) {
        throw FormatError(options.trajectory, 0,
                          fmt::format("has no pose within {} s of one of the reference; are the "
                                      "clocks the same?",
                                      options.tolerance_s));
    }
    fmt::print("ate_rmse_m {:.6f}\nate_mean_m {:.6f}\nate_maximum_m {:.6f}\n", error->rmse_m,
               error->mean_m, error->maximum_m);
    fmt::print("heading_rmse_rad {:.6f}\nposes {}\n", error->heading_rmse_rad, error->poses);
}

void evaluate(const EvaluateOptions& options) {
    if (options.map.empty() != options.reference.empty()) {
        throw ConfigError("evaluate", "--map and --reference go together");
    }
    if (options.trajectory.empty() != options.reference_trajectory.empty()) {
        throw ConfigError("evaluate", "--trajectory and --reference-trajectory go together");
    }
    if (options.map.empty() && options.trajectory.empty()) {
        throw ConfigError("evaluate",
                          "found nothing to measure; give --map and --reference, or "
                          "--trajectory and --reference-trajectory");
    }
    if (!options.map.empty()) evaluate_map(options);
    if (!options.trajectory.empty()) evaluate_trajectory(options);
}

}  // namespace

void add_evaluate(CLI::App& program) {
    auto options = std::make_shared<EvaluateOptions>();
    CLI::App* command = program.add_subcommand(
        "evaluate", "Measure a finished map or trajectory, one figure a line");
    command->add_option("--map", options->map, "Map to measure");
    command->add_option("--reference", options->reference, "Reference map");
    command->add_option("--trajectory", options->trajectory, "Trajectory to measure (TUM)");
    command->add_option("--reference-trajectory", options->reference_trajectory,
                        "Reference trajectory (TUM)");
    command->add_option("--tolerance", options->tolerance_s,
                        "Greatest difference of stamps of a pair of poses [s] (default: 0.02)");
    command->callback([options] { evaluate(*options); });
}

}  // namespace hitos::cli
