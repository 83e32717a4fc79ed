// SPDX-License-Identifier: GPL-3.0-or-later
// The true motion of the robot along the way points.
#pragma once

#include <optional>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// A motion of constant twists, each held for one control period: exact at every time. What the
/// wheels say of it is another motion where one slips or the robot is carried.
class DrivenPath {
  public:
    DrivenPath(const Pose& start, double rate_hz) : rate_hz_(rate_hz), motion_{{start}, {}} {}

    /// Holds the twist for one more period.
    void append(const Twist& twist) { append(twist, twist); }
    /// The same where the wheels turn for another motion.
    void append(const Twist& twist, const Twist& wheels);
    /// Carries the robot, by a pose in its own frame; in no time, and its wheels do not turn.
    void displace(const Pose& by);

    double rate_hz() const { return rate_hz_; }
    double duration_s() const { return static_cast<double>(twists().size()) / rate_hz_; }
    /// Length of the way [m].
    double length_m() const;
    /// World pose of the robot, after what carried it at that time; the time is clamped to the
    /// tour.
    Pose pose_at(double time_s) const;
    /// The constant twist that makes exactly the motion that the wheels say between two times: the
    /// one that was held where there was only one.
    Twist twist_between_times(double from_s, double to_s) const;

    const std::vector<Pose>& poses() const { return motion_.poses; }     ///< at k / rate_hz
    const std::vector<Twist>& twists() const { return motion_.twists; }  ///< from pose k to k + 1

  private:
    struct Motion {
        std::vector<Pose> poses;
        std::vector<Twist> twists;
        void append(const Twist& twist, double period_s);
    };
    /// The control step that holds at a time, and how far into it the time is.
    struct Place {
        std::size_t step = 0;
        double since_s = 0.0;
    };
    Place place_of(double time_s) const;
    static Pose pose_of(const Motion& motion, const Place& place);

    double rate_hz_;
    Motion motion_;
    std::optional<Motion> wheels_;  // where they have said anything else
};

/// Drives the world's tour, without noise (docs/simulation.md has the control law). Throws
/// ConfigError for impossible values and FormatError, naming the way point, where the start or the
/// way is too near to a wall or a way point cannot be driven to.
DrivenPath drive(const World& world);

}  // namespace hitos
