// SPDX-License-Identifier: GPL-3.0-or-later
// Player/Stage writelog [T A.1], in the variants of Player 1.5 to 3.1. Written with more decimals
// than Player prints.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "fan_fit.hpp"
#include "formats/formats.hpp"
#include "hitos/base/translatable.hpp"
#include "range_conversor.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

/// The part of a Player line before the payload. Files of Player 1.5 and 1.6 have no type and
/// subtype; their sixth field is the data's own time, with a point in it.
struct PlayerHeader {
    std::string_view time;
    std::string_view interface;
    std::string_view index;
    std::string_view type;     ///< empty in the old layout
    std::string_view subtype;  ///< empty in the old layout
    std::string_view payload;

    bool old_layout() const { return type.empty(); }
    /// Whether type and subtype are these numbers, however they are padded.
    bool is(std::int64_t wanted_type, std::int64_t wanted_subtype) const {
        return parse_integer(type) == wanted_type && parse_integer(subtype) == wanted_subtype;
    }
};

/// Nothing where the line does not begin as a Player line must.
std::optional<PlayerHeader> split_player_header(std::string_view text) {
    Fields fields(text);
    PlayerHeader header;
    header.time = fields.take();
    fields.take();  // host: a number or a name
    fields.take();  // robot: the port
    header.interface = fields.take();
    header.index = fields.take();
    const std::string_view sixth = fields.take();
    if (header.time.empty() || begins_with_letter(header.time) || sixth.empty()) {
        return std::nullopt;
    }
    if (!begins_with_letter(header.interface) || !parse_integer(header.index)) return std::nullopt;
    if (sixth.find('.') == std::string_view::npos) {
        header.type = sixth;
        header.subtype = fields.take();
        if (header.subtype.empty()) return std::nullopt;
    }
    header.payload = fields.rest();
    return header;
}

bool claims_player(std::string_view text) {
    return text.starts_with("## Player version") || split_player_header(text).has_value();
}

LineKind classify_player(std::string_view text) {
    const std::optional<PlayerHeader> header = split_player_header(text);
    if (!header) return LineKind::damaged;
    const bool laser = header->interface == "laser";
    const bool ranger = header->interface == "ranger";
    const bool position = header->interface == "position2d" || header->interface == "position";
    if (!laser && !ranger && !position) return LineKind::other;
    const LineKind kind = position ? LineKind::odometry : LineKind::scan;
    if (header->old_layout()) return kind;
    // Digits that are none must reach the converter, which says what is wrong with them.
    if (!parse_integer(header->type) || !parse_integer(header->subtype)) return kind;
    const bool data = header->is(1, 1);
    if (position) return data ? kind : LineKind::other;
    // writelog leaves the payload out of messages that it does not know.
    if (header->payload.empty() && !data) return LineKind::other;
    const bool geometry = header->is(4, 1);
    const bool needed = laser ? header->is(1, 2) || header->is(1, 3) : header->is(4, 5);
    return data || geometry || needed ? kind : LineKind::other;
}

/// Interface and index: what tells two devices of one log apart.
struct Device {
    std::string interface;
    std::int64_t index = 0;
    friend bool operator==(const Device&, const Device&) = default;
    friend bool operator<(const Device& a, const Device& b) {
        return std::tie(a.interface, a.index) < std::tie(b.interface, b.index);
    }
};

/// What the lines of metadata say about one laser.
struct LaserSetup {
    Pose pose_robot_laser;
    std::optional<Fan> fan;  ///< rangers state it in a line of its own
};

bool is_integer_text(std::string_view field) {
    return field.find_first_not_of("0123456789") == std::string_view::npos;
}

class ConversorPlayer final : public RangeConversor {
  public:
    using RangeConversor::RangeConversor;
    bool parse_scan(const RawLine& line, Readings& out) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    void parse_metadata(Fields fields, const PlayerHeader& header, LaserSetup& setup);
    static void parse_laser(Fields fields, const PlayerHeader& header, Readings& out);
    static void parse_scan_angle(Fields fields, Readings& out);
    static void parse_ranger(Fields fields, const LaserSetup& setup, Readings& out);

