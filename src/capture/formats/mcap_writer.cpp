// SPDX-License-Identifier: GPL-3.0-or-later
// A tour as a recording of ROS 2 in MCAP: what a robot's driver and odometry would have published.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fan_fit.hpp"
#include "formats/formats.hpp"
#include "hitos/base/error.hpp"
#include "recordings/mcap_out.hpp"
#include "ros/message_writing.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

// REP 105's names.
constexpr const char* kOdomFrame = "odom";
constexpr const char* kRobotFrame = "base_link";
constexpr const char* kLibrary = "Hitos " HITOS_VERSION;

/// More places of lasers are no robot's.
constexpr std::size_t kMostMounts = 1000;

/// How rosbag2 publishes a topic again. The numbers are those of files up to version 8, which later
/// rosbag2 take too where the file has a metadata record "rosbag2" without a version.
McapWords offered(bool latched) {
    constexpr const char* kForEver = "\n    sec: 9223372036\n    nsec: 854775807";
    std::string qos = "- history: 1\n  depth: ";
    qos.append(latched ? "1" : "10").append("\n  reliability: 1\n  durability: ");
    qos.append(latched ? "1" : "2").append("\n  deadline:").append(kForEver);
    qos.append("\n  lifespan:").append(kForEver).append("\n  liveliness: 1");
    qos.append("\n  liveliness_lease_duration:").append(kForEver);
    qos.append("\n  avoid_ros_namespace_conventions: false\n");
    return {{"offered_qos_profiles", qos}};
}

std::filesystem::path without_gz(const std::filesystem::path& path) {
    if (path.extension() != ".gz") return path;
    throw FileError(path.string(),
                    HITOS_TEXT("Errors",
                               "cannot be written: MCAP is compressed inside, and no program reads "
                               "it inside of gzip; choose a name without .gz"));
}

class LogWriterMcap final : public TourWriter {
  public:
    explicit LogWriterMcap(const std::filesystem::path& path)
        : TourWriter(without_gz(path)), path_(path.string()), fitter_(path_) {}

  private:
    Prepared prepare(const Scan& scan) override;
    void put_head(std::string& out) override;
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
    void put_tail(std::string& out) override { mcap_.finish(out); }

    std::int64_t stamp(double time_s) const;
    const std::string& laser_frame(std::string& out, const Pose& pose_robot_laser,
                                   std::int64_t stamp_ns);
    template <class Message>
    void put_message(std::string& out, std::size_t topic, std::int64_t stamp_ns,
                     const Message& message);

    std::string path_;
    FanFitter fitter_;
    McapOut mcap_;
    const std::size_t scan_ =
        mcap_.add({"/scan", "sensor_msgs/msg/LaserScan", laser_scan_definition(), offered(false)});
    const std::size_t odom_ =
        mcap_.add({"/odom", "nav_msgs/msg/Odometry", odometry_definition(), offered(false)});
    const std::size_t tf_ =
        mcap_.add({"/tf", "tf2_msgs/msg/TFMessage", transforms_definition(), offered(false)});
    const std::size_t tf_static_ =
        mcap_.add({"/tf_static", "tf2_msgs/msg/TFMessage", transforms_definition(), offered(true)});
    /// The places of lasers that were told.
    std::vector<std::pair<Pose, StampedTransform>> mounts_;
    LaserScanMessage laser_;
    std::string bytes_;
};

/// What the reader takes for a point: more than nothing and less than the greatest range, which it
/// rounds to three decimals where that is less.
float sound_range(double range_m, float max_range_m) {
    const auto stated = static_cast<double>(max_range_m);
    const double limit = std::min(stated, std::round(stated * 1000.0) / 1000.0);
    auto range = static_cast<float>(range_m);
    if (!(static_cast<double>(range) < limit)) {
        range = static_cast<float>(limit);
        while (!(static_cast<double>(range) < limit)) range = std::nextafterf(range, 0.0F);
    }
    return std::max(range, std::numeric_limits<float>::min());
}

/// From one ray to the next, where the rays have times.
double ray_time_of(const Scan& scan) {
    if (scan.times_s.size() < 2 || scan.rays.size() != scan.times_s.size()) return 0.0;
    const double rays = static_cast<double>(scan.rays.back()) - scan.rays.front();
    const auto seconds = static_cast<double>(scan.times_s.back() - scan.times_s.front());
    return rays == 0.0 ? 0.0 : seconds / rays;
}

