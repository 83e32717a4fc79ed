// SPDX-License-Identifier: GPL-3.0-or-later
// CARMEN logs: ODOM, FLASER, ROBOTLASER1, RAWLASER1 and the parameters that describe the laser.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "formats/carmen_clocks.hpp"
#include "formats/carmen_writer.hpp"
#include "formats/formats.hpp"
#include "hitos/base/translatable.hpp"
#include "range_conversor.hpp"

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

bool claims_carmen(std::string_view text) {
    if (text.starts_with("# CARMEN Logfile")) return true;
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "ODOM") return fields.remaining() >= 8 && parse_double(fields.take());
    if (name == "PARAM") return fields.remaining() >= 2;
    constexpr std::array<std::string_view, 3> kStems = {"RAWLASER", "ROBOTLASER", "TRUEPOS"};
    return name == "FLASER" || name == "RLASER" ||
           std::ranges::any_of(kStems, [name](auto stem) { return name.starts_with(stem); });
}

LineKind classify_carmen(std::string_view text) {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "ODOM") return LineKind::odometry;
    if (is_scan(name)) return name == "RAWLASER1" ? LineKind::scan : LineKind::both;
    if (name == "PARAM") return is_parameter(fields.take()) ? LineKind::scan : LineKind::other;
    return other_or_damaged(text);
}

Pose take_pose(Fields& fields, const char* x, const char* y, const char* theta) {
    Pose pose;
    pose.x = fields.number(x);
    pose.y = fields.number(y);
    pose.theta = fields.number(theta);
    return pose;
}

/// `time host logger_time`; some programs leave the last one out. With `from_logger_s` that one
/// counts, as far as it is there.
double take_tail(Fields& fields, const std::optional<double>& from_logger_s) {
    double time_s = fields.number("time");
    fields.word("host");
    if (!fields.at_end()) {
        const double logged_s = fields.number("logger_time");
        if (from_logger_s) time_s = logged_s + *from_logger_s;
    }
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
    fan.min_angle_rad = start_deg * kRadiansPerDegree;
    fan.max_angle_rad = (start_deg + steps * step_deg) * kRadiansPerDegree;
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
    Fan fan;  ///< of a scan
};

class ConversorCarmen final : public RangeConversor {
  public:
    using RangeConversor::RangeConversor;
    bool parse_scan(const RawLine& line, Readings& out) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;
    void follow(const CarmenClocks& clocks, Mend mend);

  private:
    void parse_parameter(Fields fields);
    CarmenMessage parse_flaser(Fields fields, Readings* out);
    CarmenMessage parse_laser(Fields fields, bool with_pose, Readings* out);
    Pose steady_mount(const Pose& mount);
    bool in_use(std::string_view name);

    double stated_max_m_ = 0.0;
    double resolution_deg_ = 0.0;
    Pose pose_robot_laser_;           // from parameters
    bool mounting_stated_ = false;    // by one
    std::optional<Pose> last_mount_;  // from ROBOTLASER1 lines
    std::string scan_message_;        // the one in use: the first that gave a scan
    int of_others_ = 0;               // scans since it gave the last one
    std::optional<double> from_logger_s_;
    bool odometry_of_scans_ = true;  // or of ODOM lines alone
};

/// Scans that are stamped by another clock have poses that go to and fro in time among those of
/// ODOM; and CARMEN, which looked them up by that stamp, took them of another moment.
void ConversorCarmen::follow(const CarmenClocks& clocks, Mend mend) {
    odometry_of_scans_ = !clocks.scans_late_s && !clocks.to_and_fro;
    if (mend == Mend::all) from_logger_s_ = clocks.from_logger_s;
}

bool ConversorCarmen::parse_scan(const RawLine& line, Readings& out) {
    Fields fields(line);
    const std::string_view name = fields.word(HITOS_TEXT("Errors", "message name"));
    if (name == "PARAM") {
        parse_parameter(fields);
        return false;
    }
    const bool of_robot = name == "ROBOTLASER1";
    const CarmenMessage message =
        name == "FLASER" ? parse_flaser(fields, &out) : parse_laser(fields, of_robot, &out);
    out.time_s = message.time_s;
    out.fan = message.fan;
    out.carries_odometry = odometry_of_scans_ && message.pose_odom_robot.has_value();
    if (!in_use(name)) return false;
    if (!of_robot) out.fan.pose_robot_laser = pose_robot_laser_;
    return true;
}

