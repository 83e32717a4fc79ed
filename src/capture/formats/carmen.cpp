// CARMEN logs: ODOM, FLASER, ROBOTLASER1, RAWLASER1 and the parameters that describe the laser.
// Written with FLASER where the fan is the one that such a line implies, else with ROBOTLASER1.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "fan_fit.hpp"
#include "formats/formats.hpp"
#include "hitos/base/translatable.hpp"
#include "range_conversor.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

bool is_scan(std::string_view name) {
    return name == "FLASER" || name == "ROBOTLASER1" || name == "RAWLASER1";
}

bool is_parameter(std::string_view name) {
    constexpr std::array<std::string_view, 5> kNames = {
        "robot_front_laser_max", "laser_front_laser_resolution", "robot_frontlaser_offset",
        "robot_frontlaser_side_offset", "robot_frontlaser_angular_offset"};
    return std::ranges::find(kNames, name) != kNames.end();
}

bool claims(std::string_view text) {
    if (text.starts_with("# CARMEN Logfile")) return true;
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "ODOM") return fields.remaining() >= 8 && parse_double(fields.take());
    if (name == "PARAM") return fields.remaining() >= 2;
    constexpr std::array<std::string_view, 3> kStems = {"RAWLASER", "ROBOTLASER", "TRUEPOS"};
    return name == "FLASER" || name == "RLASER" ||
           std::ranges::any_of(kStems, [name](auto stem) { return name.starts_with(stem); });
}

LineKind classify(std::string_view text) {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "ODOM") return LineKind::odometry;
    if (is_scan(name)) return name == "RAWLASER1" ? LineKind::scan : LineKind::both;
    if (name == "PARAM") return is_parameter(fields.take()) ? LineKind::scan : LineKind::other;
    return other_or_damaged(text);
}

constexpr double kDegree = kPi / 180.0;

Pose take_pose(Fields& fields, const char* x, const char* y, const char* theta) {
    Pose pose;
    pose.x = fields.number(x);
    pose.y = fields.number(y);
    pose.theta = fields.number(theta);
    return pose;
}

/// `time host logger_time`; some programs leave the last one out.
double take_tail(Fields& fields) {
    const double time_s = fields.number("time");
    fields.word("host");
    if (!fields.at_end()) fields.number("logger_time");
    fields.expect_end(HITOS_TEXT("Errors", "the logger's time"));
    return time_s;
}

/// The fan of a FLASER line, which does not state it. Even counts leave the last ray of the half
/// circle out: -90 deg ... +90 deg - step.
Fan implied_fan(std::uint32_t count, double resolution_deg) {
    Fan fan;
    fan.count = count;
    if (count == 1) return fan;
    const double steps = count - 1;
    double step_deg = count % 2 == 0 ? 180.0 / count : 180.0 / steps;
    double start_deg = -90.0;
    if (resolution_deg > 0.0) {
        step_deg = resolution_deg;
        const bool half_circle =
            count % 2 == 0 && std::abs(count * step_deg - 180.0) < step_deg / 2;
        if (!half_circle) start_deg = -steps * step_deg / 2.0;
    }
    fan.min_angle_rad = start_deg * kDegree;
    fan.max_angle_rad = (start_deg + steps * step_deg) * kDegree;
    return fan;
}

/// The fan of a line that states first angle, field of view and resolution. The last ray ends the
/// field of view or, where the count shows so, lies one step before its end.
Fan stated_fan(double start_rad, double view_rad, double resolution_rad, std::uint32_t count) {
    Fan fan;
    fan.count = count;
    fan.min_angle_rad = start_rad;
    fan.max_angle_rad = start_rad;
    if (count == 1) return fan;
    const double steps = count - 1;
    const double half = resolution_rad / 2.0;
    double span = view_rad;
    if (resolution_rad > 0.0 && std::abs(steps * resolution_rad - view_rad) >= half) {
        const bool one_left_out = std::abs(count * resolution_rad - view_rad) < half;
        span = one_left_out ? view_rad * steps / count : steps * resolution_rad;
    }
    fan.max_angle_rad = start_rad + span;
    return fan;
}

/// The ranges of a line; checked and passed over where there is no `out`.
void take_ranges(Fields& fields, std::uint32_t count, RangeConversor::Readings* out) {
    if (out == nullptr) {
        fields.readings(count, std::array{"range"}, [](std::size_t, double) {});
        return;
    }
    fields.readings(count, std::array{"range"},
                    [out](std::size_t, double value) { out->ranges_m.push_back(value); });
}

