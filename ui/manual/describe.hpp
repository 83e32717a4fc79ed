// SPDX-License-Identifier: GPL-3.0-or-later
// The manual pages and completions of a program, written by the program itself when it is built.
#pragma once

#include <CLI/CLI.hpp>

namespace hitos::manual {

/// Gives the program the option --describe FOLDER, which its help does not tell: it writes the
/// manual pages of the program and its subcommands, and the completions for bash and fish, into the
/// folder, and ends the program. --prose FOLDER holds what the pages say beside the options:
/// PAGE.md where a page has such words. hitos-cli writes hitos.cfg(5) too.
void add_description(CLI::App& program);

}  // namespace hitos::manual
