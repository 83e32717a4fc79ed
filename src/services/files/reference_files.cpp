// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/reference_files.hpp"

#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"

namespace hitos {
namespace {

template <class Parse>
bool is_one(const std::string& text, Parse parse) {
    try {
        parse(text, std::string());
        return true;
    } catch (const FormatError&) {
        return false;
    }
}

}  // namespace

std::optional<ReferenceKind> reference_kind(const std::filesystem::path& path) {
    // What can be read but once, or has no end, is left to its reader.
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored) || is_recording(path)) return std::nullopt;
    std::string text;
    // The first line that is no comment decides; damage behind it is told by the reader.
    for (const Message& line : first_lines_of(path)) {
        text += line.english() + '\n';
        if (is_one(text, parse_map)) return ReferenceKind::map;
        if (is_one(text, parse_trajectory)) return ReferenceKind::trajectory;
    }
    return std::nullopt;
}

ReferenceFiles by_content(ReferenceFiles given) {
    const auto is = [](const std::string& file, ReferenceKind kind) {
        return !file.empty() && reference_kind(file) == kind;
    };
    const bool no_map = is(given.map, ReferenceKind::trajectory);
    const bool no_path = is(given.trajectory, ReferenceKind::map);
    if (no_map && !no_path && !given.trajectory.empty()) {
        throw ConfigError("references",
                          HITOS_TEXT("Errors",
                                     "%1 and %2 are both trajectories; expected one of them, and a "
                                     "map beside it"),
                          given.map, given.trajectory);
    }
    if (no_path && !no_map && !given.map.empty()) {
        throw ConfigError("references",
                          HITOS_TEXT("Errors",
                                     "%1 and %2 are both maps; expected one of them, and a "
                                     "trajectory beside it"),
                          given.map, given.trajectory);
    }
    if (no_map || no_path) std::swap(given.map, given.trajectory);
    return given;
}

}  // namespace hitos
