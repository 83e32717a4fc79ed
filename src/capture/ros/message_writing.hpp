// SPDX-License-Identifier: GPL-3.0-or-later
// The ROS messages that a tour is made of, as their bytes, and what ROS 2 says of their types.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ros/messages.hpp"

namespace hitos {

// In CDR, little endian, as ROS 2 has it; what was in `out` is replaced. Fields that the structs do
// not hold are 0, intensities are left out, angle_max is that of the last ray.
void encode(std::string& out, const LaserScanMessage& scan);
void encode(std::string& out, const OdometryMessage& odometry);
void encode(std::string& out, const std::vector<StampedTransform>& transforms);

/// The definition of a type [ROS 2's interfaces, fields only], followed by those of all types that
/// it is made of, as rosbag2 puts them together (encoding "ros2msg").
std::string laser_scan_definition();
std::string odometry_definition();
std::string transforms_definition();

/// The nearest nanosecond.
std::int64_t stamp_of(double time_s);

/// A motion in the plane.
Transform transform_of(const Pose& pose);

}  // namespace hitos
