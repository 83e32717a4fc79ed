// SPDX-License-Identifier: GPL-3.0-or-later
// What the program is told on the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "hitos/workbench/configuration_choices.hpp"

namespace hitos::window {

class UserFiles;

struct CommandLine {
    std::string open;  ///< log, world, configuration, graph or results
    std::string config;
    std::string preset;
    ValueChoices values;
    TopicChoices topics;
    std::string reference;
    std::string reference_trajectory;
    std::string distances;  ///< a file of them, to measure
    std::string language;
    std::string theme;
    std::string size;
    bool run = false;
    std::vector<std::string> vary;  ///< what to study, "dmax=0.01,0.02"; empty: no study
    std::string study_folder;
    int study_runs = 5;  ///< of each value
    // Pictures for documents.
    std::string screenshot;
    std::uint64_t steps = 0;
    double scale = 1.0;
    std::string show = "main";
};

/// Whether the user's init.cfg counts.
enum class Init { read, ignored };

/// Reads the arguments. Where they ask for help or are wrong, it prints and gives the exit code.
std::optional<int> parse(int argc, char** argv, CommandLine& out);

/// The log or world that decides the parameters because nobody chose any, or --preset auto is asked
/// for; empty: somebody did. Throws hitos::Error for a bare name that is none.
std::string deciding_source(const CommandLine& line, const UserFiles& files, Init init);

/// The configuration to start with: the named one, else the user's init.cfg, else what suits the
/// log; then the log, else the ready tour; then the single parameters. Throws hitos::Error.
Configuracion starting_configuration(const CommandLine& line, const UserFiles& files,
                                     Init init = Init::read);

/// Whether the parameters to start with are Hitos's own choice.
bool nobody_chose(const CommandLine& line, const UserFiles& files);

/// The references named, each for what it holds; for the ready tour the map that belongs to it.
/// Throws what by_content() throws.
ReferenceFiles starting_references(const CommandLine& line, const Configuracion& configuration);

}  // namespace hitos::window
