// SPDX-License-Identifier: GPL-3.0-or-later
// Maps as CAD drawings [P 6].
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "hitos/services/files/line_extents.hpp"

namespace hitos {

/// The layers of a drawing.
inline constexpr const char* kDxfLines = "LINES";            ///< LINE: the segments
inline constexpr const char* kDxfCorners = "CORNERS";        ///< POINT: the corners
inline constexpr const char* kDxfPath = "PATH";              ///< LWPOLYLINE: the robot's path
inline constexpr const char* kDxfCovariance = "COVARIANCE";  ///< 3-sigma regions, see below

/// The text of a drawing of the map (ASCII DXF of AutoCAD 2000, AC1015) in metres, in the map's
/// frame, with its extents in the header. COVARIANCE holds for each corner the ELLIPSE of 3 sigma,
/// and for each segment the closed LWPOLYLINE of the points 3 sigma off the line on both sides:
/// at t along the line from its foot the line's place across has the variance
/// C_rho,rho - 2 t C_rho,theta + t^2 C_theta,theta (a line turned by d(theta) comes nearer to the
/// point at t by t d(theta)). A landmark whose covariance is zero or not finite has no region. A
/// path of one place only is not drawn. Throws Error for a landmark, segment or pose that is not
/// finite and for a segment of a landmark that is no line of the map.
std::string dxf_text(const LandmarkMap& map, std::span<const LineExtent> segments,
                     const Trajectory& path);

/// Writes dxf_text() atomically.
void write_dxf(const LandmarkMap& map, std::span<const LineExtent> segments, const Trajectory& path,
               const std::filesystem::path& file);

}  // namespace hitos
