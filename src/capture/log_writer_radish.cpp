// The text format of [T A.2]. It has no place for the laser's mounting, so ranges and bearings are
// those seen from the robot.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fan_fit.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

class LogWriterRadish final : public TourWriter {
  public:
    using TourWriter::TourWriter;

  private:
    Prepared prepare(const Scan& scan) override;
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
};

void append_reading(std::string& out, double range_m, double bearing_rad) {
    out += ' ';
    append_fixed(out, range_m, 4);
    out += ' ';
    append_fixed(out, bearing_rad, 6);
    out += " 0";
}

/// The format states no greatest range; a reader knows this value for "no return" by itself.
void append_no_return(std::string& out, double bearing_rad, double max_range_m) {
    append_reading(out, std::max(max_range_m, kUnknownMaxRange), bearing_rad);
}

/// Every ray of the fan, in order.
void append_fan(std::string& out, const Scan& scan) {
    const double step = scan.fan.count > 1 ? (scan.fan.max_angle_rad - scan.fan.min_angle_rad) /
                                                 (scan.fan.count - 1)
                                           : 0.0;
    std::size_t next = 0;
    for (std::uint32_t ray = 0; ray < scan.fan.count; ++ray) {
        if (next < scan.rays.size() && scan.rays[next] == ray) {
            const Point2& point = scan.points[next++];
            append_reading(out, std::max(1e-4, std::hypot(point.x, point.y)),
                           std::atan2(point.y, point.x));
        } else {
            append_no_return(
                out,
                wrap_angle(scan.fan.pose_robot_laser.theta + scan.fan.min_angle_rad + ray * step),
                scan.fan.max_range_m);
        }
    }
}

/// The points alone, with one reading without return between two runs.
void append_points(std::string& out, const Scan& scan) {
    std::size_t run = 0;
    double bearing = 0.0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const Point2& point = scan.points[i];
        const double before = bearing;
        bearing = std::atan2(point.y, point.x);
        if (run < scan.run_starts.size() && scan.run_starts[run] == i) {
            if (run > 0) append_no_return(out, (before + bearing) / 2.0, scan.fan.max_range_m);
            ++run;
        }
        append_reading(out, std::max(1e-4, std::hypot(point.x, point.y)), bearing);
    }
    // A line without readings would be damage.
    if (scan.points.empty()) append_no_return(out, 0.0, scan.fan.max_range_m);
}

TourWriter::Prepared LogWriterRadish::prepare(const Scan& scan) {
    Prepared prepared{scan.fan, {}};
    if (scan.fan.count > 0 && scan.rays.size() == scan.points.size()) {
        append_fan(prepared.text, scan);
    } else {
        append_points(prepared.text, scan);
    }
    prepared.text += '\n';
    return prepared;
}

void LogWriterRadish::put_scan(std::string& out, const Prepared& scan, double time_s,
                               const Pose& /*pose_odom_robot*/) {
    out += "laser 0 ";
    append_fixed(out, time_s, 6);
    out += scan.text;
}

void LogWriterRadish::put_odometry(std::string& out, const Odometria& odometry,
                                   const Pose& pose_odom_robot) {
    out += "position 0 ";
    append_fixed(out, odometry.time_s, 6);
    for (const double value : {pose_odom_robot.x, pose_odom_robot.y, pose_odom_robot.theta,
                               odometry.twist.v, odometry.twist.v_lateral, odometry.twist.w}) {
        out += ' ';
        append_fixed(out, value, 6);
    }
    out += '\n';
}

}  // namespace

std::unique_ptr<LogWriter> make_log_writer_radish(const std::filesystem::path& path) {
    return std::make_unique<LogWriterRadish>(path);
}

}  // namespace hitos
