// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/message_writing.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace hitos {
namespace {

static_assert(std::endian::native == std::endian::little);

/// CDR [OMG DDS-XTypes 7.4, PLAIN_CDR]: numbers stand at multiples of their size, counted from
/// behind the head; texts and sequences have their length before them.
class CdrOut {
  public:
    explicit CdrOut(std::string& out) : out_(out) {
        constexpr std::string_view kLittleEndian{"\0\1\0\0", kHead};
        out_ = kLittleEndian;
    }

    template <class Number>
    CdrOut& put(Number value) {
        align(sizeof value);
        std::array<char, sizeof value> raw{};
        std::memcpy(raw.data(), &value, sizeof value);
        out_.append(raw.data(), raw.size());
        return *this;
    }
    CdrOut& real(double value) { return put(static_cast<float>(value)); }
    CdrOut& count(std::size_t items) { return put(static_cast<std::uint32_t>(items)); }
    CdrOut& text(std::string_view text) {
        count(text.size() + 1);
        out_ += text;
        out_ += '\0';
        return *this;
    }
    CdrOut& floats(const std::vector<float>& values) {
        count(values.size());
        const std::size_t begin = out_.size();
        out_.resize(begin + values.size() * sizeof(float));
        if (!values.empty()) {
            std::memcpy(out_.data() + begin, values.data(), values.size() * sizeof(float));
        }
        return *this;
    }
    CdrOut& zeros(std::size_t numbers) {
        align(sizeof(double));
        out_.append(numbers * sizeof(double), '\0');
        return *this;
    }
    CdrOut& header(const MessageHeader& header) {
        const std::int64_t seconds = header.stamp_ns / kSecondNs;
        put(static_cast<std::int32_t>(seconds));
        put(static_cast<std::uint32_t>(header.stamp_ns - seconds * kSecondNs));
        return text(header.frame);
    }
    CdrOut& transform(const Transform& t) {
        for (const double value : {t.x, t.y, t.z, t.qx, t.qy, t.qz, t.qw}) put(value);
        return *this;
    }

  private:
    static constexpr std::size_t kHead = 4;

    void align(std::size_t size) {
        const std::size_t beyond = (out_.size() - kHead) % size;
        if (beyond > 0) out_.append(size - beyond, '\0');
    }

    std::string& out_;
};

constexpr std::string_view kHeader =
    "builtin_interfaces/Time stamp\n"
    "string frame_id\n";
constexpr std::string_view kTime =
    "int32 sec\n"
    "uint32 nanosec\n";
constexpr std::string_view kVector3 =
    "float64 x\n"
    "float64 y\n"
    "float64 z\n";
constexpr std::string_view kQuaternion =
    "float64 x 0\n"
    "float64 y 0\n"
    "float64 z 0\n"
    "float64 w 1\n";

using Part = std::pair<std::string_view, std::string_view>;

std::string definition(std::string_view own, std::initializer_list<Part> parts) {
    constexpr std::size_t kRule = 80;
    std::string text(own);
    for (const auto& [type, fields] : parts) {
        text.append(kRule, '=').append("\nMSG: ").append(type).append("\n").append(fields);
    }
    return text;
}

}  // namespace

void encode(std::string& out, const LaserScanMessage& scan) {
    const auto rays = static_cast<double>(scan.ranges_m.size());
    CdrOut cdr(out);
    cdr.header(scan.header).real(scan.min_angle_rad);
    cdr.real(scan.min_angle_rad + (rays - 1.0) * scan.step_rad).real(scan.step_rad);
    cdr.real(scan.ray_time_s).real(0.0);  // from scan to scan [s]: not known
    cdr.real(scan.min_range_m).real(scan.max_range_m);
    cdr.floats(scan.ranges_m).count(0);
}

void encode(std::string& out, const OdometryMessage& odometry) {
    constexpr std::size_t kCovariance = 36;
    CdrOut cdr(out);
    cdr.header(odometry.header).text(odometry.child_frame);
    cdr.transform(odometry.pose).zeros(kCovariance);
    const Twist twist = odometry.twist.value_or(Twist{});
    for (const double value : {twist.v, twist.v_lateral, 0.0, 0.0, 0.0, twist.w}) cdr.put(value);
    cdr.zeros(kCovariance);
}

void encode(std::string& out, const std::vector<StampedTransform>& transforms) {
    CdrOut cdr(out);
    cdr.count(transforms.size());
    for (const StampedTransform& next : transforms) {
        cdr.header(next.header).text(next.child_frame).transform(next.transform);
    }
}

std::string laser_scan_definition() {
    return definition(
        "std_msgs/Header header\n"
        "float32 angle_min\n"
        "float32 angle_max\n"
        "float32 angle_increment\n"
        "float32 time_increment\n"
        "float32 scan_time\n"
        "float32 range_min\n"
        "float32 range_max\n"
        "float32[] ranges\n"
        "float32[] intensities\n",
        {{"std_msgs/Header", kHeader}, {"builtin_interfaces/Time", kTime}});
}

std::string odometry_definition() {
    return definition(
        "std_msgs/Header header\n"
        "string child_frame_id\n"
        "geometry_msgs/PoseWithCovariance pose\n"
        "geometry_msgs/TwistWithCovariance twist\n",
        {{"std_msgs/Header", kHeader},
         {"builtin_interfaces/Time", kTime},
         {"geometry_msgs/PoseWithCovariance", "Pose pose\nfloat64[36] covariance\n"},
         {"geometry_msgs/Pose", "Point position\nQuaternion orientation\n"},
         {"geometry_msgs/Point", kVector3},
         {"geometry_msgs/Quaternion", kQuaternion},
         {"geometry_msgs/TwistWithCovariance", "Twist twist\nfloat64[36] covariance\n"},
         {"geometry_msgs/Twist", "Vector3 linear\nVector3 angular\n"},
         {"geometry_msgs/Vector3", kVector3}});
}

std::string transforms_definition() {
    return definition("geometry_msgs/TransformStamped[] transforms\n",
                      {{"geometry_msgs/TransformStamped",
                        "std_msgs/Header header\n"
                        "string child_frame_id\n"
                        "Transform transform\n"},
                       {"std_msgs/Header", kHeader},
                       {"builtin_interfaces/Time", kTime},
                       {"geometry_msgs/Transform", "Vector3 translation\nQuaternion rotation\n"},
                       {"geometry_msgs/Vector3", kVector3},
                       {"geometry_msgs/Quaternion", kQuaternion}});
}

std::int64_t stamp_of(double time_s) {
    // The whole seconds first: what is left of them is exact.
    const double whole_s = std::floor(time_s);
    return static_cast<std::int64_t>(whole_s) * kSecondNs +
           std::llround((time_s - whole_s) * static_cast<double>(kSecondNs));
}

Transform transform_of(const Pose& pose) {
    Transform t;
    t.x = pose.x;
    t.y = pose.y;
    t.qz = std::sin(pose.theta / 2.0);
    t.qw = std::cos(pose.theta / 2.0);
    return t;
}

}  // namespace hitos