TourWriter::Prepared LogWriterMcap::prepare(const Scan& scan) {
    const Sweep sweep = fitter_.sweep(scan);
    // Rays without a return: REP 117.
    std::vector<float> ranges(sweep.ranges_m.size(), std::numeric_limits<float>::infinity());
    const auto max_range = static_cast<float>(sweep.fan.max_range_m);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (sweep.ranges_m[i] > 0.0) ranges[i] = sound_range(sweep.ranges_m[i], max_range);
    }
    Prepared prepared{sweep.fan, {}, ray_time_of(scan)};
    if (prepared.ray_time_s < 0.0) {  // messages say rays in the order in which they were measured
        std::swap(prepared.fan.min_angle_rad, prepared.fan.max_angle_rad);
        std::ranges::reverse(ranges);
        prepared.ray_time_s = -prepared.ray_time_s;
    }
    prepared.text.resize(ranges.size() * sizeof(float));
    std::memcpy(prepared.text.data(), ranges.data(), prepared.text.size());
    return prepared;
}

void LogWriterMcap::put_head(std::string& out) {
    mcap_.begin(out, kLibrary);
    mcap_.put_metadata(out, "rosbag2", {{"ROS_DISTRO", ""}});
}

std::int64_t LogWriterMcap::stamp(double time_s) const {
    constexpr double kEnd = 2147483648.0;  // a stamp has 32 bits of seconds, with a sign
    if (time_s >= 0.0 && time_s < kEnd - 1.0) return stamp_of(time_s);
    throw FormatError(path_, 0,
                      HITOS_TEXT("Errors",
                                 "the time %1 cannot be a stamp of ROS, which has 0 to %2 seconds; "
                                 "write the normalized format"),
                      time_s, static_cast<std::int64_t>(kEnd) - 2);
}

template <class Message>
void LogWriterMcap::put_message(std::string& out, std::size_t topic, std::int64_t stamp_ns,
                                const Message& message) {
    encode(bytes_, message);
    mcap_.put_message(out, topic, static_cast<std::uint64_t>(stamp_ns), bytes_);
}

/// The frame of a laser that sits there; a new one is told before its first scan, and all others
/// again, as a latched topic keeps its last message only.
const std::string& LogWriterMcap::laser_frame(std::string& out, const Pose& pose_robot_laser,
                                              std::int64_t stamp_ns) {
    const auto known = std::ranges::find_if(
        mounts_, [&](const auto& mount) { return mount.first == pose_robot_laser; });
    if (known != mounts_.end()) return known->second.child_frame;
    if (mounts_.size() == kMostMounts) {
        throw FormatError(
            path_, 0,
            HITOS_TEXT("Errors",
                       "its lasers sit in more than %1 places; write the normalized format"),
            kMostMounts);
    }
    StampedTransform mount{{stamp_ns, kRobotFrame}, "laser", transform_of(pose_robot_laser)};
    if (!mounts_.empty()) mount.child_frame += "_" + std::to_string(mounts_.size() + 1);
    mounts_.emplace_back(pose_robot_laser, std::move(mount));
    std::vector<StampedTransform> all;
    for (const auto& [place, transform] : mounts_) all.push_back(transform);
    put_message(out, tf_static_, stamp_ns, all);
    return mounts_.back().second.child_frame;
}

void LogWriterMcap::put_scan(std::string& out, const Prepared& scan, double time_s,
                             const Pose& /*pose_odom_robot*/) {
    laser_.header.stamp_ns = stamp(time_s);
    laser_.header.frame = laser_frame(out, scan.fan.pose_robot_laser, laser_.header.stamp_ns);
    laser_.min_angle_rad = scan.fan.min_angle_rad;
    laser_.step_rad = scan.fan.step_rad();
    // Rays in one direction, which no message may say: the least step leaves them there.
    if (static_cast<float>(laser_.step_rad) == 0.0F) {
        laser_.step_rad = static_cast<double>(std::numeric_limits<float>::min());
    }
    laser_.ray_time_s = scan.ray_time_s;
    laser_.max_range_m = scan.fan.max_range_m;
    laser_.ranges_m.resize(scan.fan.count);
    std::memcpy(laser_.ranges_m.data(), scan.text.data(), scan.text.size());
    put_message(out, scan_, laser_.header.stamp_ns, laser_);
}

void LogWriterMcap::put_odometry(std::string& out, const Odometria& odometry,
                                 const Pose& pose_odom_robot) {
    OdometryMessage reading;
    reading.header = {stamp(odometry.time_s), kOdomFrame};
    reading.child_frame = kRobotFrame;
    reading.pose = transform_of(pose_odom_robot);
    reading.twist = odometry.twist;
    put_message(out, odom_, reading.header.stamp_ns, reading);
    put_message(out, tf_, reading.header.stamp_ns,
                std::vector<StampedTransform>{{reading.header, kRobotFrame, reading.pose}});
}

}  // namespace

std::unique_ptr<LogWriter> make_mcap_writer(const std::filesystem::path& path) {
    return std::make_unique<LogWriterMcap>(path);
}

}  // namespace hitos
