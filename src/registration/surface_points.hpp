// SPDX-License-Identifier: GPL-3.0-or-later
// Scan points with the direction that the surface they lie on faces.
#pragma once

#include <vector>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// A point of a scan [m] with the unit normal of its surface, towards the laser; a normal of zero
/// where the neighbours form no surface.
struct SurfacePoint {
    float x = 0.0F;
    float y = 0.0F;
    float nx = 0.0F;
    float ny = 0.0F;

    bool has_normal() const { return nx != 0.0F || ny != 0.0F; }
};

/// The points of a scan up to `range_m` from the laser, in the robot's frame; every second ray of
/// fans with more than 250. The normal is that of a line through the neighbours within 3 degrees to
/// each side, at least three rays: the direction of least scatter, where the scatter is what a
/// plane wall leaves (standard deviation below 3 cm + 5 mm a metre) and the points spread along it.
void find_surface_points(const Scan& scan, double range_m, std::vector<SurfacePoint>& points);

}  // namespace hitos
