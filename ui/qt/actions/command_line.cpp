// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <QStringList>
#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/capture/live_source.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "look/user_files.hpp"
#include "manual/describe.hpp"
#include "manual/topic_options.hpp"

namespace hitos::window {
namespace {

constexpr const char* kReadyTour = "data/bigloop-noisy.log.gz";
constexpr const char* kReadyPreset = "thesis";

/// What is wrong with a size of the window; empty: nothing.
std::string complaint_of_size(const std::string& text) {
    constexpr int kLeast = 100;
    constexpr int kMost = 16384;
    const QStringList parts = QString::fromStdString(text).split('x');
    bool wide = parts.size() == 2;
    bool high = wide;
    const int width = wide ? parts[0].toInt(&wide) : 0;
    const int height = high ? parts[1].toInt(&high) : 0;
    if (wide && high && std::min(width, height) >= kLeast && std::max(width, height) <= kMost) {
        return {};
    }
    return fmt::format("found \"{}\", expected WIDTHxHEIGHT, such as 1360x860, each from {} to {}",
                       text, kLeast, kMost);
}

/// A configuration, a preset, the run of a map to go on with, or the user's init.cfg, unless
/// --preset auto asks for none.
bool parameters_named(const CommandLine& line, const UserFiles& files, Init init) {
    const bool wanted = line.preset == kAutoPreset;
    if (!line.config.empty() || (!line.preset.empty() && !wanted)) return true;
    if (!line.values.map.empty()) return true;
    return !wanted && init == Init::read && files.has_init();
}

}  // namespace

std::optional<int> parse(int argc, char** argv, CommandLine& out) {
    CLI::App program{"Hitos: watch landmark SLAM at work on a recorded laser tour"};
    program.name("hitos");
    program.set_version_flag("--version", hitos::version());
    program.footer("Without arguments it opens your init.cfg, or a ready tour. docs/user-guide.md");
    program.add_option(
        "file", out.open,
        "Log (plain or .gz), ROS recording (.bag, .mcap, .db3 or a folder of rosbag2), "
        "configuration (.cfg), world (.toml, or the name of one that comes with Hitos), graph of "
        "poses (.g2o), a folder of results, or a running robot (ws://HOST:PORT)");
    CLI::Option* config = program.add_option("--config", out.config, "Configuration file");
    program
        .add_option("--preset", out.preset,
                    "Configuration that comes with Hitos: " + preset_words() +
                        ", or auto: the one that suits the log or world, which is the default "
                        "where you have no init.cfg")
        ->excludes(config);
    program.add_option("--set", out.values.assignments, "Change one parameter; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    program
        .add_option("--world-set", out.values.world_assignments,
                    "Change one value of the world that is simulated; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    program.add_option("--seed", out.values.seed, "Seed of all random numbers, 0 or more")
        ->check(&complaint_of_seed);
    program
        .add_option("--tour-seed", out.values.tour_seed,
                    "Seed of a world's noise (default: as the world says, else the seed)")
        ->check(&complaint_of_seed);
    manual::add_topic_options(program, out.topics);
    manual::add_map_options(program, out.values);
    program.add_option(
        "--threads", out.values.threads,
        "Threads, " + find_parameter("run.threads").allowed() + " (default: 0, all)");
    program.add_option("--reference", out.reference, "Reference map to measure the map against");
    program.add_option("--reference-trajectory", out.reference_trajectory,
                       "Reference trajectory (TUM) to measure the path against");
    program.add_option("--distances", out.distances,
                       "Named distances between parallel walls to measure in the map");
    program.add_flag("--run", out.run, "Start running at once");
    CLI::Option* vary =
        program
            .add_option("--vary", out.vary,
                        "Open the study of a parameter with these values, e.g. dmax=0.01,0.02; may "
                        "be repeated once")
            ->type_name("NAME=VALUES")
            ->allow_extra_args(false);
    program.add_option("--study-runs", out.study_runs, "Runs of each value of the study")
        ->check(CLI::Range(1, 1000000));
    program.add_option("--study-folder", out.study_folder, "Folder for the results of the study");
    program.add_option("--language", out.language, "en or es (default: the system's)")
        ->check(CLI::IsMember({"en", "es"}));
    program.add_option("--theme", out.theme, "light, dark or system")
        ->check(CLI::IsMember({"light", "dark", "system"}));
    program.add_option("--size", out.size, "Size of the window, e.g. 1360x860")
        ->check(&complaint_of_size);
    program
        .add_option("--screenshot", out.screenshot,
                    "Write a picture (.png, .jpg) of the window and leave; needs no display")
        ->excludes(vary);
    program.add_option("--steps", out.steps, "Steps to run before the picture is taken")
        ->check(CLI::Range(0, 1'000'000'000));
    program.add_option("--scale", out.scale, "Pixels per point of the picture")
        ->check(CLI::Range(0.5, 4.0));
    program
        .add_option(
            "--show", out.show,
            "What the picture shows: main, world, plots, landmarks, particles, associations, "
            "joint, measurements, runs")
        ->check(CLI::IsMember({"main", "world", "plots", "landmarks", "particles", "associations",
                               "joint", "measurements", "runs"}));
    manual::add_description(program);
    try {
        program.parse(argc, argv);
        if (out.vary.size() > 2) {
            throw CLI::ArgumentMismatch(fmt::format(
                "--vary: found {} parameters; a study varies two at the most", out.vary.size()));
        }
        const bool still = !out.vary.empty() || !out.screenshot.empty();
        if (still && is_websocket_address(out.open)) {
            throw CLI::ArgumentMismatch(
                fmt::format("{}: found the robot {}; what it sends is mapped first, then that file "
                            "can be named",
                            out.vary.empty() ? "--screenshot" : "--vary", out.open));
        }
    } catch (const CLI::ParseError& error) {
        return program.exit(error);
    }
    return std::nullopt;
}

std::string deciding_source(const CommandLine& line, const UserFiles& files, Init init) {
    if (line.open.empty() || parameters_named(line, files, init)) return {};
    if (kind_of(QString::fromStdString(line.open)) != FileKind::source) return {};
    return source_named(line.open);
}

Configuracion starting_configuration(const CommandLine& line, const UserFiles& files, Init init) {
    Configuracion configuration;
    const QString named = QString::fromStdString(line.open);
    const auto kind = named.isEmpty() ? std::optional<FileKind>() : std::optional(kind_of(named));
    const bool named_configuration = kind == FileKind::configuration;
    const bool named_results = kind == FileKind::results;
    const bool named_graph = kind == FileKind::graph;
    if (!line.config.empty()) {
        configuration = ArchivoConfiguracion::read(line.config);
    } else if (!line.preset.empty() && line.preset != kAutoPreset) {
        configuration = preset_configuration(line.preset);
    } else if (named_configuration) {
        configuration = ArchivoConfiguracion::read(line.open);
    } else if (named_results) {
        const std::filesystem::path folder = line.open;
        configuration = read_results(folder).configuration;  // which says what is wrong with it
    } else if (!line.values.map.empty()) {
        configuration = configuration_to_go_on(line.values.map);
    } else if (const std::string source = deciding_source(line, files, init); !source.empty()) {
        configuration = suited_configuration(source);
    } else if (init == Init::read && files.has_init()) {
        configuration = ArchivoConfiguracion::read(files.init_path().toStdString());
    } else if ((named.isEmpty() || named_graph) && !shipped_file(kReadyTour).empty()) {
        configuration = preset_configuration(kReadyPreset);
    }
    if (!named.isEmpty() && !named_configuration && !named_results && !named_graph) {
        const std::string source = source_named(line.open);
        // What was set is of another recording; what is named counts. A map's comes with it.
        const bool chosen =
            !line.config.empty() || !line.preset.empty() || !line.values.map.empty();
        if (!chosen && configuration.source.file != source) forget_recording(configuration);
        configuration.source.file = source;
        configuration.source.format = kAutoFormat;
    }
    if (configuration.source.file.empty()) {
        configuration.source.file = shipped_file(kReadyTour).string();
    }
    choose_values(configuration, line.values);
    line.topics.choose(configuration.source);
    return configuration;
}

bool nobody_chose(const CommandLine& line, const UserFiles& files) {
    if (parameters_named(line, files, Init::read) || !line.values.assignments.empty() ||
        !line.values.world_assignments.empty()) {
        return false;
    }
    if (line.open.empty()) return true;
    const FileKind kind = kind_of(QString::fromStdString(line.open));
    return kind != FileKind::configuration && kind != FileKind::results;
}

ReferenceFiles starting_references(const CommandLine& line, const Configuracion& configuration) {
    ReferenceFiles files = by_content({line.reference, line.reference_trajectory});
    const std::string& log = configuration.source.file;
    if (files.map.empty() && !log.empty() && log == shipped_file(kReadyTour).string())
        files.map = shipped_file("data/maps/bigloop.map").string();
    return files;
}

}  // namespace hitos::window