/// Passes over the block of remissions and says whether there is one. Lines from before CARMEN
/// knew remission have none: then the next field is a coordinate or a stamp, written with a point.
bool skip_remissions(Fields& fields, bool with_pose) {
    const std::optional<std::int64_t> count = parse_integer(fields.peek());
    // What follows: two poses and five numbers (robot laser), time, host, perhaps the logger's
    // time.
    const std::size_t least = with_pose ? 13 : 2;
    const std::size_t left = fields.remaining();
    if (!count || left <= least) return false;
    const std::uint32_t remissions = fields.count("num_remissions", 0);
    if (left < 1 + remissions + least || left > 2 + remissions + least) {
        fields.fail(message(HITOS_TEXT("Errors", "num_remissions: found %1, but %2 fields follow"),
                            remissions, left - 1));
    }
    fields.readings(remissions, std::array{"remission"}, [](std::size_t, double) {});
    return true;
}

/// One line, in full.
struct CarmenMessage {
    double time_s = 0.0;
    std::optional<Pose> pose_odom_robot;
    std::optional<Twist> velocity;
};

class ConversorCarmen final : public RangeConversor {
  public:
    using RangeConversor::RangeConversor;
    bool parse_scan(const RawLine& line, Readings& out) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    void parse_parameter(Fields fields);
    CarmenMessage parse_flaser(Fields fields, Readings* out);
    CarmenMessage parse_laser(Fields fields, bool with_pose, Readings* out);
    Pose steady_mount(const Pose& mount);

    double stated_max_m_ = 0.0;
    double resolution_deg_ = 0.0;
    Pose pose_robot_laser_;           // from parameters
    std::optional<Pose> last_mount_;  // from ROBOTLASER1 lines
    std::string scan_message_;        // the one in use: the first that gave a scan
};

bool ConversorCarmen::parse_scan(const RawLine& line, Readings& out) {
    Fields fields(line);
    const std::string_view name = fields.word(HITOS_TEXT("Errors", "message name"));
    if (name == "PARAM") {
        parse_parameter(fields);
        return false;
    }
    const bool flaser = name == "FLASER";
    const CarmenMessage message =
        flaser ? parse_flaser(fields, &out) : parse_laser(fields, name == "ROBOTLASER1", &out);
    out.time_s = message.time_s;
    out.carries_odometry = message.pose_odom_robot.has_value();
    // Raw and robot lasers are one scan logged twice, where both are logged.
    if (scan_message_.empty()) scan_message_ = name;
    return scan_message_ == name;
}

void ConversorCarmen::parse_parameter(Fields fields) {
    const std::string_view name = fields.word(HITOS_TEXT("Errors", "parameter name"));
    const double value = fields.number(HITOS_TEXT("Errors", "parameter value"));
    if (name == "robot_front_laser_max") stated_max_m_ = value;
    if (name == "laser_front_laser_resolution") resolution_deg_ = value;
    if (name == "robot_frontlaser_offset") pose_robot_laser_.x = value;
    if (name == "robot_frontlaser_side_offset") pose_robot_laser_.y = value;
    if (name == "robot_frontlaser_angular_offset") pose_robot_laser_.theta = wrap_angle(value);
}

CarmenMessage ConversorCarmen::parse_flaser(Fields fields, Readings* out) {
    const std::uint32_t count = fields.count("num_readings");
    take_ranges(fields, count, out);
    CarmenMessage message;
    take_pose(fields, "x", "y", "theta");
    message.pose_odom_robot = take_pose(fields, "odom_x", "odom_y", "odom_theta");
    message.time_s = take_tail(fields);
    if (out != nullptr) {
        out->fan = implied_fan(count, resolution_deg_);
        out->fan.max_range_m = stated_max_m_;
        out->fan.pose_robot_laser = pose_robot_laser_;
    }
    return message;
}