/// Raw and robot lasers are one scan logged twice, where both are logged; where the one in use is
/// logged no more, as in logs of two versions that somebody has joined, the other goes on. Which
/// that is lines tell and not stamps, of which one may be wrong, or of another clock.
bool ConversorCarmen::in_use(std::string_view name) {
    constexpr int kGone = 5;
    if (scan_message_.empty()) scan_message_ = name;
    if (scan_message_ != name) {
        if (++of_others_ < kGone) return false;
        if (!mounting_stated_ && last_mount_) pose_robot_laser_ = *last_mount_;
        scan_message_ = name;
    }
    of_others_ = 0;
    return true;
}

void ConversorCarmen::parse_parameter(Fields fields) {
    const std::string_view name = fields.word(HITOS_TEXT("Errors", "parameter name"));
    const double value = fields.number(HITOS_TEXT("Errors", "parameter value"));
    if (name == "robot_front_laser_max") stated_max_m_ = value;
    if (name == "laser_front_laser_resolution") resolution_deg_ = value;
    if (name == "robot_frontlaser_offset") pose_robot_laser_.x = value;
    if (name == "robot_frontlaser_side_offset") pose_robot_laser_.y = value;
    if (name == "robot_frontlaser_angular_offset") pose_robot_laser_.theta = wrap_angle(value);
    mounting_stated_ = mounting_stated_ || name.starts_with("robot_frontlaser_");
}

CarmenMessage ConversorCarmen::parse_flaser(Fields fields, Readings* out) {
    const std::uint32_t count = fields.count("num_readings");
    take_ranges(fields, count, out);
    CarmenMessage message;
    take_pose(fields, "x", "y", "theta");
    message.pose_odom_robot = take_pose(fields, "odom_x", "odom_y", "odom_theta");
    message.time_s = take_tail(fields, from_logger_s_);
    message.fan = implied_fan(count, resolution_deg_);
    message.fan.max_range_m = stated_max_m_;
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
    Pose mount;
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
    message.time_s = take_tail(fields, from_logger_s_);
    message.fan = stated_fan(start_rad, view_rad, resolution_rad, count);
    message.fan.max_range_m = max_range_m;
    message.fan.pose_robot_laser = mount;
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
        message.time_s = take_tail(fields, from_logger_s_);
    } else {
        // The whole line is checked, so that a damaged one is out of both sequences.
        message =
            name == "FLASER" ? parse_flaser(fields, nullptr) : parse_laser(fields, true, nullptr);
        refuse_turns(message.fan);
        if (!odometry_of_scans_) return std::nullopt;
    }
    OdometryRecord record;
    record.time_s = message.time_s;
    record.pose_odom_robot = message.pose_odom_robot;
    record.velocity = message.velocity;
    record.line = line.number;
    return record;
}

std::unique_ptr<Conversor> make_carmen_conversor(const Fuente& fuente, const ReadOptions& options) {
    auto conversor = std::make_unique<ConversorCarmen>(options);
    look_for_no_return(fuente, options, *conversor);
    conversor->follow(carmen_clocks(fuente), options.mend);
    return conversor;
}

std::vector<TourFinding> doubts_of_carmen(const Fuente& fuente, const ReadOptions& options) {
    std::vector<TourFinding> found = range_doubts<ConversorCarmen>(fuente, options);
    std::ranges::move(carmen_doubts(fuente, options), std::back_inserter(found));
    return found;
}

}  // namespace

LogFormat carmen_format() {
    LogFormat format = {{"carmen", HITOS_TEXT("ParameterChoice", "CARMEN"),
                         "logs of CARMEN, in which most public tours come"},
                        "*.log *.clf *.gfs",
                        claims_carmen,
                        classify_carmen,
                        make_carmen_conversor,
                        make_carmen_writer};
    format.of_robots = true;
    format.doubts = doubts_of_carmen;
    return format;
}

}  // namespace hitos
