// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the world at a time, and what ails robot and laser then.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "hitos/simulation/laser/simulated_laser.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

class RasterLaser;

/// The walls of a time, and a laser among them; immutable and thread-safe.
class Surroundings {
  public:
    Surroundings(std::vector<WallSegment> walls, const World& world);

    /// As SimulatedLaser::cast().
    void cast(const Pose& pose_world_robot, std::vector<RayHit>& out) const;
    /// Of one ray.
    RayHit hit(const Pose& pose_world_robot, std::uint32_t ray) const;
    /// Whether no wall stands between two points [m, world frame]; of worlds with landmarks that
    /// are told. What is fixed to a wall is seen from before it.
    bool sees(const Point2& from, const Point2& to) const;

  private:
    std::vector<WallSegment> walls_;               // where landmarks may be behind them
    std::shared_ptr<const SimulatedLaser> laser_;  // of the two there is one
    std::shared_ptr<const RasterLaser> raster_;
};

/// What holds from one disturbance to the next.
struct Conditions {
    double from_s = 0.0;
    std::size_t changes = 0;  ///< of doors and boxes until then
    double laser_sigma_m = 0.0;
    double odometry_noise = 0.0;
    double blind_until_s = 0.0;
    double slip_until_s = 0.0;
    double slip_left = 0.0;  ///< part of the wheel's way that is lost
    double slip_right = 0.0;
};

/// The conditions of a whole tour, made as it is driven.
class ConditionTrack {
  public:
    explicit ConditionTrack(const World& world);

    /// From `time_s` on, which is not before that of any other: all but a push, which moves the
    /// robot and changes no conditions.
    void apply(const Disturbance& disturbance, double time_s, const World& world);

    const Conditions& at(double time_s) const;
    const Conditions& last() const { return track_.back(); }
    /// Walls, closed doors and boxes, at the end.
    const std::vector<WallSegment>& walls() const { return walls_; }
    /// What stands there under these conditions. Made when it is asked for, as each holds all
    /// walls; the last few are kept. For one thread at a time, as everything here.
    std::shared_ptr<const Surroundings> surroundings(const Conditions& of,
                                                     const World& world) const;

  private:
    /// Those of now and what this brings.
    std::vector<WallSegment> walls_with(const Disturbance& change, const World& world) const;
    std::vector<WallSegment> walls_after(std::size_t changes, const World& world) const;

    std::vector<Conditions> track_;
    std::vector<Disturbance> changes_;
    std::vector<WallSegment> walls_;
    mutable std::deque<std::pair<std::size_t, std::shared_ptr<const Surroundings>>> kept_;
};

/// Where somebody is at a time.
Point2 place_of(const Walker& walker, double time_s);

/// Lets every ray end at the people and trees that it meets from outside, which are circles.
void cast_round_things(const World& world, double time_s, const Pose& pose_world_laser,
                       std::span<const Point2> directions, std::span<RayHit> out);

}  // namespace hitos
