// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli simulate: a world in; a log, the truth and a picture out.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/world_key.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/tour_files.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

struct SimulateOptions {
    std::string world;
    std::string format = "normalized";
    std::string out;
    std::string truth;
    std::string reference;
    std::string picture;
    std::vector<std::string> assignments;
    // The short forms of --set for the values that change most; empty: as the world says.
    std::string seed;
    std::string laps;
    std::string laser_sigma;
    std::string noise;
    std::string noise_kind;
    bool json = false;
};

World load_world(const SimulateOptions& options) {
    World world = read_world(find_world(options.world));
    for (const std::string& assignment : options.assignments) set_world_value(world, assignment);
    const auto set = [&world](const char* key, const std::string& value) {
        if (!value.empty()) set_world_value(world, fmt::format("{}={}", key, value));
    };
    set("seed", options.seed);
    set("tour.laps", options.laps);
    set("laser.sigma", options.laser_sigma);
    set("odometry.noise", options.noise);
    set("odometry.noise_kind", options.noise_kind);
    return world;
}

void simulate(const SimulateOptions& options) {
    const TourFiles files{checked_target_format(options.format, "--format"), options.out,
                          options.truth, options.reference, options.picture};
    if (options.out.empty() && options.truth.empty() && options.reference.empty() &&
        options.picture.empty()) {
        throw ConfigError(
            "simulate",
            verbatim("found nothing to write; give --out, --truth, --reference or --picture"));
    }
    const auto tour = std::make_shared<const SimulatedTour>(load_world(options));
    const StopByRequest request;
    ProgressLine line("scan");
    write_tour_files(tour, files, tour_files(find_world(options.world)), [&](const auto& reader) {
        if (StopByRequest::wanted()) throw CLI::RuntimeError(StopByRequest::status());
        line.show(reader.report().scans, reader.progress());
    });
    if (!options.out.empty()) line.finish(tour->scans());
    Report report(options.json);
    for (const Message& warning : tour->world().drawing_warnings) report.warn(warning.english());
    report.say("{}: {:.1f} m in {:.1f} s, {}, {}\n", on_one_line(tour->world().name),
               tour->path().length_m(), tour->path().duration_s(), plural(tour->scans(), "scan"),
               plural(tour->readings(), "odometry reading"));
    report.object() = {{"world", tour->world().name},
                       {"distance_m", tour->path().length_m()},
                       {"duration_s", tour->path().duration_s()},
                       {"scans", tour->scans()},
                       {"odometry_readings", tour->readings()}};
    report.object()["files"] = nlohmann::ordered_json::array();
    for (const std::string& file :
         {options.out, options.truth, options.reference, options.picture}) {
        if (!file.empty()) report.object()["files"].push_back(file);
    }
    report.end();
}

std::string footer() {
    std::string text = "Keys for --set, with default and range of each (docs/simulation.md):\n";
    const World defaults;
    for (const WorldKey& key : world_keys()) {
        const bool number = key.type == WorldKey::Type::real || key.type == WorldKey::Type::integer;
        text += fmt::format("  {} = {}  {}{}\n", key.key, key.text(defaults), key.description,
                            number ? fmt::format(" [{}]", key.allowed()) : "");
    }
    text += "Worlds that come with Hitos:";
    for (const std::string& name : shipped_worlds()) text += " " + name;
    return text;
}

}  // namespace

void add_simulate(CLI::App& program) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command = program.add_subcommand(
        "simulate", "Drive a tour through a world and write the log a robot would have written");
    command
        ->add_option("world", options->world,
                     "World file (.toml), or the name of a world that comes with Hitos")
        ->required();
    command->add_option("--format", options->format, writable_formats() + " (default: normalized)");
    command->add_option("--out", options->out, "Log to write; .gz compresses it")
        ->check(&complaint_of_output);
    command->add_option("--seed,--tour-seed", options->seed,
                        "Seed of the noise (default: as the world says, else 1)");
    command->add_option("--laps", options->laps, "How often the way points are driven (tour.laps)");
    command->add_option(
        "--laser-sigma", options->laser_sigma,
        "Standard deviation of a range [m] (laser.sigma); 0.003 reproduces the thesis");
    command->add_option(
        "--odometry-noise", options->noise,
        "Level of the noise on v and w (odometry.noise); the thesis uses 0.1; 0: none");
    command->add_option("--odometry-noise-kind", options->noise_kind, noise_kind_choices());
    command
        ->add_option("--set", options->assignments,
                     "Change one value of the world, e.g. --set laser.rate=10; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        ->add_option("--truth", options->truth,
                     "True trajectory to write (TUM), one pose for each scan")
        ->check(&complaint_of_output);
    command
        ->add_option("--reference", options->reference,
                     "Reference map to write, computed from the walls")
        ->check(&complaint_of_output);
    command
        ->add_option("--picture", options->picture,
                     "Picture to draw (.png or .jpg): walls, true path, odometry, way points")
        ->check(&complaint_of_output);
    add_report_option(*command, options->json);
    command->footer(footer);
    command->callback([options] { simulate(*options); });
}

}  // namespace hitos::cli
