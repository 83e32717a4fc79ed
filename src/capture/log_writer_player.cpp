// The lines of Player's writelog driver [T A.1], with more decimals than it prints.
#include <optional>

#include "fan_fit.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

constexpr Layout kPose{6, 10, true, '0'};
constexpr Layout kAngle{8, 11, true, '0'};
constexpr Layout kRange{4, 7, true, '0'};

class LogWriterPlayer final : public TourWriter {
  public:
    explicit LogWriterPlayer(const std::filesystem::path& path)
        : TourWriter(path), fitter_(path.string()) {}

  private:
    Prepared prepare(const Scan& scan) override;
    void put_head(std::string& out) override;
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;

    FanFitter fitter_;
    std::optional<Pose> told_mount_;
};

void append_message(std::string& out, double time_s, const char* message) {
    append_fixed(out, time_s, Layout{6, 17, false, '0'});
    out += " 16777343 6665 ";  // 127.0.0.1 as Player writes it, and its port
    out += message;
}

void append_all(std::string& out, std::initializer_list<double> values, const Layout& layout) {
    for (const double value : values) {
        out += ' ';
        append_fixed(out, value, layout);
    }
}

void LogWriterPlayer::put_head(std::string& out) {
    out +=
        "## Player version 3.1.0 (text written by Hitos)\n"
        "## File version 0.3.0 \n"
        "## Format: \n"
        "## - Messages are newline-separated\n"
        "## - Common header to each message is:\n"
        "##   time     host   robot  interface index  type   subtype\n"
        "##   (double) (uint) (uint) (string)  (uint) (uint) (uint)\n"
        "## - Following the common header is the message payload \n";
}

TourWriter::Prepared LogWriterPlayer::prepare(const Scan& scan) {
    const Sweep sweep = fitter_.sweep(scan);
    Prepared prepared{sweep.fan, {}};
    std::string& out = prepared.text;
    const double step = sweep.fan.count > 1 ? (sweep.fan.max_angle_rad - sweep.fan.min_angle_rad) /
                                                  (sweep.fan.count - 1)
                                            : 0.0;
    out += " 0000";
    append_all(out, {sweep.fan.min_angle_rad, sweep.fan.max_angle_rad, step}, kAngle);
    out += ' ';
    append_fixed(out, sweep.fan.max_range_m, kRange);
    out += ' ';
    append_count(out, sweep.fan.count, 4);
    for (const double range : sweep.ranges_m) {
        const bool hit = range > 0.0;
        out += ' ';
        append_fixed(out,
                     hit ? writable_range(range, sweep.fan.max_range_m) : sweep.fan.max_range_m, 4);
        out += hit ? "  1" : "  0";
    }
    out += " \n";
    return prepared;
}

void LogWriterPlayer::put_scan(std::string& out, const Prepared& scan, double time_s,
                               const Pose& /*pose_odom_robot*/) {
    const Pose& mount = scan.fan.pose_robot_laser;
    if (told_mount_ != mount) {
        told_mount_ = mount;
        append_message(out, time_s, "laser 00 004 001 ");
        append_all(out, {mount.x, mount.y}, Layout{6, 10, true, ' '});
        append_all(out, {mount.theta, 0.0, 0.0}, Layout{6, 9, false, ' '});
        out += '\n';
    }
    append_message(out, time_s, "laser 00 001 001");
    out += scan.text;
}

void LogWriterPlayer::put_odometry(std::string& out, const Odometria& odometry,
                                   const Pose& pose_odom_robot) {
    append_message(out, odometry.time_s, "position2d 00 001 001");
    append_all(out,
               {pose_odom_robot.x, pose_odom_robot.y, pose_odom_robot.theta, odometry.twist.v,
                odometry.twist.v_lateral, odometry.twist.w},
               kPose);
    out += " 0\n";
}

}  // namespace

std::unique_ptr<LogWriter> make_log_writer_player(const std::filesystem::path& path) {
    return std::make_unique<LogWriterPlayer>(path);
}

}  // namespace hitos
