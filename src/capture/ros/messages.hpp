// SPDX-License-Identifier: GPL-3.0-or-later
// The ROS messages that a tour is made of, from their bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"
#include "recordings/recording.hpp"
#include "ros/transform.hpp"

namespace hitos {

inline constexpr std::int64_t kSecondNs = 1'000'000'000;

inline constexpr std::string_view kLaserScanType = "sensor_msgs/LaserScan";
inline constexpr std::string_view kMultiEchoType = "sensor_msgs/MultiEchoLaserScan";
inline constexpr std::string_view kOdometryType = "nav_msgs/Odometry";

/// tf2_msgs/TFMessage and its forerunner.
bool is_transforms_type(std::string_view type);

/// std_msgs/Header; the frame without the slash that tf once had before it.
struct MessageHeader {
    std::int64_t stamp_ns = 0;
    std::string frame;
};

/// sensor_msgs/LaserScan as far as it is used; angles [rad], ranges [m]. Of a
/// sensor_msgs/MultiEchoLaserScan the first echo of each ray.
struct LaserScanMessage {
    MessageHeader header;
    double min_angle_rad = 0.0;
    double step_rad = 0.0;
    double ray_time_s = 0.0;  ///< from one ray to the next; 0 where it is not known
    double min_range_m = 0.0;
    double max_range_m = 0.0;
    std::vector<float> ranges_m;  ///< as logged, NaN and infinities included
};

/// nav_msgs/Odometry without covariances.
struct OdometryMessage {
    MessageHeader header;
    std::string child_frame;
    Transform pose;
    std::optional<Twist> twist;  ///< in the child frame; nothing where its numbers are not finite
};

/// geometry_msgs/TransformStamped
struct StampedTransform {
    MessageHeader header;  ///< its frame is the parent
    std::string child_frame;
    Transform transform;
};

// The decoders throw FormatError that says what was found and expected, with neither path nor line:
// lengths beyond the message, bytes left over, numbers that are not finite where they must be, a
// quaternion without length, more than 1e6 rays. What can be read behind something wrong is kept:
// one transform of several, or a pose without its twist, is left out and `told`.
using Told = std::function<void(const Message& problem)>;
LaserScanMessage decode_laser_scan(std::string_view bytes, Encoding encoding,
                                   bool multi_echo = false);
OdometryMessage decode_odometry(std::string_view bytes, Encoding encoding, const Told& told = {});
std::vector<StampedTransform> decode_transforms(std::string_view bytes, Encoding encoding,
                                                const Told& told = {});

/// When a message that begins with a header was stamped, without decoding the rest. Throws
/// FormatError.
std::int64_t stamp_in(std::string_view bytes, Encoding encoding);

/// Seconds since 1970; to 0.2 µs at the stamps of today.
double seconds_of(std::int64_t stamp_ns);

}  // namespace hitos
