#include "options.hpp"

#include <sysexits.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "hitos/base/process.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
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

}  // namespace

CLI::Validator positive() {
    return finite_number(false);
}

CLI::Validator non_negative() {
    return finite_number(true);
}

void add_configuration_options(CLI::App& command, ConfigurationOptions& options) {
    CLI::Option* file = command.add_option(
        "--config", options.file,
        "Configuration file, - for standard input (default: the thesis's recommended values; for a "
        "world the preset simulated)");
    command
        .add_option("--preset", options.preset,
                    "Configuration that comes with Hitos: " + preset_words() +
                        "; hitos-cli presets says what each is for")
        ->excludes(file);
    command
        .add_option("--set", options.values.assignments,
                    "Change one parameter, e.g. --set filter.particles=500; may be repeated; "
                    "hitos-cli parameters lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--world-set", options.values.world_assignments,
                    "Change one value of the world that is simulated, e.g. --world-set "
                    "laser.sigma=0.003; may be repeated; hitos-cli simulate --help lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--seed", options.values.seed, "Seed of all random numbers")
        ->check(&complaint_of_seed);
    command
        .add_option("--tour-seed", options.values.tour_seed,
                    "Seed of a world's noise, to drive the same tour with other seeds "
                    "(default: as the world says, else the seed)")
        ->check(&complaint_of_seed);
    command.add_option("--threads", options.values.threads,
                       "Threads (default: all); results do not depend on it");
}

void add_source_options(CLI::App& command, SourceOptions& options) {
    command.add_option("--format", options.format, log_format_choices() + " (default: auto)");
    manual::add_topic_options(command, options.topics);
}

void SourceOptions::choose(SourceParams& source) const {
    if (!format.empty()) source.format = checked_log_format(format, "--format");
    topics.choose(source);
}

int exit_status(const CLI::App& program, const CLI::ParseError& error) {
    const int status = program.exit(error);
    if (status == 0 || dynamic_cast<const CLI::RuntimeError*>(&error) != nullptr) return status;
    return EX_USAGE;
}

Configuracion load(const ConfigurationOptions& options, const std::string& source) {
    Configuracion configuration;
    if (!options.file.empty())
        configuration = ArchivoConfiguracion::read(input_named(options.file));
    if (!options.preset.empty()) {
        configuration = preset_configuration(options.preset);
    } else if (options.file.empty() && is_world_file(source)) {
        configuration = preset_configuration(kWorldPreset);
    }
    choose_values(configuration, options.values);
    return configuration;
}

}  // namespace hitos::cli