CarmenMessage ConversorCarmen::parse_laser(Fields fields, bool with_pose, Readings* out) {
    fields.number("laser_type");
    const double start_rad = fields.number("start_angle");
    const double view_rad = fields.number("field_of_view");
    const double resolution_rad = fields.number("angular_resolution");
    const double max_range_m = fields.number("maximum_range");
    fields.number("accuracy");
    fields.number("remission_mode");
    const std::uint32_t count = fields.count("num_readings");
    take_ranges(fields, count, out);

    const bool has_block = skip_remissions(fields, with_pose);
    CarmenMessage message;
    Pose mount = pose_robot_laser_;
    if (with_pose) {
        const Pose laser = take_pose(fields, "laser_x", "laser_y", "laser_theta");
        const Pose robot = take_pose(fields, "robot_x", "robot_y", "robot_theta");
        Twist velocity;
        velocity.v = fields.number("tv");
        velocity.w = fields.number("rv");
        fields.number("forward_safety_dist");
        fields.number("side_safety_dist");
        // Before remission there was no turn axis either in some versions: then time and host
        // follow.
        Fields ahead = fields;
        ahead.take();
        if (has_block || parse_double(ahead.peek())) fields.number("turn_axis");
        message.pose_odom_robot = robot;
        message.velocity = velocity;
        mount = steady_mount(between(robot, laser));
    }
    message.time_s = take_tail(fields);
    if (out != nullptr) {
        out->fan = stated_fan(start_rad, view_rad, resolution_rad, count);
        out->fan.max_range_m = max_range_m;
        out->fan.pose_robot_laser = mount;
    }
    return message;
}

/// The laser is bolted to the robot: poses rounded to six decimals do not move it.
Pose ConversorCarmen::steady_mount(const Pose& mount) {
    constexpr double kRounding = 1e-4;
    if (last_mount_ && std::abs(last_mount_->x - mount.x) < kRounding &&
        std::abs(last_mount_->y - mount.y) < kRounding &&
        std::abs(wrap_angle(last_mount_->theta - mount.theta)) < kRounding) {
        return *last_mount_;
    }
    last_mount_ = mount;
    return mount;
}

std::optional<OdometryRecord> ConversorCarmen::odometry(const RawLine& line) {
    Fields fields(line);
    const std::string_view name = fields.word(HITOS_TEXT("Errors", "message name"));
    CarmenMessage message;
    if (name == "ODOM") {
        message.pose_odom_robot = take_pose(fields, "x", "y", "theta");
        Twist velocity;
        velocity.v = fields.number("tv");
        velocity.w = fields.number("rv");
        fields.number("accel");
        message.velocity = velocity;
        message.time_s = take_tail(fields);
    } else {
        // The whole line is checked, so that a damaged one is out of both sequences.
        message =
            name == "FLASER" ? parse_flaser(fields, nullptr) : parse_laser(fields, true, nullptr);
    }
    OdometryRecord record;
    record.time_s = message.time_s;
    record.pose_odom_robot = message.pose_odom_robot;
    record.velocity = message.velocity;
    record.line = line.number;
    return record;
}

class LogWriterCarmen final : public TourWriter {
  public:
    explicit LogWriterCarmen(const std::filesystem::path& path)
        : TourWriter(path), fitter_(path.string()) {}

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
};

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
        fitter_.fail(scan, message(HITOS_TEXT("Errors",
                                              "its rays are none that FLASER says, as which the "
                                              "scans before it are written")));
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
    if (*flaser_) {
        put_parameters(out, scan.fan, time_s);
        out += scan.text;
        append_pose(out, pose_odom_robot);
        append_pose(out, pose_odom_robot);
    } else {
        out += scan.text;
        out += " 0";
        append_pose(out, compose(pose_odom_robot, scan.fan.pose_robot_laser));
        append_pose(out, pose_odom_robot);
        append_all(out, {twist_.v, twist_.w, 0.0, 0.0, 0.0}, 6);
    }
    append_tail(out, time_s);
}

void LogWriterCarmen::put_odometry(std::string& out, const Odometria& odometry,
                                   const Pose& pose_odom_robot) {
    twist_ = odometry.twist;
    out += "ODOM";
    append_pose(out, pose_odom_robot);
    append_all(out, {odometry.twist.v, odometry.twist.w, 0.0}, 6);
    append_tail(out, odometry.time_s);
}

}  // namespace

LogFormat carmen_format() {
    return {{"carmen", HITOS_TEXT("ParameterChoice", "CARMEN"),
             "logs of CARMEN, in which most public tours come"},
            "*.log *.clf *.gfs",
            claims,
            classify,
            make_range_conversor<ConversorCarmen>,
            make_writer<LogWriterCarmen>};
}

}  // namespace hitos
