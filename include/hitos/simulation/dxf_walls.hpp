// Walls from a DXF drawing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

struct DxfOptions {
    /// Only entities of this layer count; empty: all of them.
    std::string layer;
    /// Metres per drawing unit; nothing: as the drawing's $INSUNITS says, else 1.
    std::optional<double> unit_m;
};

/// The LINE, LWPOLYLINE and POLYLINE entities of the drawing as open polylines [m], a closed one
/// with its first point repeated. Text, dimensions, points and hatches are passed over; what could
/// be a curved wall or hide one (arcs, circles, ellipses, splines, bulges, inserted blocks) is
/// refused by name. Throws FileError or FormatError.
std::vector<std::vector<Point2>> read_dxf_walls(const std::filesystem::path& path,
                                                const DxfOptions& options = {});

}  // namespace hitos
