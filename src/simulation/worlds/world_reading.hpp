// SPDX-License-Identifier: GPL-3.0-or-later
// Reading world files in parts, for those who edit them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// As parse_world(), but there need be no walls yet.
World parse_unfinished_world(std::string_view text, const std::filesystem::path& path);

/// The text of a world file. Throws FileError.
std::string read_world_text(const std::filesystem::path& path);

}  // namespace hitos
