// SPDX-License-Identifier: GPL-3.0-or-later
// Maps as robot map data of IEEE 1873-2015.
#pragma once

#include <span>
#include <string>

#include "hitos/services/files/line_extents.hpp"
#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// What of a run goes into map data, all in the map's frame.
struct IeeeMapContent {
    std::string name;       ///< what the map is of
    std::string algorithm;  ///< that made it
    const LandmarkMap& map;
    std::span<const LineExtent> segments;  ///< of the map's lines
    const Grid& grid;                      ///< may be empty
};

/// An XML document with two local maps of one global map: a geometric one (points and line
/// segments with covariances) and a grid. docs/formats.md says what of it the standard's public
/// descriptions say and what is assumed. Throws Error for a landmark that is not finite and for a
/// segment of a landmark that is no line of the map.
std::string ieee_map_xml(const IeeeMapContent& content);

}  // namespace hitos
