// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of hitos-cli. Each adds itself to the program with its options; the options live
// as long as the callback that uses them.
#pragma once

#include <CLI/CLI.hpp>

namespace hitos::cli {

void add_run(CLI::App& program);
void add_convert(CLI::App& program);
void add_info(CLI::App& program);
void add_check(CLI::App& program);
void add_compare(CLI::App& program);
void add_evaluate(CLI::App& program);
void add_relations(CLI::App& program);
void add_graph(CLI::App& program);
void add_study(CLI::App& program);
void add_simulate(CLI::App& program);
void add_world(CLI::App& program);
void add_benchmark(CLI::App& program);
void add_reproduce(CLI::App& program);
void add_parameters(CLI::App& program);
void add_presets(CLI::App& program);
void add_verify(CLI::App& program);
void add_recover(CLI::App& program);

}  // namespace hitos::cli
