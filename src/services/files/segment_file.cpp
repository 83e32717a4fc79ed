// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/segment_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

constexpr std::array<std::string_view, 5> kSegmentFields = {"x1", "y1", "x2", "y2", "landmark"};

LineExtent segment_from(std::string_view line, const std::string& name, std::uint64_t number) {
    const std::array values = input::finite_numbers(line, kSegmentFields, {name, number});
    constexpr double kGreatestLandmark = 1e9;
    const double landmark = values[4];
    if (landmark < 1.0 || landmark > kGreatestLandmark || landmark != std::floor(landmark)) {
        throw FormatError(
            name, number,
            HITOS_TEXT("Errors",
                       "landmark is %1; expected the number of a line of the map, counted from 1"),
            input::in_quotes(input::fields(line)[4]));
    }
    return {static_cast<int>(landmark) - 1, {values[0], values[1]}, {values[2], values[3]}, 0};
}

}  // namespace

std::vector<LineExtent> read_segments(const std::filesystem::path& path) {
    return parse_segments(input::read_text(path), path.string());
}

std::vector<LineExtent> parse_segments(std::string_view text, const std::string& name) {
    std::vector<LineExtent> segments;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(line->substr(0, line->find('#')));
        if (!content.empty()) segments.push_back(segment_from(content, name, number));
    }
    return segments;
}

std::string segments_to_text(const LandmarkMap& map, std::span<const LineExtent> segments) {
    // Map files hold lines before corners, so the number counts lines alone.
    std::vector<int> numbers(map.size(), 0);
    int lines = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (map[i].kind() == FeatureKind::line) numbers[i] = ++lines;
    }
    std::string text = "# x1 y1 x2 y2 [m] landmark (line of the map file, from 1)\n";
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto& [landmark, a, b, points] = segments[i];
        const auto index = static_cast<std::size_t>(landmark);
        if (landmark < 0 || index >= map.size() || numbers[index] == 0) {
            throw Error(message(HITOS_TEXT("Errors",
                                           "segment %1 belongs to landmark %2, which is no line of "
                                           "the map of %3 landmarks"),
                                i, landmark, map.size()));
        }
        if (!std::isfinite(a.x) || !std::isfinite(a.y) || !std::isfinite(b.x) ||
            !std::isfinite(b.y)) {
            throw Error(message(
                HITOS_TEXT(
                    "Errors",
                    "segment %1, from (%2, %3) to (%4, %5), is not finite and cannot be written"),
                i, a.x, a.y, b.x, b.y));
        }
        text +=
            fmt::format("{} {} {} {} {}\n", without_sign_of_zero(a.x), without_sign_of_zero(a.y),
                        without_sign_of_zero(b.x), without_sign_of_zero(b.y), numbers[index]);
    }
    return text;
}

void write_segments(const LandmarkMap& map, std::span<const LineExtent> segments,
                    const std::filesystem::path& path) {
    write_file(path, segments_to_text(map, segments));
}

}  // namespace hitos
