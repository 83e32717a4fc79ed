// Landmark maps as text [T A.4].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

using LandmarkMap = std::vector<ICaracteristica>;

/// One feature a line: `rho: r theta: degrees` [m, degrees] or `x: cx y: cy` [m]; `#` comments and
/// empty lines are passed over. Throws FileError, or FormatError naming the line, what was found
/// and expected; a file without any feature is an error.
LandmarkMap read_map(const std::filesystem::path& path);

/// The text of a map, lines before corners, shortest digits that read back to the same value (the
/// conversion of theta to degrees may cost the last bit).
std::string map_to_text(const LandmarkMap& map);

/// Writes map_to_text() atomically.
void write_map(const LandmarkMap& map, const std::filesystem::path& path);

}  // namespace hitos
