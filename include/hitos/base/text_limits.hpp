// SPDX-License-Identifier: GPL-3.0-or-later
// What a library that parses a text is spared: nesting, long keys and counts that it would follow
// until its stack or the memory ends.
#pragma once

#include <string>
#include <string_view>

namespace hitos::input {

/// The text, to be given to the library; every TOML and JSON from outside goes through one of these
/// (other texts are read by hand). They throw FormatError that names line and limit.
std::string_view checked_toml(std::string_view text, const std::string& file);
std::string_view checked_json(std::string_view text, const std::string& file);

}  // namespace hitos::input
