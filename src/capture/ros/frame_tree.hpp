// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a robot, as /tf and /tf_static tell them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ros/messages.hpp"
#include "ros/transform.hpp"

namespace hitos {

/// Every frame's newest transform to its parent.
class FrameTree {
  public:
    /// The newest replaces the one before. Throws FormatError beyond 4096 frames.
    void hold(const std::vector<StampedTransform>& transforms);
    /// Takes over what the other tree knows of frames that are new here.
    void complete(const FrameTree& other);

    /// Says that both names are one frame: the one that has no parent yet gets the other. Nothing
    /// where both have one.
    void join(const std::string& a, const std::string& b);
    /// Whether both trees tell the frame's place and tell it differently, by more than 1 mm or
    /// milliradian.
    bool differs(const FrameTree& other, std::string_view frame) const;
    /// The frame and those above it, as far as `end`, which is none of them.
    std::vector<std::string> above(std::string_view frame, std::string_view end) const;
    /// The frames whose parent is called odom, or ends so, with these.
    std::vector<std::pair<std::string, std::string>> below_odometry() const;

    /// Each frame with its parent, by their names.
    std::vector<std::pair<std::string, std::string>> links() const;

    bool empty() const { return links_.empty(); }
    bool knows(std::string_view frame) const { return links_.find(frame) != links_.end(); }
    /// a_b: from frame b's coordinates to those of frame a; nothing where no chain joins them on
    /// the robot: frames above b that are called odom, map or world end it.
    std::optional<Transform> between(std::string_view a, std::string_view b) const;
    /// The frame that moves in the world when the robot does, above `frame`: the first whose parent
    /// is called odom (or ends so), and that parent; else the last frame below a parent "map" or
    /// "world", or the root, and an empty name.
    std::pair<std::string, std::string> robot_above(std::string_view frame) const;

  private:
    struct Link {
        std::string parent;
        Transform transform;  ///< parent_frame
    };
    /// The frame and those above it, with the transforms to them. Circles end.
    std::vector<std::pair<std::string, Transform>> upwards(std::string_view frame) const;

    std::map<std::string, Link, std::less<>> links_;
};

/// "odom", "robot1/odom", "wheel_odom"
bool is_odometry_frame(std::string_view frame);

}  // namespace hitos
