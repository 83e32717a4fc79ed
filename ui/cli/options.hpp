// SPDX-License-Identifier: GPL-3.0-or-later
// Options that several subcommands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/workbench/configuration_choices.hpp"
#include "hitos/workbench/presets.hpp"

namespace hitos::cli {

/// A finite number above 0; one of 0 and more. CLI11's own say their range with 309 digits.
CLI::Validator positive();
CLI::Validator non_negative();

/// "integers from 0 to …": what --threads takes.
std::string allowed_threads();

/// --tolerance, of trajectory_error().
CLI::Option* add_tolerance_option(CLI::App& command, double& tolerance_s);

/// --config, --preset and those of ValueChoices.
struct ConfigurationOptions {
    std::string file;
    std::string preset{kAutoPreset};
    ValueChoices values;
};

void add_configuration_options(CLI::App& command, ConfigurationOptions& options);

/// The references of those files (- for standard input; empty: none), each taken for what it
/// holds; told where that is not what it was given as. Throws what by_content() and reading throw.
ReferenceFiles reference_files(const std::string& map, const std::string& trajectory);
References references_named(const std::string& map, const std::string& trajectory);

/// --format and those of TopicChoices.
struct SourceOptions {
    std::string format;
    TopicChoices topics;

    /// Over what the configuration says, which names the log already: with "auto" its scans' delay
    /// is looked for and told. Throws ConfigError for a word that no format has and for a delay
    /// that is none, and what reading throws.
    void choose(SourceParams& source) const;
};

void add_source_options(CLI::App& command, SourceOptions& options);

/// What is wrong with the name of a file or folder to write: "-", which stands for standard output
/// elsewhere, would become one of that name.
std::string complaint_of_output(const std::string& name);

/// Tells what is wrong with the command line, or the help that was asked for. Gives the program's
/// status: that of the command that left with one of its own, 0 after help, 64 (EX_USAGE of
/// sysexits.h) for a command line that is none.
int exit_status(const CLI::App& program, const CLI::ParseError& error);

/// The preset that the source decides, because neither a file nor a preset was given; empty: none.
std::string_view suited_preset(const ConfigurationOptions& options, const std::string& source);

/// "parameters: preset recorded (…); …\n", of a preset that the source decided; empty for none.
std::string suited_words(std::string_view preset, const std::string& source);

/// The values of the file or the preset, else of the one that the source decides, else the
/// defaults; and the choices over them.
Configuracion load(const ConfigurationOptions& options, std::string_view suited);

}  // namespace hitos::cli
