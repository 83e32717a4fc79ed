// SPDX-License-Identifier: GPL-3.0-or-later
// Landmark maps as text [T A.4].
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// One feature a line: `rho: r theta: degrees` [m, degrees] or `x: cx y: cy` [m], in any case and
/// with any spaces; `#` comments and empty lines are passed over; plain or gzip. Lines come in
/// normal form. Throws FileError, or FormatError naming the line, what was found and expected; a
/// file without any feature is an error.
LandmarkMap read_map(const std::filesystem::path& path);

/// As read_map(), from text; `name` stands in messages.
LandmarkMap parse_map(std::string_view text, const std::string& name);

/// The text of a map, lines before corners, shortest digits that read back to the same value (the
/// conversion of theta to degrees may cost the last bit). Throws Error for a landmark that is not
/// finite.
std::string map_to_text(const LandmarkMap& map);

/// Writes map_to_text() atomically.
void write_map(const LandmarkMap& map, const std::filesystem::path& path);

}  // namespace hitos
