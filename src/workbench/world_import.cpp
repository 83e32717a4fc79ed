// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/world_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "hitos/services/tracing/wall_tracing.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "hitos/simulation/worlds/disturbance.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {
namespace {

constexpr double kOnLine = 0.05;      // m, of a corner from the line of a map
constexpr double kDigit = 1000.0;     // millimetres in a metre
constexpr double kShortest = 0.0005;  // m
constexpr double kSurvey = 1e4;       // m, from where on a drawing has a country's coordinates

std::filesystem::path segments_file(const std::filesystem::path& source) {
    std::error_code ignored;
    return std::filesystem::is_directory(source, ignored) ? source / "segments.txt" : source;
}

/// The first line with words in it, to tell text files by.
std::string first_line(const std::filesystem::path& source) {
    const std::string text = input::read_text(source);
    std::string_view rest = text;
    while (const auto line = input::next_line(rest)) {
        const std::string_view content = input::trimmed(line->substr(0, line->find('#')));
        if (!content.empty()) return std::string(content);
    }
    return {};
}

Point2 to_the_millimetre(const Point2& point) {
    // 0.0 is added so that no zero has a sign.
    return {std::round(point.x * kDigit) / kDigit + 0.0,
            std::round(point.y * kDigit) / kDigit + 0.0};
}

/// Walls end to end as one polyline, in the order of their first ones.
std::vector<Polyline> chained(const Walls& walls) {
    const auto key = [](const Point2& point) { return std::pair(point.x, point.y); };
    std::multimap<std::pair<double, double>, std::size_t> at;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        at.emplace(key(walls[i].first), i);
        at.emplace(key(walls[i].second), i);
    }
    std::vector<bool> used(walls.size(), false);
    const auto extend = [&](Polyline& line) {
        while (true) {
            const Point2 end = line.back();
            const auto [from, to] = at.equal_range(key(end));
            const auto next =
                std::find_if(from, to, [&](const auto& entry) { return !used[entry.second]; });
            if (next == to) return;
            used[next->second] = true;
            const auto& [a, b] = walls[next->second];
            line.push_back(a == end ? b : a);
        }
    };
    std::vector<Polyline> lines;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (used[i]) continue;
        used[i] = true;
        Polyline line{walls[i].first, walls[i].second};
        extend(line);
        std::ranges::reverse(line);
        extend(line);
        std::ranges::reverse(line);
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<Polyline> rounded(const Walls& walls) {
    Walls result;
    for (const auto& [a, b] : walls) {
        const Point2 from = to_the_millimetre(a);
        const Point2 to = to_the_millimetre(b);
        if (std::hypot(to.x - from.x, to.y - from.y) > kShortest) result.emplace_back(from, to);
    }
    return chained(result);
}

std::vector<Polyline> walls_of_segments(const std::filesystem::path& file) {
    Walls walls;
    for (const LineExtent& segment : read_segments(file)) walls.emplace_back(segment.a, segment.b);
    return rounded(walls);
}

/// A line from its first corner to its last, through those between.
std::vector<Polyline> walls_of_map(const std::filesystem::path& file, double tolerance_m,
                                   ImportReport* report) {
    const LandmarkMap map = read_map(file);
    const double tolerance = tolerance_m > 0.0 ? tolerance_m : kOnLine;
    std::vector<Polyline> walls;
    for (const ICaracteristica& landmark : map) {
        const auto* recta = std::get_if<Recta>(&landmark.value);
        if (recta == nullptr) continue;
        const PreparedRecta line(*recta);
        Polyline wall;
        for (const ICaracteristica& other : map) {
            const auto* corner = std::get_if<Esquina>(&other.value);
            if (corner == nullptr) continue;
            const Point2 point{corner->x, corner->y};
            if (std::abs(line.signed_distance(point)) <= tolerance) wall.push_back(point);
        }
        std::ranges::sort(wall, {}, [&](const Point2& point) { return line.along(point); });
        wall.erase(std::unique(wall.begin(), wall.end()), wall.end());
        if (wall.size() >= 2) {
            walls.push_back(std::move(wall));
        } else if (report != nullptr) {
            ++report->left_out;
        }
    }
    return walls;
}

std::vector<Polyline> walls_of_drawing(const std::filesystem::path& file,
                                       const ImportOptions& options, ImportReport* report) {
    const bool starts_far =
        options.start && std::hypot(options.start->x, options.start->y) > kSurvey;
    DxfOptions dxf{options.layer, options.unit_m, starts_far ? kFarthest : kSurvey};
    if (options.in_place) dxf.far_m = std::numeric_limits<double>::infinity();
    DxfWalls drawn = read_dxf_walls(file, dxf);
    // Of a run's own map.dxf the layer of its segments: neither the path nor regions are walls.
    const auto has = [&](const char* layer) {
        return std::ranges::find(drawn.layers, layer) != drawn.layers.end();
    };
    if (options.layer.empty() && has(kDxfLines) && has(kDxfCorners) && has(kDxfPath) &&
        has(kDxfCovariance)) {
        dxf.layer = kDxfLines;
        drawn = read_dxf_walls(file, dxf);
    }
    if (report != nullptr) {
        report->notes = std::move(drawn.notes);
        report->warnings = std::move(drawn.warnings);
    }
    return std::move(drawn.walls);
}

[[noreturn]] void refuse_layer_and_unit(const std::filesystem::path& source) {
    throw ConfigError(
        "layer, unit",
        HITOS_TEXT("Errors",
                   "%1 is no drawing; layers and units are chosen of DXF drawings (.dxf) alone"),
        source.string());
}

std::vector<Polyline> walls_of_picture(const OccupancyPicture& picture, double tolerance_m) {
    TracingOptions options;
    options.tolerance_m = tolerance_m;
    return rounded(trace_walls(picture, options));
}

std::vector<Polyline> walls_of_map_server(const std::filesystem::path& file,
                                          const ImportOptions& options, ImportReport* report) {
    const OccupancyPicture picture = read_map_server(file);
    if (report != nullptr && !picture.note.empty()) report->notes.push_back(picture.note);
    const Pose start = options.start.value_or(Pose{});
    const Message doubt = doubt_of_negate(picture, {start.x, start.y});
    if (report != nullptr && !doubt.empty()) report->warnings.push_back(doubt);
    std::vector<Polyline> walls = walls_of_picture(picture, options.tolerance_m);
    if (walls.empty() && !doubt.empty()) throw FormatError(file.string(), 0, doubt);
    return walls;
}

/// What stands behind the word in the block of a world of Stage, in quotes or brackets; empty where
/// nothing does.
std::string stage_value(std::string_view block, std::string_view key) {
    for (std::size_t at = block.find(key); at != std::string_view::npos;
         at = block.find(key, at + 1)) {
        const std::string_view behind = input::trimmed(block.substr(at + key.size()));
        if (!behind.starts_with('"') && !behind.starts_with('[')) continue;
        const std::size_t end = behind.find(behind[0] == '[' ? ']' : '"', 1);
        return std::string(behind.substr(0, end == std::string_view::npos ? end : end + 1));
    }
    return {};
}

/// Stage's worlds name the picture of their walls and how large it is.
void refuse_stage_world(const std::filesystem::path& file) {
    const std::string text = input::read_text(file);
    std::string words;
    std::string_view rest = text;
    while (const auto line = input::next_line(rest)) {
        words.append(line->substr(0, line->find('#'))).append("\n");
    }
    const std::size_t at = words.find("bitmap");
    if (at == std::string::npos) return;
    const std::size_t begin = words.rfind('(', at) + 1;  // 0 where there is none
    const std::string block = words.substr(begin, words.find(')', at) - begin);
    const std::string bitmap = stage_value(block, "bitmap");
    const std::string size = stage_value(block, "size");
    if (bitmap.empty()) return;
    throw FormatError(
        file.string(), 0,
        HITOS_TEXT(
            "Errors",
            "is a world of Stage, which Hitos does not read; give the picture of its walls, %1, "
            "with --resolution: its width in metres (size %2) divided by that in pixels"),
        bitmap, size.empty() ? "?" : size);
}

OccupancyPicture picture_of(const std::filesystem::path& source, double resolution_m) {
    if (resolution_m != 0.0) return read_wall_picture(source, resolution_m);
    throw ConfigError("resolution",
                      HITOS_TEXT("Errors",
                                 "%1 does not tell how large a pixel is; expected the metres of a "
                                 "pixel, or the YAML file of map_server that names the picture"),
                      source.string());
}

}  // namespace