    std::map<Device, LaserSetup> setups_;
    std::optional<Device> laser_;     // the one in use: the first that gave a scan
    std::optional<Device> position_;  // likewise for odometry
};

/// The header, its time checked; throws where it is none.
std::pair<PlayerHeader, double> header_of(const RawLine& line) {
    const std::optional<PlayerHeader> header = split_player_header(line.text);
    if (!header) {
        Fields(line).fail(message(HITOS_TEXT("Errors",
                                             "found no header of a Player line, expected time host "
                                             "robot interface index type subtype")));
    }
    Fields time(header->time, line.number);
    const double time_s = time.number("time");
    if (!header->old_layout()) {
        Fields(header->type, line.number).integer("type");
        Fields(header->subtype, line.number).integer("subtype");
    }
    return {*header, time_s};
}

Device device_of(const PlayerHeader& header) {
    return {std::string(header.interface), parse_integer(header.index).value_or(0)};
}

bool ConversorPlayer::parse_scan(const RawLine& line, Readings& out) {
    const auto [header, time_s] = header_of(line);
    Device device = device_of(header);
    if (laser_ && *laser_ != device) return false;
    Fields fields(header.payload, line.number);
    if (header.is(4, 1) || header.is(4, 5)) {
        constexpr std::size_t kMostLasers = 256;  // a damaged index must not fill the memory
        if (setups_.size() >= kMostLasers && !setups_.contains(device)) {
            fields.fail(message(HITOS_TEXT("Errors", "found more than %1 lasers"), kMostLasers));
        }
        parse_metadata(fields, header, setups_[device]);
        return false;
    }
    const auto known = setups_.find(device);
    const LaserSetup setup = known != setups_.end() ? known->second : LaserSetup{};
    out.time_s = time_s;
    out.fan.pose_robot_laser = setup.pose_robot_laser;
    if (device.interface == "ranger") {
        parse_ranger(fields, setup, out);
    } else if (header.is(1, 3)) {
        parse_scan_angle(fields, out);
    } else {
        parse_laser(fields, header, out);
    }
    out.max_is_exact = out.fan.max_range_m > 0.0;
    laser_ = std::move(device);
    return true;
}

void ConversorPlayer::parse_metadata(Fields fields, const PlayerHeader& header, LaserSetup& setup) {
    if (header.is(4, 5)) {
        Fan fan;
        fan.min_angle_rad = fields.number("min_angle");
        fan.max_angle_rad = fields.number("max_angle");
        fields.number("resolution");  // known to be wrong; the angles follow from the count
        fields.number("min_range");
        fan.max_range_m = fields.number("max_range");
        fields.number("range_resolution");
        fields.number("frequency");
        fields.expect_end(HITOS_TEXT("Errors", "the frequency"));
        setup.fan = fan;
        return;
    }
    Pose pose;
    pose.x = fields.number("px");
    pose.y = fields.number("py");
    if (header.interface == "ranger") {
        fields.number("pz");
        fields.number("proll");
        fields.number("ppitch");
        pose.theta = wrap_angle(fields.number("pyaw"));
        // Size and the single elements follow; nothing of them is needed.
    } else {
        pose.theta = wrap_angle(fields.number("pyaw"));
        fields.number("length");
        fields.number("width");
        fields.expect_end(HITOS_TEXT("Errors", "the width"));
    }
    setup.pose_robot_laser = pose;
}

