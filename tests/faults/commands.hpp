// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that are made to fail and killed, small enough for hundreds of times.
#pragma once

#include "workplace.hpp"

namespace hitos::test {

/// A command of hitos-cli that writes into a workplace.
struct Command {
    std::string name;
    Words before;  ///< its arguments for what was there before
    Words words;   ///< its arguments, for other results
    bool resumes;  ///< writes part by part, and goes on where it was
};

std::vector<Command> commands(const Workplace& place);
Command command_named(const std::string& name, const Workplace& place);

}  // namespace hitos::test
