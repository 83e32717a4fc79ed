// SPDX-License-Identifier: GPL-3.0-or-later
// What a laser scanner measures in a simulator that knows its walls as the cells of a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "hitos/simulation/laser/simulated_laser.hpp"
#include "worlds/wall_raster.hpp"

namespace hitos {

/// Casts the rays of a fan through the cells of a raster, without noise. Immutable, thread-safe.
class RasterLaser {
  public:
    /// Throws what WallRaster does.
    RasterLaser(const std::vector<WallSegment>& walls, const RasterParams& params, const Fan& fan)
        : raster_(walls, params), ranges_(params.ranges), fan_(fan) {}

    /// Replaces `out` with one hit for each ray; cells belong to no wall, so `segment` stays -1.
    void cast(const Pose& pose_world_robot, std::vector<RayHit>& out) const;
    /// Of one ray.
    RayHit hit(const Pose& pose_world_robot, std::uint32_t ray) const;

  private:
    WallRaster raster_;
    RasterRanges ranges_;
    Fan fan_;
};

}  // namespace hitos
