// SPDX-License-Identifier: GPL-3.0-or-later
// How the robot follows the velocities that are asked of it.
#pragma once

#include <vector>

#include "conditions.hpp"
#include "hitos/simulation/drive/driven_path.hpp"

namespace hitos {

/// Holds path and conditions of a tour while it is driven, a control period at a time. The world
/// stays the caller's; its events are those of a tour that was written beforehand.
class RobotMotion {
  public:
    explicit RobotMotion(const World& world);

    /// Changes the velocities towards the wanted ones as fast as the robot can, and holds them for
    /// one control period. What the world's events ask for by now happens first.
    void command(double v, double w);
    /// The same, but where the way is barred the robot stands still at once.
    void command_among_walls(double v, double w);
    /// Happens now.
    void disturb(const Disturbance& disturbance);

    const Pose& pose() const { return path_.poses().back(); }
    const Twist& twist() const { return twist_; }
    std::size_t steps() const { return path_.twists().size(); }
    double time_s() const { return path_.duration_s(); }
    const DrivenPath& path() const { return path_; }
    const ConditionTrack& conditions() const { return conditions_; }
    /// Least distance of that wall from the last control period's way [m], at the least.
    double gap(const WallSegment& wall) const;
    /// The same of a tree, or post, that a laser sees: by its place among the world's landmarks.
    double gap_to_tree(std::size_t tree) const;

  private:
    struct Way {
        Point2 from;
        Point2 to;
        double bulge_m = 0.0;  // how far an arc leaves the straight way
    };

    Way last_way() const;
    Twist next_twist(double v, double w) const;
    Twist motion_of(const Twist& wheels) const;
    void take_events();
    void hold(const Twist& wheels);
    bool barred(const Twist& twist) const;

    const World& world_;
    double period_s_;
    DrivenPath path_;
    ConditionTrack conditions_;
    Twist twist_;
    std::vector<Disturbance> events_;  // by time
    std::size_t taken_ = 0;
};

}  // namespace hitos