WallSource wall_source(const std::filesystem::path& source) {
    std::error_code ignored;
    if (std::filesystem::is_directory(source, ignored)) return WallSource::segments;
    if (is_world_file(source)) return WallSource::world;
    std::string kind = source.extension().string();
    for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (kind == ".dxf") return WallSource::drawing;
    if (kind == ".yaml" || kind == ".yml") return WallSource::map_server;
    for (const std::string_view picture : {".png", ".jpg", ".jpeg", ".pgm", ".bmp"}) {
        if (kind == picture) return WallSource::picture;
    }
    const std::string line = first_line(source);
    return !line.empty() && input::parse_number(input::fields(line).front()) ? WallSource::segments
                                                                             : WallSource::map;
}

std::vector<Polyline> import_walls(const std::filesystem::path& source,
                                   const ImportOptions& options, ImportReport* report) {
    std::vector<Polyline> walls;
    const WallSource kind = wall_source(source);
    if (kind != WallSource::drawing && (!options.layer.empty() || options.unit_m)) {
        refuse_layer_and_unit(source);
    }
    switch (kind) {
        case WallSource::drawing:
            walls = walls_of_drawing(source, options, report);
            break;
        case WallSource::segments:
            walls = walls_of_segments(segments_file(source));
            break;
        case WallSource::map:
            refuse_stage_world(source);
            walls = walls_of_map(source, options.tolerance_m, report);
            break;
        case WallSource::map_server:
            walls = walls_of_map_server(source, options, report);
            break;
        case WallSource::picture:
            walls = walls_of_picture(picture_of(source, options.resolution_m), options.tolerance_m);
            break;
        case WallSource::world:
            throw FormatError(
                source.string(), 0,
                HITOS_TEXT("Errors",
                           "is a world; expected a drawing, a map, a finished run or a picture"));
    }
    if (walls.empty()) {
        throw FormatError(
            source.string(), 0,
            HITOS_TEXT("Errors", "found no wall; expected straight walls of some length"));
    }
    return walls;
}

