// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli: runs, conversions and measures from the command line.

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "hitos/base/process.hpp"
#include "hitos/services/results/results.hpp"
#include "manual/describe.hpp"
#include "options.hpp"

namespace {

int run(int argc, char** argv) {
    CLI::App program{"Hitos: landmark SLAM on recorded laser tours, from the command line"};
    program.name("hitos-cli");
    program.set_version_flag("--version", hitos::version());
    program.require_subcommand(1);
    program.footer(
        "Formats and files: docs/formats.md; worlds: docs/simulation.md; every parameter: "
        "hitos-cli parameters");
    hitos::cli::add_run(program);
    hitos::cli::add_simulate(program);
    hitos::cli::add_world(program);
    hitos::cli::add_convert(program);
    hitos::cli::add_info(program);
    hitos::cli::add_check(program);
    hitos::cli::add_evaluate(program);
    hitos::cli::add_compare(program);
    hitos::cli::add_relations(program);
    hitos::cli::add_graph(program);
    hitos::cli::add_study(program);
    hitos::cli::add_benchmark(program);
    hitos::cli::add_reproduce(program);
    hitos::cli::add_parameters(program);
    hitos::cli::add_presets(program);
    hitos::cli::add_verify(program);
    hitos::cli::add_recover(program);
    hitos::manual::add_description(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return hitos::cli::exit_status(program, error);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    hitos::prepare_process();
    return hitos::run_program("hitos-cli", [&] { return run(argc, argv); });
}
