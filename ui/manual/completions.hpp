// SPDX-License-Identifier: GPL-3.0-or-later
// What a shell offers when Tab is pressed: a script for each shell, made of the command.
#pragma once

#include <string>

#include "command.hpp"

namespace hitos::manual {

/// For /usr/share/bash-completion/completions/NAME. It needs nothing but bash 4.3.
std::string bash_completion(const Command& program);

/// For /usr/share/fish/vendor_completions.d/NAME.fish.
std::string fish_completion(const Command& program);

}  // namespace hitos::manual
