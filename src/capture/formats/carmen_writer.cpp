// SPDX-License-Identifier: GPL-3.0-or-later
// CARMEN logs as they are written: with FLASER where the fan is the one that such a line implies,
// else with ROBOTLASER1.
#include "formats/carmen_writer.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "fan_fit.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/corrected_log.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

void append_pose(std::string& out, const Pose& pose) {
    append_all(out, {pose.x, pose.y, pose.theta}, 6);
}

void append_tail(std::string& out, double time_s) {
    append_all(out, {time_s}, 6);
    out += " hitos";
    append_all(out, {time_s}, 6);
    out += '\n';
}

/// Half a circle from -90 degrees on: to +90 with an odd count, one step less with an even one; the
/// laser ahead of the robot's centre and facing as the robot does.
bool is_implied(const Fan& fan) {
    constexpr double kSame = 1e-6;
    if (fan.count < 2 || fan.pose_robot_laser.y != 0.0 || fan.pose_robot_laser.theta != 0.0) {
        return false;
    }
    const double last = fan.count % 2 == 0 ? kPi / 2.0 - kPi / fan.count : kPi / 2.0;
    return std::abs(fan.min_angle_rad + kPi / 2.0) < kSame &&
           std::abs(fan.max_angle_rad - last) < kSame;
}

class LogWriterCarmen final : public TourWriter {
  public:
    explicit LogWriterCarmen(const std::filesystem::path& path)
        : TourWriter(path), fitter_(path.string()) {}
    LogWriterCarmen(const std::filesystem::path& path, std::vector<Pose> corrected,
                    const Scan& first)
        : TourWriter(path), fitter_(path.string()), corrected_(std::move(corrected)) {
        flaser_ = is_implied(fitter_.sweep(first).fan);
    }

  private:
    Prepared prepare(const Scan& scan) override;
    void put_head(std::string& out) override;
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
    void put_parameters(std::string& out, const Fan& fan, double time_s);

    FanFitter fitter_;
    std::optional<bool> flaser_;  // of the first scan: a reader takes those of one message alone
    std::optional<Fan> told_;     // the fan that the parameters describe
    Twist twist_;                 // of the newest reading
    std::optional<std::vector<Pose>> corrected_;  // of the robot at every scan
    std::size_t put_ = 0;                         // scans so far
};

void LogWriterCarmen::put_head(std::string& out) {
    out +=
        "# CARMEN Logfile\n"
        "# file format is one message per line\n"
        "# message_name [message contents] ipc_timestamp ipc_hostname logger_timestamp\n"
        "# PARAM param_name param_value\n"
        "# ODOM x y theta tv rv accel\n"
        "# FLASER num_readings [range_readings] x y theta odom_x odom_y odom_theta\n"
        "# ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range "
        "accuracy remission_mode num_readings [range_readings] num_remissions [remission_values] "
        "laser_pose_x laser_pose_y laser_pose_theta robot_pose_x robot_pose_y robot_pose_theta "
        "laser_tv laser_rv forward_safety_dist side_safety_dist turn_axis\n";
}

TourWriter::Prepared LogWriterCarmen::prepare(const Scan& scan) {
    const Sweep sweep = fitter_.sweep(scan);
    const Fan& fan = sweep.fan;
    Prepared prepared{fan, {}};
    std::string& out = prepared.text;
    if (!flaser_) flaser_ = is_implied(fan);
    if (*flaser_ && !is_implied(fan)) {
        fitter_.fail(
            scan,
            message(HITOS_TEXT(
                "Errors",
                "its rays are none that FLASER says, as which the scans before it are written")));
    }
    if (*flaser_) {
        out += "FLASER ";
    } else {
        out += "ROBOTLASER1 0";
        append_all(out, {fan.min_angle_rad, fan.max_angle_rad - fan.min_angle_rad, fan.step_rad()},
                   9);
        append_all(out, {fan.max_range_m}, 4);
        out += " 0.010000 0 ";
    }
    append_count(out, fan.count);
    for (const double range : sweep.ranges_m) {
        append_all(out, {range > 0.0 ? writable_range(range, fan.max_range_m) : fan.max_range_m},
                   4);
    }
    return prepared;
}

void LogWriterCarmen::put_parameters(std::string& out, const Fan& fan, double time_s) {
    if (told_ == fan) return;
    told_ = fan;
    const auto put = [&out, time_s](const char* name, double value, int decimals) {
        out += "PARAM ";
        out += name;
        append_all(out, {value}, decimals);
        append_tail(out, time_s);
    };
    put("robot_front_laser_max", fan.max_range_m, 4);
    put("laser_front_laser_resolution", fan.step_rad() * 180.0 / kPi, 12);
    put("robot_frontlaser_offset", fan.pose_robot_laser.x, 6);
}

void LogWriterCarmen::put_scan(std::string& out, const Prepared& scan, double time_s,
                               const Pose& pose_odom_robot) {
    const Pose* corrected = corrected_ ? &corrected_->at(put_++) : nullptr;
    if (*flaser_) {
        put_parameters(out, scan.fan, time_s);
        out += scan.text;
        append_pose(out, corrected != nullptr ? compose(*corrected, scan.fan.pose_robot_laser)
                                              : pose_odom_robot);
        append_pose(out, pose_odom_robot);
    } else {
        // Readers tell the laser's mounting by the two poses: neither may be of another path.
        const Pose& robot = corrected != nullptr ? *corrected : pose_odom_robot;
        out += scan.text;
        out += " 0";
        append_pose(out, compose(robot, scan.fan.pose_robot_laser));
        append_pose(out, robot);
        append_all(out, {twist_.v, twist_.w, 0.0, 0.0, 0.0}, 6);
    }
    append_tail(out, time_s);
}

void LogWriterCarmen::put_odometry(std::string& out, const Odometria& odometry,
                                   const Pose& pose_odom_robot) {
    twist_ = odometry.twist;
    if (corrected_ && !*flaser_) return;  // the scans' lines have another path
    out += "ODOM";
    append_pose(out, pose_odom_robot);
    append_all(out, {odometry.twist.v, odometry.twist.w, 0.0}, 6);
    append_tail(out, odometry.time_s);
}

}  // namespace

std::unique_ptr<LogWriter> make_carmen_writer(const std::filesystem::path& path) {
    return std::make_unique<LogWriterCarmen>(path);
}

std::unique_ptr<LogWriter> make_corrected_log_writer(const std::filesystem::path& path,
                                                     std::vector<Pose> poses, const Scan& first) {
    return std::make_unique<LogWriterCarmen>(path, std::move(poses), first);
}

}  // namespace hitos
