// SPDX-License-Identifier: GPL-3.0-or-later
// Straight walls among a scan's surface points.
#pragma once

#include <optional>
#include <span>

#include "hitos/registration/seen_wall.hpp"
#include "surface_points.hpp"

namespace hitos {

/// As seen_wall(), of the points of a key, for who stands at `eye` in its frame and takes bearings
/// from there; the wall too is in the key's frame.
std::optional<SeenWall> find_wall(std::span<const SurfacePoint> points, const Pose& eye,
                                  double bearing_rad);

}  // namespace hitos
