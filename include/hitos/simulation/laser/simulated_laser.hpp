// What a laser scanner measures among straight walls, exactly.
#pragma once

#include <cstdint>
#include <limits>
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

/// The fan of the world's laser.
Fan fan_of(const LaserParams& laser);

}  // namespace hitos
