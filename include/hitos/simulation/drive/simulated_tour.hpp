// SPDX-License-Identifier: GPL-3.0-or-later
// A driven tour with what laser and odometry say on it.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/simulation/drive/driven_path.hpp"
#include "hitos/simulation/laser/simulated_laser.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

class RobotMotion;

/// Makes every scan on demand; thread-safe. The noise of a scan depends on seed and scan number
/// alone. One that was driven from the world's way points or commands never changes; one that is
/// live grows as it is driven, and what it has said stays said.
class SimulatedTour {
  public:
    /// Drives the world's tour. Throws what drive() throws. The robot drives among the walls
    /// themselves; a raster is what the laser sees of them.
    explicit SimulatedTour(World world);
    ~SimulatedTour();
    SimulatedTour(const SimulatedTour&) = delete;
    SimulatedTour& operator=(const SimulatedTour&) = delete;

    /// One that stands at the world's start, which has neither way points nor commands from there
    /// on, to be driven by drive_on(). Of its events only boxes and doors of the beginning stay.
    /// Throws as the constructor.
    static std::shared_ptr<SimulatedTour> live(World world);

    /// Asks these velocities of a live tour's robot for one control period. It stands still where a
    /// wall bars its way. Throws ConfigError, and drives no further, for velocities that the robot
    /// cannot have and beyond 10 million periods.
    void drive_on(double v, double w);
    /// Happens to a live tour now, at whatever time the disturbance names. Throws ConfigError where
    /// it cannot happen in this world.
    void disturb(Disturbance disturbance);
    /// All that happens on it, so far: what the world's file says, then what was done by hand;
    /// without boxes and doors of the beginning.
    std::vector<Disturbance> disturbances() const;
    /// The first scan that is not before this time.
    std::uint64_t scan_from(double at_s) const;
    /// The world with what was asked of the robot so far and what happened to it: simulated, it is
    /// this tour to the last bit.
    World recorded() const;
    /// Of the robot in the world, now, and its velocities.
    Pose pose_now() const;
    Twist twist_now() const;
    /// Walls, closed doors and boxes, now.
    std::vector<WallSegment> walls_now() const;
    /// Where everybody is who walks about, in the order of the world's walkers, now.
    std::vector<Point2> people_now() const;
    double duration_s() const;
    /// Ends a live tour: what was driven is the whole.
    void end();
    bool is_live() const;

    const World& world() const { return world_; }
    /// Of a tour that is not driven any more.
    const DrivenPath& path() const;

    /// Those that can be made: of a live tour up to its newest odometry reading.
    std::uint64_t scans() const;
    double scan_time(std::uint64_t k) const {
        return static_cast<double>(k) / world_.laser.rate_hz;
    }
    /// The true pose of the robot at a scan's time, in the frame of the start: (0, 0, 0) at the
    /// first.
    Pose true_pose(std::uint64_t k) const;
    /// The scan with the laser's noise; where the laser sweeps, as it was measured, with the times
    /// of its points. Of a world with landmarks, those that are seen.
    Scan scan(std::uint64_t k) const;

    std::uint64_t readings() const;
    double reading_time(std::uint64_t k) const {
        return static_cast<double>(k) / world_.odometry.rate_hz;
    }
    /// The odometry without noise; reading 0 sets the clock.
    Odometria true_reading(std::uint64_t k) const;
    /// The level of the odometry's noise at a reading.
    double odometry_noise(std::uint64_t k) const;

  private:
    /// Velocities that were asked for, and for how many control periods.
    struct Held {
        double v = 0.0;
        double w = 0.0;
        std::uint64_t periods = 0;
    };
    double settled_s() const;
    Scan seen_landmarks(std::uint64_t k) const;
    double ray_time_s(std::uint32_t ray) const;

    World world_;
    Fan fan_;
    std::vector<Point2> directions_;        // of the rays, in the robot's frame
    std::vector<Point2> laser_directions_;  // and in the laser's
    double ray_step_s_;                     // from one ray to the next; 0: all are of one time
    mutable std::mutex mutex_;
    std::unique_ptr<RobotMotion> motion_;  // guarded by it
    bool live_ = false;                    // likewise, and what is below
    std::vector<Held> held_;
    std::vector<Disturbance> events_;
};

}  // namespace hitos
