// A driven tour with what laser and odometry say on it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/simulation/driven_path.hpp"
#include "hitos/simulation/simulated_laser.hpp"
#include "hitos/simulation/world.hpp"

namespace hitos {

class RasterLaser;

/// Drives once, then makes every scan on demand; immutable and thread-safe. The noise of a scan
/// depends on seed and scan number alone.
class SimulatedTour {
  public:
    /// Throws what drive() throws. The robot drives among the walls themselves; a raster is what
    /// the laser sees of them.
    explicit SimulatedTour(World world);

    const World& world() const { return world_; }
    const DrivenPath& path() const { return path_; }

    std::uint64_t scans() const { return scans_; }
    double scan_time(std::uint64_t k) const {
        return static_cast<double>(k) / world_.laser.rate_hz;
    }
    /// The true pose of the robot at a scan, in the frame of the start: (0, 0, 0) at the first.
    Pose true_pose(std::uint64_t k) const;
    /// The scan with the laser's noise.
    Scan scan(std::uint64_t k) const;

    std::uint64_t readings() const { return readings_; }
    double reading_time(std::uint64_t k) const {
        return static_cast<double>(k) / world_.odometry.rate_hz;
    }
    /// The odometry without noise; reading 0 sets the clock.
    Odometria true_reading(std::uint64_t k) const;

  private:
    World world_;
    DrivenPath path_;
    SimulatedLaser laser_;
    std::vector<Point2> directions_;             // of the rays, in the robot's frame
    std::shared_ptr<const RasterLaser> raster_;  // sees in its place where there is one
    std::uint64_t scans_ = 0;
    std::uint64_t readings_ = 0;
};

}  // namespace hitos
