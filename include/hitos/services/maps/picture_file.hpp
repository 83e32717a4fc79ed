// Occupancy grids as PNG and JPG pictures.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/run/grid.hpp"

namespace hitos {

struct PictureStyle {
    int scale = 1;             ///< pixels per cell, 1 … kGreatestPictureScale
    std::vector<Point2> path;  ///< world [m]; drawn in red, start a green disc, end a blue one
    bool scale_bar = false;    ///< a bar of a round length, with that length in words
};
inline constexpr int kGreatestPictureScale = 64;

/// The picture as the content of a file: "png" or "jpg" ("jpeg"). Grey without a path, else in
/// colours. Throws ConfigError for another kind or scale, and Error where there is nothing to draw
/// or the kind cannot hold a picture of that size.
std::string encode_picture(const Grid& grid, const PictureStyle& style, std::string_view kind);
std::string encode_picture(const Grid::Picture& picture, std::string_view kind);

/// Writes encode_picture() atomically; the path's extension (.png, .jpg, .jpeg, in any case) says
/// the kind. Throws FileError for another extension and for every reason of encode_picture().
void write_picture(const Grid& grid, const PictureStyle& style, const std::filesystem::path& path);
void write_picture(const Grid::Picture& picture, const std::filesystem::path& path);

}  // namespace hitos
