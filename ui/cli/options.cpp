// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.hpp"

#include <fmt/core.h>
#include <sysexits.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/base/process.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/workbench/configuration_choices.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"
#include "manual/topic_options.hpp"

namespace hitos::cli {
namespace {

CLI::Validator finite_number(bool zero_too) {
    const auto problem = [zero_too](const std::string& found) {
        double value = 0.0;
        const char* end = found.data() + found.size();
        const auto [stop, error] = std::from_chars(found.data(), end, value);
        const bool number = stop == end && error == std::errc{} && std::isfinite(value);
        if (number && (value > 0.0 || (zero_too && value == 0.0))) return std::string();
        return "found \"" + found + "\", expected a number " +
               (zero_too ? "of 0 or more" : "above 0");
    };
    return {problem, zero_too ? "NONNEGATIVE" : "POSITIVE"};
}

bool looks_like_option(const std::string& word) {
    constexpr std::string_view kDigits = "0123456789.";
    return word.size() > 1 && word[0] == '-' && kDigits.find(word[1]) == std::string_view::npos;
}

/// The words that may stand where this one does: options with their dashes, or commands.
std::vector<std::string> words_of(const CLI::App& command, bool options) {
    std::vector<std::string> words;
    if (options) {
        for (const CLI::Option* option : command.get_options()) {
            if (option->get_group().empty()) continue;  // the help does not tell it either
            for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
        }
    } else {
        for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) {
            words.push_back(sub->get_name());
        }
    }
    return words;
}

std::string slip(const CLI::App& command, const std::string& name, std::string word) {
    const bool option = looks_like_option(word);
    if (option) word = word.substr(0, word.find('='));
    const std::vector<std::string> words = words_of(command, option);
    const std::vector<std::string_view> keys(words.begin(), words.end());
    const auto near = parameter_detail::near_keys(word, keys);
    return word + ": " + name + " has no such " + (option ? "option" : "command") +
           (near.empty() ? "" : "; did you mean " + parameter_detail::joined(near, " or ") + "?");
}

/// A word that is no option or no command where one is expected, with those that it is near to;
/// nothing where there is none. Words after an unknown option may be its values: it is named first.
std::string slip_of(const CLI::App& program) {
    const CLI::App* command = &program;
    std::string name = program.get_name();
    for (;;) {
        const std::vector<std::string> left = command->remaining();
        const auto option = std::ranges::find_if(left, looks_like_option);
        if (option != left.end()) return slip(*command, name, *option);
        const auto subcommands = command->get_subcommands();
        if (subcommands.empty()) {
            const bool wants_command = command->get_require_subcommand_min() > 0;
            return wants_command && !left.empty() ? slip(*command, name, left.front()) : "";
        }
        command = subcommands.front();
        name += " " + command->get_name();
    }
}

/// The settings of the clocks that check advises; none where it has nothing to say of them.
std::vector<SourceSetting> advised_clock(const SourceParams& source) {
    const std::unique_ptr<TourReader> reader = open_source(source);
    for (const TourFinding& finding : inspect_tour(*reader).findings) {
        for (const Remedy& remedy : finding.remedies) {
            const auto clock = [](const SourceSetting& one) {
                return one.key == kScanDelayKey || one.key == kScanClockKey;
            };
            if (std::ranges::any_of(remedy.settings, clock)) return remedy.settings;
        }
    }
    return {};
}

/// What check advises, until it has nothing to say; told, so that it can be given.
void look_for_delay(SourceParams& source) {
    constexpr std::size_t kRounds = 4;  // what is left after one is seldom more than what one sees
    std::vector<std::vector<SourceSetting>> found;
    std::vector<SourceSetting> advised = advised_clock(source);
    while (!advised.empty() && found.size() < kRounds && std::ranges::count(found, advised) == 0) {
        take_up(advised, source);
        found.push_back(std::move(advised));
        advised = advised_clock(source);
    }
    if (found.empty()) {
        fmt::print(stderr, "no scan delay found\n");
        return;
    }
    fmt::print(stderr, "scan delay found: {}\n", options_of(found.back()));
    if (!advised.empty()) {
        fmt::print(stderr, "not all of it: hitos-cli check still advises {}\n",
                   options_of(advised));
    }
}

}  // namespace

CLI::Validator positive() {
    return finite_number(false);
}

CLI::Validator non_negative() {
    return finite_number(true);
}

std::string allowed_threads() {
    return find_parameter("run.threads").allowed();
}

CLI::Option* add_tolerance_option(CLI::App& command, double& tolerance_s) {
    return command
        .add_option("--tolerance", tolerance_s,
                    "Greatest difference of the stamps of a pose and its reference [s] (default: "
                    "0.02); between poses of a reference trajectory that are no more than twice as "
                    "far apart, or 0.5 s, it is interpolated")
        ->check(non_negative());
}

