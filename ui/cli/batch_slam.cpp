// SPDX-License-Identifier: GPL-3.0-or-later
// BatchSLAM: a study with the arguments of the thesis [T 9.2.7].

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/process.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/workbench/configuration_choices.hpp"
#include "manual/describe.hpp"
#include "options.hpp"
#include "study_console.hpp"

namespace hitos::cli {
namespace {

constexpr const char* kNoReference = "-";

struct BatchOptions {
    std::string config;
    std::string salida;
    std::string referencia;
    std::string parametro;
    std::vector<std::string> valores;
    std::vector<std::string> second;
    StudyRunOptions runs;
};

StudyParameter parameter(const std::string& name, const std::vector<std::string>& values) {
    StudyParameter parameter = find_thesis_parameter(name);
    set_values(parameter, values);
    return parameter;
}

int batch(const BatchOptions& options) {
    Study study;
    study.parameters.push_back(parameter(options.parametro, options.valores));
    if (!options.second.empty()) {
        study.parameters.push_back(
            parameter(options.second.front(), {options.second.begin() + 1, options.second.end()}));
    }
    study.configuration = ArchivoConfiguracion::read(options.config);
    if (study.configuration.source.file.empty()) {
        throw ConfigError("source.file", verbatim("found no file name in " + options.config +
                                                  "; expected the path of the log to study"));
    }
    const std::filesystem::path quality = options.salida;
    std::vector<std::filesystem::path> inputs{options.config, options.referencia};
    inputs.emplace_back(study.configuration.source.file);
    check_apart({&quality, 1}, inputs);
    study.layout = study_beside(options.salida);
    apply(options.runs, options.referencia == kNoReference ? "" : options.referencia, study);
    return conduct(study, options.runs, {});
}

std::string parameter_list() {
    std::string text = "Parameters, and what each run takes of the values:\n";
    for (const ThesisParameter& thesis : thesis_parameters()) {
        text += fmt::format("  {:<8} {}: {}\n", thesis.name, thesis.keys.size(), thesis.meaning);
    }
    return text +
           "A value of a parameter that takes one may be a range from:to:step.\n\n"
           "Salida out/dmax.csv gives the quality of every run in out/dmax.csv and, beside it,\n"
           "out/dmax-maps/, out/dmax-summary.csv (.md, .tex), plots and times. A study that was\n"
           "stopped goes on where it was when it is started again.";
}

int run_program(int argc, char** argv) {
    CLI::App program{
        "BatchSLAM: runs FastSLAM for several values of a parameter and measures the "
        "maps"};
    program.name("BatchSLAM");
    program.set_version_flag("--version", version());
    program.footer(parameter_list());
    BatchOptions options;
    program.add_option("Config", options.config, "Configuration file; its source.file is the log")
        ->required();
    program.add_option("Salida", options.salida, "Quality file to write (CSV)")
        ->required()
        ->check(&complaint_of_output);
    program
        .add_option("Referencia", options.referencia,
                    "Reference map; - for none: paths and grid maps are measured")
        ->required();
    program.add_option("Parametro", options.parametro, "Parameter to vary, see below")->required();
    program.add_option("Valores", options.valores, "Its values")->required()->expected(1, -1);
    program
        .add_option("--second", options.second,
                    "A second parameter and its values, e.g. --second dmax 0.01 0.02: every pair "
                    "is run")
        ->expected(2, -1)
        ->type_name("NAME VALUES");
    program.add_option("--seed", options.runs.first_seed, "First seed of each value (default: 1)")
        ->check(&complaint_of_seed);
    program
        .add_option("--threads", options.runs.threads,
                    "Runs at a time (default: as many as the machine has); results do not "
                    "depend on it")
        ->check(CLI::Range(0, 256));
    add_study_options(program, options.runs);
    manual::add_description(program);
    try {
        program.parse(argc, argv);
        return batch(options);
    } catch (const CLI::ParseError& error) {
        return exit_status(program, error);
    }
}

}  // namespace
}  // namespace hitos::cli

int main(int argc, char** argv) {
    hitos::prepare_process();
    try {
        return hitos::run_program("BatchSLAM", [&] { return hitos::cli::run_program(argc, argv); });
    } catch (...) {  // not even the error could be told
        return 1;
    }
}
