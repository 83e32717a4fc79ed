// SPDX-License-Identifier: GPL-3.0-or-later
// What a program's command line offers, as plain values: manual pages and completions are made of
// it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace hitos::manual {

/// An option or a positional argument.
struct Argument {
    std::vector<std::string> names;     ///< "-h", "--help"; of a positional its one name
    std::string value;                  ///< what it takes: "TEXT", "KEY=VALUE"; empty: nothing
    std::vector<std::string> words;     ///< the only ones allowed; empty: any
    std::string range;                  ///< of a number that is limited: "1 - 1000000", "POSITIVE"
    std::vector<std::string> excludes;  ///< options that it cannot stand beside
    std::string meaning;
    bool positional = false;
    bool required = false;
    bool repeated = false;      ///< of positionals: several may follow each other
    bool value_may_go = false;  ///< of options: the value may be left out, --pictures[=all]

    /// The long name of an option, the only name of a positional.
    const std::string& name() const { return names.back(); }
};

/// A program or one of its subcommands.
struct Command {
    std::string words;    ///< as it is called: "hitos-cli study merge"
    std::string below;    ///< the part that chooses the subcommand: "study merge"; a program's: ""
    std::string purpose;  ///< one sentence
    std::string footer;   ///< closing words of its own, not those of the command above
    std::vector<Argument> arguments;
    std::vector<Command> subcommands;
};

/// The program with all that its --help tells, subcommands included; what is hidden there is left
/// out.
Command command_of(const CLI::App& program);

/// The command and all that are below it, the nearest first.
std::vector<const Command*> whole_family(const Command& command);

}  // namespace hitos::manual
