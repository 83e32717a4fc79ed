// SPDX-License-Identifier: GPL-3.0-or-later
// What a laser scanner measures among straight walls, exactly.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// Where a ray ends.
struct RayHit {
    double range_m = std::numeric_limits<double>::infinity();
    int segment = -1;  ///< index of the wall segment; -1: nothing within the greatest range
};

/// Casts the rays of a fan against the walls, without noise and without a grid. Each wall is
/// offered only to the rays inside the angle under which it is seen.
class SimulatedLaser {
  public:
    SimulatedLaser(std::vector<WallSegment> walls, const Fan& fan);

    const Fan& fan() const { return fan_; }
    /// Replaces `out` with one hit for each ray. Thread-safe.
    void cast(const Pose& pose_world_robot, std::vector<RayHit>& out) const;
    /// Of one ray. Thread-safe.
    RayHit hit(const Pose& pose_world_robot, std::uint32_t ray) const;

  private:
    std::vector<WallSegment> walls_;
    Fan fan_;
    double step_rad_;
    std::vector<Point2> directions_;  ///< of the rays, in the laser's frame
};

/// Cosine and sine of every ray of a laser that is turned so far: they are the same in every scan.
std::vector<Point2> ray_directions(const Fan& fan, double turned_rad, double step_rad);

/// What Stage 2 does with `laser_sample_skip` n (libstage 2.0.3, model_laser.c): the first hit of
/// every n stays, and the last of all, which Stage leaves at 0; the ranges between two that stay
/// lie on a straight line from one to the other, where a ray without return has `max_range_m`.
/// Between two of those there is none either. n >= 1; 1 changes nothing.
void interpolate(std::span<RayHit> hits, int n, double max_range_m);

/// The fan of the world's laser.
Fan fan_of(const LaserParams& laser);

}  // namespace hitos
