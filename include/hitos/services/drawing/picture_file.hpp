// SPDX-License-Identifier: GPL-3.0-or-later
// Occupancy grids as PNG and JPG pictures.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// A grey picture of a place, and where the place lies.
struct MapImage {
    Grid::Picture picture;
    Point2 origin;  ///< world coordinates of the lower left corner [m]
    double m_per_pixel = 0.05;
};

/// The picture with at most `longest_side` > 0 pixels a side: where it has more, n x n of them
/// become one, occupied where one of them is.
MapImage shrunk(MapImage image, int longest_side);
/// The picture as a file of the kind ("png", "jpg") can hold it: shrunk where it has too many
/// pixels a side or too many in all.
MapImage fitted(MapImage image, std::string_view kind);
/// The grid, a pixel a cell.
MapImage map_image(const Grid& grid);

/// What a grid's picture has besides its cells.
struct PictureStyle {
    int scale = 1;                           ///< pixels per cell, 1 … kGreatestPictureScale
    std::vector<std::vector<Point2>> paths;  ///< world [m]; drawn in red, as one with breaks
    bool scale_bar = false;                  ///< a bar of a round length, with that length in words
    PathMarks marks = PathMarks::discs;
};
inline constexpr int kGreatestPictureScale = 64;

/// The picture as the content of a file: "png" or "jpg" ("jpeg"). Grey without a path, else in
/// colours. Throws ConfigError for another kind or scale, and Error where there is nothing to draw
/// or the kind cannot hold a picture of that size.
std::string encode_picture(const MapImage& map, const PictureStyle& style, std::string_view kind);
std::string encode_picture(const Grid& grid, const PictureStyle& style, std::string_view kind);
std::string encode_picture(const Grid::Picture& picture, std::string_view kind);

/// Writes encode_picture() atomically; the path's extension (.png, .jpg, .jpeg, in any case) says
/// the kind. Throws FileError for another extension and for every reason of encode_picture().
void write_picture(const MapImage& map, const PictureStyle& style,
                   const std::filesystem::path& path);
void write_picture(const Grid& grid, const PictureStyle& style, const std::filesystem::path& path);
void write_picture(const Grid::Picture& picture, const std::filesystem::path& path);

/// Reads a PNG, JPG, PGM or BMP as grey. Throws FileError or FormatError.
Grid::Picture read_grey_picture(const std::filesystem::path& path);

/// A picture's greys as map_server takes them: the mean of the colours.
struct MeanPicture {
    Grid::Picture grey;
    std::vector<std::uint8_t> alpha;  ///< 255: not transparent at all; empty where it has none
};
/// Throws FileError or FormatError.
MeanPicture read_mean_picture(const std::filesystem::path& path);

}  // namespace hitos
