// SPDX-License-Identifier: GPL-3.0-or-later
// Many small grid maps on one sheet, to be compared at a glance.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hitos/services/drawing/picture_file.hpp"

namespace hitos {

/// One small map with its words.
struct SheetTile {
    std::vector<std::string> caption;  ///< lines below the map
    MapImage map;                      ///< an empty picture: the tile says "no map"
    /// World [m]; red, start X, end O, as one with breaks.
    std::vector<std::vector<Point2>> paths;
};

/// Tiles row by row.
struct ContactSheet {
    std::string title;
    int columns = 0;      ///< of tiles; 0: as many as make the sheet about as wide as high
    int tile_side = 300;  ///< pixels of the longer side of a tile, where there is room; at least 60
    std::vector<SheetTile> tiles;
};

/// Greatest number of pixels of a sheet; tiles shrink to keep it.
constexpr int kMostSheetPixels = 24'000'000;

/// The sheet as a picture in colours, "png" or "jpg". All tiles show the same piece of the world at
/// the same scale, so that turned, shifted and torn maps are seen as such; where a few maps are far
/// greater than the others they are cut, lest the others become too small to see. Greys are
/// rounded to sixteen steps, which makes the file much smaller. The sheet ends
/// with a bar for the scale. Throws Error where there is no tile, or where there are too many for
/// kMostSheetPixels.
std::string encode_contact_sheet(const ContactSheet& sheet, std::string_view kind);

/// Writes encode_contact_sheet() atomically; the path's extension says the kind. Throws FileError.
void write_contact_sheet(const ContactSheet& sheet, const std::filesystem::path& path);

}  // namespace hitos
