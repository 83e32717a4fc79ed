// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/messages.hpp"

#include <cmath>
#include <limits>

#include "fan_fit.hpp"
#include "hitos/base/error.hpp"
#include "ros/message_bytes.hpp"

namespace hitos {
namespace {

std::string without_slash(std::string frame) {
    if (frame.starts_with('/')) frame.erase(0, 1);
    return frame;
}

/// Does what may throw FormatError for values that were read whole; nothing where it does, and the
/// reason then goes to `told`.
template <class Check>
auto sound(const Told& told, const Check& check) -> std::optional<decltype(check())> {
    try {
        return check();
    } catch (const FormatError& error) {
        if (told) told(error.problem());
        return std::nullopt;
    }
}

/// As it stands there.
struct RawHeader {
    std::int64_t seconds = 0;
    std::uint32_t rest_ns = 0;
    std::string frame;

    /// Throws FormatError where the stamp is none.
    MessageHeader checked() const {
        if (rest_ns < kSecondNs) return {seconds * kSecondNs + rest_ns, frame};
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors", "field \"%1\": found %2, expected less than %3"),
                          "stamp", rest_ns, kSecondNs);
    }
};

RawHeader take_raw_header(MessageBytes& bytes) {
    RawHeader header;
    if (!bytes.is_cdr()) bytes.take<std::uint32_t>("seq");
    // Unsigned in ROS 1; no clock comes near the difference.
    header.seconds = bytes.is_cdr() ? bytes.take<std::int32_t>("stamp")
                                    : std::int64_t{bytes.take<std::uint32_t>("stamp")};
    header.rest_ns = bytes.take<std::uint32_t>("stamp");
    header.frame = without_slash(bytes.text("frame_id"));
    return header;
}

MessageHeader take_header(MessageBytes& bytes) {
    return take_raw_header(bytes).checked();
}

Transform take_raw_transform(MessageBytes& bytes) {
    Transform t;
    for (double* value : {&t.x, &t.y, &t.z}) *value = bytes.take<double>("position");
    for (double* value : {&t.qx, &t.qy, &t.qz, &t.qw}) *value = bytes.take<double>("orientation");
    return t;
}

/// With a quaternion of length 1. Throws FormatError.
Transform checked(Transform t) {
    for (const double value : {t.x, t.y, t.z}) MessageBytes::checked(value, "position");
    for (const double value : {t.qx, t.qy, t.qz, t.qw}) MessageBytes::checked(value, "orientation");
    const double length = std::sqrt(t.qx * t.qx + t.qy * t.qy + t.qz * t.qz + t.qw * t.qw);
    constexpr double kLeastLength = 1e-3;
    if (!(length > kLeastLength)) {
        throw FormatError(
            {}, 0,
            HITOS_TEXT("Errors", "field \"%1\": found a quaternion of length %2, expected 1"),
            "orientation", length);
    }
    for (double* value : {&t.qx, &t.qy, &t.qz, &t.qw}) *value /= length;
    t.length = length;
    return t;
}

}  // namespace

bool is_transforms_type(std::string_view type) {
    return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage";
}

namespace {

/// The first echo of each ray, which is the nearest thing that sent one back.
void take_first_echoes(MessageBytes& bytes, std::vector<float>& ranges) {
    for (float& range : ranges) {
        const std::uint32_t echoes = bytes.count(sizeof(float), "echoes");
        range = echoes > 0 ? bytes.take<float>("echoes") : std::numeric_limits<float>::infinity();
        if (echoes > 1) bytes.pass(echoes - 1, sizeof(float), "echoes");
    }
}

void pass_intensities(MessageBytes& bytes, bool multi_echo) {
    const std::size_t item = multi_echo ? sizeof(std::uint32_t) : sizeof(float);
    const std::uint32_t intensities = bytes.count(item, "intensities");
    if (!multi_echo) return bytes.pass(intensities, item, "intensities");
    for (std::uint32_t i = 0; i < intensities; ++i) {
        bytes.pass(bytes.count(sizeof(float), "intensities"), sizeof(float), "intensities");
    }
}

}  // namespace

