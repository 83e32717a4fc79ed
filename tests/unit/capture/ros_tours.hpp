// SPDX-License-Identifier: GPL-3.0-or-later
// Small tours as messages.
#pragma once

#include <string>
#include <vector>

#include "unit/capture/ros_writers.hpp"

namespace hitos::test {

inline constexpr const char* kLaserType = "sensor_msgs/LaserScan";
inline constexpr const char* kOdometryMessageType = "nav_msgs/Odometry";
inline constexpr const char* kTransformsType = "tf2_msgs/TFMessage";

inline std::uint64_t at_ns(Stamp stamp) {
    return std::uint64_t{stamp.seconds} * 1'000'000'000 + stamp.nanoseconds;
}

inline Said said_laser(const LaserFields& laser, const Bytes& bytes,
                       const std::string& topic = "/scan") {
    return {topic, kLaserType, laser_message(laser, bytes), at_ns(laser.stamp)};
}

inline Said said_odometry(Stamp stamp, const Placing& pose, const Bytes& bytes,
                          const std::string& topic = "/odom") {
    return {topic, kOdometryMessageType, odometry_message(stamp, pose, 0.5, 0.25, bytes),
            at_ns(stamp)};
}

inline Said said_transforms(const std::vector<Link>& links, const Bytes& bytes,
                            const std::string& topic = "/tf") {
    return {topic, kTransformsType, transforms_message(links, bytes),
            links.empty() ? 0 : at_ns(links.front().stamp)};
}

/// A robot that drives 0.1 m ahead a second and scans: the mounting, then `scans` times odometry
/// and a scan with readings i + 1, i + 2, i + 3 at the same stamp.
inline std::vector<Said> small_tour(const Bytes& bytes, std::uint32_t scans = 5,
                                    std::uint32_t begin_s = 1'700'000'000) {
    std::vector<Said> all;
    all.push_back(said_transforms({{{begin_s, 0}, "base_link", "laser", {0.25, 0.0, 0.1}}}, bytes,
                                  "/tf_static"));
    for (std::uint32_t i = 0; i < scans; ++i) {
        const Stamp stamp{begin_s + i, 250'000'000};
        all.push_back(said_odometry(stamp, {0.1 * i, 0.0}, bytes));
        LaserFields laser;
        laser.stamp = stamp;
        laser.ranges = {1.0F + static_cast<float>(i), 2.0F + static_cast<float>(i),
                        3.0F + static_cast<float>(i)};
        all.push_back(said_laser(laser, bytes));
    }
    return all;
}

}  // namespace hitos::test
