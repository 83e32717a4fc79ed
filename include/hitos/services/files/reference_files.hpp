// SPDX-License-Identifier: GPL-3.0-or-later
// Files of references, told apart by what they hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hitos {

enum class ReferenceKind { map, trajectory };

/// What the file holds, by its first lines and whatever its name; nothing where it is neither
/// or no regular file. Throws FileError where it cannot be read.
std::optional<ReferenceKind> reference_kind(const std::filesystem::path& path);

/// Paths; empty where there is none.
struct ReferenceFiles {
    std::string map;
    std::string trajectory;
};

/// A trajectory that was given as the map, or a map given as the trajectory, in its own place.
/// Throws FileError where it cannot be looked into, ConfigError where both are of one kind; what is
/// neither stays, for its reader to complain of.
ReferenceFiles by_content(ReferenceFiles given);

}  // namespace hitos
