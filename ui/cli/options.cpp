#include "options.hpp"

namespace hitos::cli {

void add_configuration_options(CLI::App& command, ConfigurationOptions& options) {
    command.add_option("--config", options.file,
                       "Configuration file (default: the thesis's recommended values)");
    command
        .add_option("--set", options.values.assignments,
                    "Change one parameter, e.g. --set filter.particles=500; may be repeated; "
                    "hitos-cli parameters lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--seed", options.values.seed, "Seed of all random numbers");
    command.add_option("--threads", options.values.threads,
                       "Threads (default: all); results do not depend on it");
}

Configuracion load(const ConfigurationOptions& options) {
    Configuracion configuration;
    if (!options.file.empty()) configuration = read_configuration(options.file);
    choose_values(configuration, options.values);
    return configuration;
}

}  // namespace hitos::cli