std::vector<Polyline> walls_as_drawn(const std::filesystem::path& source, ImportOptions options,
                                     ImportReport* report) {
    options.in_place = true;
    if (wall_source(source) != WallSource::world) return import_walls(source, options, report);
    if (!options.layer.empty() || options.unit_m) refuse_layer_and_unit(source);
    std::vector<Polyline> walls;
    for (const WallSegment& wall : read_world(source).walls) walls.push_back({wall.a, wall.b});
    return walls;
}

WorldText import_world(const std::filesystem::path& source, const std::filesystem::path& path,
                       const ImportOptions& options, ImportReport* report) {
    if (wall_source(source) == WallSource::world) {
        if (!options.layer.empty() || options.unit_m) refuse_layer_and_unit(source);
        WorldText text = WorldText::read(source);
        if (options.start) text.set_start(*options.start);
        return text;
    }
    std::string name = source.filename().string();
    if (name.empty()) name = source.parent_path().filename().string();
    std::ranges::replace_if(
        name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    // The start is written even where it is the origin, to be seen and changed.
    WorldText text(fmt::format("# The walls of {}.\n[tour]\nstart = [0, 0, 0]\n", name), path);
    const std::vector<Polyline> walls = import_walls(source, options, report);
    try {
        text.set_walls(walls);
    } catch (const FormatError& error) {  // of the source, not of what is made of it
        throw FormatError(source.string(), 0, error.message());
    }
    text.set_start(options.start.value_or(Pose{}));
    return text;
}

}  // namespace hitos