/// 1:1 and 1:2. The identifier came with Player 2, the greatest range a little later; neither
/// stands in files of Player 1. An identifier has no point, the least angle has one; a count has
/// none, and agrees with what is left of the line.
void ConversorPlayer::parse_laser(Fields fields, const PlayerHeader& header, Readings& out) {
    const bool with_pose = header.is(1, 2);
    if (with_pose || is_integer_text(fields.peek())) fields.integer("scan_id");
    if (with_pose) {
        for (const char* name : {"px", "py", "pa"}) fields.number(name);  // of the robot, not used
    }
    out.fan.min_angle_rad = fields.number("min_angle");
    out.fan.max_angle_rad = fields.number("max_angle");
    fields.number("resolution");  // known to be wrong; the angles follow from the count
    bool states_range = true;
    if (is_integer_text(fields.peek())) {
        Fields ahead = fields;
        const std::optional<std::int64_t> count = parse_integer(ahead.take());
        const std::size_t left = ahead.remaining();  // a count may be any number
        states_range = !count || left % 2 != 0 || std::cmp_not_equal(left / 2, *count);
    }
    if (states_range) out.fan.max_range_m = fields.number("max_range");
    out.fan.count = fields.count("count");
    fields.readings(out.fan.count, std::array{"range", "intensity"},
                    [&out](std::size_t name, double value) {
                        if (name == 0) out.ranges_m.push_back(value);
                    });
    fields.expect_end(HITOS_TEXT("Errors", "the readings that the count announces"));
}

/// 1:3: each reading has its own angle.
void ConversorPlayer::parse_scan_angle(Fields fields, Readings& out) {
    fields.integer("scan_id");
    const double max_range = fields.number("max_range");
    const std::uint32_t count = fields.count("count");
    for (std::uint32_t i = 0; i < count; ++i) {
        out.ranges_m.push_back(fields.reading("range"));
        out.bearings_rad.push_back(fields.number("angle"));
        fields.reading("intensity");
    }
    fields.expect_end(HITOS_TEXT("Errors", "the readings that the count announces"));
    const Pose mount = out.fan.pose_robot_laser;
    out.fan = fan_of_bearings(out.bearings_rad);
    out.fan.pose_robot_laser = mount;
    out.fan.max_range_m = max_range;
}

void ConversorPlayer::parse_ranger(Fields fields, const LaserSetup& setup, Readings& out) {
    if (!setup.fan) {
        fields.fail(message(HITOS_TEXT("Errors",
                                       "found the ranges of a ranger whose angles are unknown, "
                                       "expected a line of type 4, subtype 5 before it")));
    }
    out.fan = *setup.fan;
    out.fan.pose_robot_laser = setup.pose_robot_laser;
    out.fan.count = fields.count("count");
    fields.readings(out.fan.count, std::array{"range"},
                    [&out](std::size_t, double value) { out.ranges_m.push_back(value); });
    fields.expect_end(HITOS_TEXT("Errors", "the ranges that the count announces"));
}

std::optional<OdometryRecord> ConversorPlayer::odometry(const RawLine& line) {
    const auto [header, time_s] = header_of(line);
    Device device = device_of(header);
    if (position_ && *position_ != device) return std::nullopt;
    Fields fields(header.payload, line.number);
    OdometryRecord record;
    record.time_s = time_s;
    record.line = line.number;
    Pose pose;
    pose.x = fields.number("px");
    pose.y = fields.number("py");
    pose.theta = fields.number("pa");
    Twist velocity;
    velocity.v = fields.number("vx");
    velocity.v_lateral = fields.number("vy");
    velocity.w = fields.number("va");
    fields.integer("stall");
    fields.expect_end("stall");
    record.pose_odom_robot = pose;
    record.velocity = velocity;
    position_ = std::move(device);
    return record;
}

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
    out += " 0000";
    append_all(out, {sweep.fan.min_angle_rad, sweep.fan.max_angle_rad, sweep.fan.step_rad()},
               kAngle);
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

LogFormat player_format() {
    LogFormat format = {
        {"player", HITOS_TEXT("ParameterChoice", "Player"), "logs of Player and Stage"},
        "*.log",
        claims_player,
        classify_player,
        make_range_conversor<ConversorPlayer>,
        make_writer<LogWriterPlayer>};
    format.doubts = range_doubts<ConversorPlayer>;
    return format;
}

}  // namespace hitos
