#include "options.hpp"

#include <algorithm>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"

namespace hitos::cli {

void add_configuration_options(CLI::App& command, ConfigurationOptions& options) {
    command.add_option("--config", options.file,
                       "Configuration file (default: the thesis's recommended values)");
    command
        .add_option("--set", options.assignments,
                    "Change one parameter, e.g. --set filter.particles=500; may be repeated; "
                    "hitos-cli parameters lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--seed", options.seed, "Seed of all random numbers");
    command.add_option("--threads", options.threads,
                       "Threads (default: all); results do not depend on it");
}

Configuracion load(const ConfigurationOptions& options) {
    Configuracion configuration;
    if (!options.file.empty()) configuration = ArchivoConfiguracion::read(options.file);
    for (const std::string& assignment : options.assignments) {
        set_parameter(configuration, assignment);
    }
    if (options.seed) {
        find_parameter("run.seed").set(configuration, std::to_string(*options.seed));
    }
    if (options.threads) {
        find_parameter("run.threads").set(configuration, std::to_string(*options.threads));
    }
    check(configuration);
    return configuration;
}

LogFormat parse_format(const std::string& word, const std::string& option) {
    if (const auto format = log_format_from(word)) return *format;
    throw ConfigError(
        option, "found \"" + word + "\", expected auto, player, radish, normalized or carmen");
}

OdometryNoiseKind parse_noise_kind(const std::string& word) {
    const auto found = std::ranges::find(kOdometryNoiseWords, word);
    if (found != kOdometryNoiseWords.end()) {
        return static_cast<OdometryNoiseKind>(found - kOdometryNoiseWords.begin());
    }
    throw ConfigError("--odometry-noise-kind",
                      "found \"" + word + "\", expected relative-sigma or variance");
}

}  // namespace hitos::cli
