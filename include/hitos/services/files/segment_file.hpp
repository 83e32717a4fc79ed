// SPDX-License-Identifier: GPL-3.0-or-later
// The segments of a map's lines as text [P 6].
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/files/line_extents.hpp"

namespace hitos {

/// One segment a line, `x1 y1 x2 y2 landmark`: both ends in the map's frame [m] and the number of
/// the line landmark among the lines of the map, from 1, which is its line in the map file. `#`
/// comments and empty lines are passed over; plain or gzip; a file without a segment is a map
/// without lines. LineExtent::landmark comes as number - 1, `points` as 0. Throws FileError, or
/// FormatError naming the line, what was found and expected.
std::vector<LineExtent> read_segments(const std::filesystem::path& path);

/// As read_segments(), from text; `name` stands in messages.
std::vector<LineExtent> parse_segments(std::string_view text, const std::string& name);

/// The text of the segments, with a comment that names the columns; the shortest digits that read
/// back to the same value. Throws Error for an end that is not finite and for a segment of a
/// landmark that is no line of the map.
std::string segments_to_text(const LandmarkMap& map, std::span<const LineExtent> segments);

/// Writes segments_to_text() atomically.
void write_segments(const LandmarkMap& map, std::span<const LineExtent> segments,
                    const std::filesystem::path& path);

}  // namespace hitos
