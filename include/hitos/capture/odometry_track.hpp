// SPDX-License-Identifier: GPL-3.0-or-later
// Where the odometry puts the robot at any time of a tour.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// The path that odometry readings, read as they are needed, add up to. Times may go back by some
/// seconds; what lies further back is forgotten.
class OdometryTrack {
  public:
    using Next = std::function<std::optional<Odometria>()>;
    explicit OdometryTrack(Next next) : next_(std::move(next)) {}

    /// In the frame of the first reading's pose; before it the robot stands there, and after the
    /// last one it goes on for a second at the most.
    Pose at(double time_s);

  private:
    struct Knot {
        double time_s = 0.0;
        Pose pose;
        Twist twist;  ///< held until then
    };
    void read_to(double time_s);

    Next next_;
    std::deque<Knot> knots_;
    bool ended_ = false;
};

/// Moves the points to where they would lie had all been measured at the scan's time, and takes
/// their times away. Their rays become those that they lie on then, or nearest to.
void unwarp(Scan& scan, OdometryTrack& track);

}  // namespace hitos
