// Options that several subcommands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/workbench/configuration_choices.hpp"

namespace hitos::cli {

/// --config, --set, --seed and --threads.
struct ConfigurationOptions {
    std::string file;
    ValueChoices values;
};

void add_configuration_options(CLI::App& command, ConfigurationOptions& options);

/// The file's values (else the defaults), the assignments over them, then seed and threads.
Configuracion load(const ConfigurationOptions& options);

}  // namespace hitos::cli
