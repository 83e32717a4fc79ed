// SPDX-License-Identifier: GPL-3.0-or-later
// The manual pages of the programs and of the configuration file.
#pragma once

#include <string>
#include <string_view>

#include "command.hpp"

namespace hitos::manual {

/// "hitos-cli-study-merge": the page's name.
std::string page_name(const Command& command);

/// The page of one command, section 1: name, synopsis, arguments and options from the command; the
/// description and the sections after the options from the prose, Markdown whose first part is the
/// description. Empty prose: the command's purpose alone.
std::string command_page(const Command& command, std::string_view prose);

/// hitos.cfg(5): every parameter with its default, meaning, range and when it is read.
std::string configuration_page(std::string_view prose);

}  // namespace hitos::manual
