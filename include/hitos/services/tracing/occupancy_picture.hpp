// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of what is occupied: those of map_server, and any other whose scale is known.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"

namespace hitos {

/// Which cells of a place are occupied. What is unknown is not.
struct OccupancyPicture {
    int columns = 0;
    int rows = 0;
    std::vector<std::uint8_t> occupied;  ///< 0 or 1, row after row from the top (greatest y)
    double resolution_m = 0.05;          ///< of a cell
    Pose origin;                         ///< lower left corner of the lower left cell [m, rad]
    Message note;                        ///< of a picture that is not where the YAML file says
    /// Of a YAML file of a mode that knows negate: which cells are free, and which would be with
    /// the other value of negate, which stands in that line (0: in none).
    std::vector<std::uint8_t> free = {};
    std::vector<std::uint8_t> free_otherwise = {};
    bool negate = false;
    std::uint64_t negate_line = 0;

    bool at(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               occupied[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(column)] != 0;
    }
    /// Of a place in columns and rows, the middle of the first cell being (0, 0), row downwards.
    Point2 world(double column, double row) const {
        return transform(origin, Point2{(column + 0.5) * resolution_m,
                                        (static_cast<double>(rows) - row - 0.5) * resolution_m});
    }
};

/// A YAML file of map_server (ROS 1) or nav2_map_server (ROS 2) and the picture that it names
/// (PGM, PNG, JPG, BMP): `image`, `resolution` and `origin` must be there; `negate` (0),
/// `occupied_thresh` (0.65), `free_thresh` (0.25) and `mode` (trinary) may be. A cell is occupied
/// where its value is more than occupied_thresh: (255 - pixel) / 255, negated pixel / 255, in mode
/// raw pixel / 100 up to 100. Pixels are the mean of their colours, in mode trinary with alpha as
/// one; what is wholly transparent, in mode scale at all, is not occupied. A picture that is not
/// where the file says is looked for beside it. Throws FileError, or FormatError that names file,
/// line and what was expected.
OccupancyPicture read_map_server(const std::filesystem::path& yaml);

/// That `negate` may be the wrong way round: where hardly anything is free, or the start (in the
/// map's frame) is not, and with its other value more of the picture is. Else empty.
Message doubt_of_negate(const OccupancyPicture& picture, const Point2& start);

/// A picture of walls darker than 35 % grey, a pixel so many metres, its lower left corner at the
/// origin. Throws FileError, FormatError, and ConfigError for a size that no pixel has.
OccupancyPicture read_wall_picture(const std::filesystem::path& picture, double resolution_m);

}  // namespace hitos
