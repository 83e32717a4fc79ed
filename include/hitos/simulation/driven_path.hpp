// The true motion of the robot along the way points.
#pragma once

#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/simulation/world.hpp"

namespace hitos {

/// A motion of constant twists, each held for one control period: exact at every time.
class DrivenPath {
  public:
    DrivenPath(const Pose& start, double rate_hz) : rate_hz_(rate_hz), poses_{start} {}

    /// Holds the twist for one more period.
    void append(const Twist& twist);

    double rate_hz() const { return rate_hz_; }
    double duration_s() const { return static_cast<double>(twists_.size()) / rate_hz_; }
    /// Length of the way [m].
    double length_m() const;
    /// World pose of the robot; the time is clamped to the tour.
    Pose pose_at(double time_s) const;
    /// The constant twist that makes exactly the motion between two times: the one that was held
    /// where there was only one.
    Twist twist_between_times(double from_s, double to_s) const;

    const std::vector<Pose>& poses() const { return poses_; }     ///< at k / rate_hz
    const std::vector<Twist>& twists() const { return twists_; }  ///< from pose k to pose k + 1

  private:
    /// The control step that holds at a time, and how far into it the time is.
    struct Place {
        std::size_t step = 0;
        double since_s = 0.0;
    };
    Place place_of(double time_s) const;

    double rate_hz_;
    std::vector<Pose> poses_;
    std::vector<Twist> twists_;
};

/// Drives the world's tour, without noise (docs/simulation.md has the control law). Throws
/// ConfigError for impossible values and FormatError, naming the way point, where the start or the
/// way is too near to a wall or a way point cannot be driven to.
DrivenPath drive(const World& world);

/// The distance [m] of a point from a wall.
double distance(const WallSegment& wall, const Point2& point);

/// The least distance [m] between a wall and the straight way from `from` to `to`.
double distance(const WallSegment& wall, const Point2& from, const Point2& to);

}  // namespace hitos
