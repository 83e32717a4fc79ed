// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds made from what shows walls: drawings, maps, finished runs, pictures of what is occupied.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"
#include "hitos/simulation/text/world_text.hpp"

namespace hitos {

/// How walls are taken from what is no world.
struct ImportOptions {
    /// Of a drawing (DxfOptions).
    std::string layer;
    std::optional<double> unit_m;
    /// Of traced pictures (TracingOptions::tolerance_m), and how far the corners of a map may lie
    /// from its lines [m]; 0: two cells of the picture, 0.05 m of a map.
    double tolerance_m = 0.0;
    /// Of a pixel of a picture without a YAML file [m]; 0: none is known.
    double resolution_m = 0.0;
    /// Of the robot in the world; nothing: of a world its own, else the origin, where maps and
    /// grids of runs begin.
    std::optional<Pose> start;
    bool in_place = false;  ///< a drawing keeps its coordinates, however far they are
};

/// What became of what is no wall, and of a drawing's unit and place (DxfWalls).
struct ImportReport {
    std::size_t left_out = 0;  ///< lines of a map that have no two corners
    std::vector<Message> notes;
    std::vector<Message> warnings;
};

/// What a source is taken for.
enum class WallSource { drawing, segments, map, map_server, picture, world };

/// By its name: .dxf, .yaml or .yml, .png, .jpg, .jpeg, .pgm or .bmp, .toml; a folder is a finished
/// run, which has segments.txt; of other text files a line tells segments from a map. Throws
/// FileError.
WallSource wall_source(const std::filesystem::path& source);

/// The walls of the source [m]. Of a map, whose lines have no ends, each line gets one wall from
/// its first corner to its last. A drawing farther than 10 km from its origin is moved there,
/// unless the start lies out there too. Throws what the readers throw, ConfigError for a picture of
/// no known resolution and for a layer or unit of what is no drawing, and FormatError where no wall
/// is found or the source is a world.
std::vector<Polyline> import_walls(const std::filesystem::path& source,
                                   const ImportOptions& options, ImportReport* report = nullptr);

/// The same to be laid on a map: in place, and those of a world too.
std::vector<Polyline> walls_as_drawn(const std::filesystem::path& source, ImportOptions options,
                                     ImportReport* report = nullptr);

/// A world file of the source's walls, to the millimetre where they come from a picture or a run,
/// with a comment that names the source, and of the start; walls that end where another begins are
/// one polyline. A world file itself stays as it is written but for the start. `path` is where it
/// will stand. Throws as import_walls().
WorldText import_world(const std::filesystem::path& source, const std::filesystem::path& path,
                       const ImportOptions& options, ImportReport* report = nullptr);

}  // namespace hitos