LaserScanMessage decode_laser_scan(std::string_view raw, Encoding encoding, bool multi_echo) {
    MessageBytes bytes(raw, encoding);
    LaserScanMessage scan;
    scan.header = take_header(bytes);
    const auto real = [&bytes](const char* field) {
        return static_cast<double>(bytes.take<float>(field));
    };
    scan.min_angle_rad = MessageBytes::checked(real("angle_min"), "angle_min");
    real("angle_max");  // by definition that of the last ray, which some drivers do not state
    scan.step_rad = MessageBytes::checked(real("angle_increment"), "angle_increment");
    scan.ray_time_s = real("time_increment");
    if (!std::isfinite(scan.ray_time_s)) scan.ray_time_s = 0.0;
    real("scan_time");
    scan.min_range_m = real("range_min");
    scan.max_range_m = real("range_max");
    const std::uint32_t rays =
        bytes.count(multi_echo ? sizeof(std::uint32_t) : sizeof(float), "ranges");
    if (rays == 0 || rays > kMostScannerRays) {
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors", "field \"%1\": found %2 rays, expected 1 to %3"),
                          "ranges", rays, kMostScannerRays);
    }
    scan.ranges_m.resize(rays);
    if (multi_echo) {
        take_first_echoes(bytes, scan.ranges_m);
    } else {
        for (float& range : scan.ranges_m) range = bytes.take<float>("ranges");
    }
    pass_intensities(bytes, multi_echo);
    bytes.expect_end();
    return scan;
}

OdometryMessage decode_odometry(std::string_view raw, Encoding encoding, const Told& told) {
    constexpr std::size_t kCovariance = 36;
    MessageBytes bytes(raw, encoding);
    OdometryMessage odometry;
    odometry.header = take_header(bytes);
    odometry.child_frame = without_slash(bytes.text("child_frame_id"));
    odometry.pose = checked(take_raw_transform(bytes));
    bytes.pass(kCovariance, sizeof(double), "covariance");
    Twist twist;
    twist.v = bytes.take<double>("twist");
    twist.v_lateral = bytes.take<double>("twist");
    for (int i = 0; i < 3; ++i) bytes.take<double>("twist");  // upward, roll, pitch
    twist.w = bytes.take<double>("twist");
    bytes.pass(kCovariance, sizeof(double), "covariance");
    bytes.expect_end();
    odometry.twist = sound(told, [&twist] {
        for (const double value : {twist.v, twist.v_lateral, twist.w}) {
            MessageBytes::checked(value, "twist");
        }
        return twist;
    });
    return odometry;
}

std::vector<StampedTransform> decode_transforms(std::string_view raw, Encoding encoding,
                                                const Told& told) {
    constexpr std::size_t kLeastBytes = 7 * sizeof(double) + 4 * sizeof(std::uint32_t);
    MessageBytes bytes(raw, encoding);
    std::vector<StampedTransform> transforms;
    const std::uint32_t count = bytes.count(kLeastBytes, "transforms");
    transforms.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const RawHeader header = take_raw_header(bytes);
        const std::string child = without_slash(bytes.text("child_frame_id"));
        const Transform transform = take_raw_transform(bytes);
        std::optional<StampedTransform> next = sound(told, [&] {
            return StampedTransform{header.checked(), child, checked(transform)};
        });
        if (next) transforms.push_back(*std::move(next));
    }
    bytes.expect_end();
    return transforms;
}

std::int64_t stamp_in(std::string_view raw, Encoding encoding) {
    MessageBytes bytes(raw, encoding);
    return take_header(bytes).stamp_ns;
}

double seconds_of(std::int64_t stamp_ns) {
    // The whole seconds first: their sum with the rest is rounded once.
    const std::int64_t whole = stamp_ns / kSecondNs;
    return static_cast<double>(whole) +
           static_cast<double>(stamp_ns - whole * kSecondNs) / static_cast<double>(kSecondNs);
}

}  // namespace hitos