void add_configuration_options(CLI::App& command, ConfigurationOptions& options) {
    CLI::Option* file =
        command.add_option("--config", options.file,
                           "Configuration file, - for standard input (default: as --preset auto)");
    command
        .add_option("--preset", options.preset,
                    "Configuration that comes with Hitos: " + preset_words() +
                        "; hitos-cli presets says what each is for. Or auto, which is the default: "
                        "for a world simulated, for one of trees trees, for one with people, "
                        "walking or standing, and for the recording of a robot recorded, where "
                        "a sensor tells landmarks landmarks, for other logs the thesis's "
                        "recommended values")
        ->excludes(file);
    command
        .add_option("--set", options.values.assignments,
                    "Change one parameter, e.g. --set filter.particles=500; may be repeated; "
                    "hitos-cli parameters lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option(
        "--edits", options.values.edits,
        "File of what is changed by hand in the graph of this very tour: loops "
        "refused or closed, scans fixed or anchored to a drawing, steps that slipped "
        "(docs/formats.md)");
    manual::add_map_options(command, options.values);
    command
        .add_option("--world-set", options.values.world_assignments,
                    "Change one value of the world that is simulated, e.g. --world-set "
                    "laser.sigma=0.003; may be repeated; hitos-cli simulate --help lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--seed", options.values.seed, "Seed of all random numbers, 0 or more")
        ->check(&complaint_of_seed);
    command
        .add_option("--tour-seed", options.values.tour_seed,
                    "Seed of a world's noise, to drive the same tour with other seeds "
                    "(default: as the world says, else the seed)")
        ->check(&complaint_of_seed);
    command.add_option(
        "--threads", options.values.threads,
        "Threads, " + allowed_threads() + " (default: 0, all); results do not depend on it");
}

ReferenceFiles reference_files(const std::string& map, const std::string& trajectory) {
    const ReferenceFiles given{input_named(map, "--reference"),
                               input_named(trajectory, "--reference-trajectory")};
    ReferenceFiles files = by_content(given);
    if (files.map == given.map) return files;
    for (const auto& [file, what] : {std::pair(files.map, "the reference map"),
                                     std::pair(files.trajectory, "the reference trajectory")}) {
        if (!file.empty()) fmt::print(stderr, "{} is {}\n", on_one_line(file), what);
    }
    return files;
}

References references_named(const std::string& map, const std::string& trajectory) {
    const ReferenceFiles files = reference_files(map, trajectory);
    References references;
    if (!files.map.empty()) references.map = read_map(files.map);
    if (!files.trajectory.empty()) references.trajectory = read_trajectory(files.trajectory);
    return references;
}

void add_source_options(CLI::App& command, SourceOptions& options) {
    command.add_option("--format", options.format, log_format_choices() + " (default: auto)");
    manual::add_topic_options(command, options.topics);
}

void SourceOptions::choose(SourceParams& source) const {
    if (!format.empty()) source.format = checked_log_format(format, "--format");
    TopicChoices chosen = topics;
    const bool looked_for = chosen.scan_delay == "auto";
    if (looked_for) chosen.scan_delay = "0";
    chosen.choose(source);
    if (looked_for) look_for_delay(source);
}

std::string complaint_of_output(const std::string& name) {
    if (name != "-") return {};
    return "found \"-\", but this does not go to standard output; expected a name (./- is a file "
           "or folder of that one)";
}

int exit_status(const CLI::App& program, const CLI::ParseError& error) {
    const bool of_words = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                          dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    if (const std::string slip = of_words ? slip_of(program) : ""; !slip.empty()) {
        return program.exit(CLI::ParseError(slip, EX_USAGE));
    }
    const int status = program.exit(error);
    if (status == 0 || dynamic_cast<const CLI::RuntimeError*>(&error) != nullptr) return status;
    return EX_USAGE;
}

std::string_view suited_preset(const ConfigurationOptions& options, const std::string& source) {
    const bool chosen =
        !options.file.empty() || options.preset != kAutoPreset || !options.values.map.empty();
    return chosen ? std::string_view() : hitos::suited_preset(source);
}

std::string suited_words(std::string_view preset, const std::string& source) {
    if (preset.empty()) return {};
    const char* why = preset == kWorldPreset      ? "a world"
                      : preset == kLandmarkPreset ? "its sensor tells landmarks"
                      : preset == kTreePreset     ? "a world of trees"
                      : is_world_file(source)     ? "a world with people"
                                                  : "a robot recorded it";
    return fmt::format("parameters: preset {} ({}); --preset and --config take others\n", preset,
                       why);
}

Configuracion load(const ConfigurationOptions& options, std::string_view suited) {
    Configuracion configuration;
    if (!options.file.empty()) {
        configuration = ArchivoConfiguracion::read(input_named(options.file, "--config"));
    } else if (options.preset != kAutoPreset) {
        configuration = preset_configuration(options.preset);
    } else if (!options.values.map.empty()) {
        configuration = configuration_to_go_on(options.values.map);
    } else if (!suited.empty()) {
        configuration = preset_configuration(suited);
    }
    ValueChoices values = options.values;
    if (!values.edits.empty()) values.edits = input_named(values.edits, "--edits");
    choose_values(configuration, values);
    return configuration;
}

}  // namespace hitos::cli
