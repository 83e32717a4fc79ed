// Player/Stage writelog [T A.1], in the variants of Player 1.5 to 3.1.
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "formats.hpp"
#include "range_conversor.hpp"

namespace hitos {
namespace {

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
        Fields(line).fail(
            "found no header of a Player line, expected time host robot interface "
            "index type subtype");
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
    LaserSetup& setup = setups_[device];
    if (header.is(4, 1) || header.is(4, 5)) {
        parse_metadata(fields, header, setup);
        return false;
    }
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
        fields.expect_end("the frequency");
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
        fields.expect_end("the width");
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
        states_range = !count || std::cmp_not_equal(ahead.remaining(), *count * 2);
    }
    if (states_range) out.fan.max_range_m = fields.number("max_range");
    out.fan.count = fields.count("count");
    for (std::uint32_t i = 0; i < out.fan.count; ++i) {
        out.ranges_m.push_back(fields.reading("range"));
        fields.reading("intensity");
    }
    fields.expect_end("the readings that the count announces");
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
    fields.expect_end("the readings that the count announces");
    const Pose mount = out.fan.pose_robot_laser;
    out.fan = fan_of_bearings(out.bearings_rad);
    out.fan.pose_robot_laser = mount;
    out.fan.max_range_m = max_range;
}

void ConversorPlayer::parse_ranger(Fields fields, const LaserSetup& setup, Readings& out) {
    if (!setup.fan) {
        fields.fail(
            "found the ranges of a ranger whose angles are unknown, expected a line of "
            "type 4, subtype 5 before it");
    }
    out.fan = *setup.fan;
    out.fan.pose_robot_laser = setup.pose_robot_laser;
    out.fan.count = fields.count("count");
    for (std::uint32_t i = 0; i < out.fan.count; ++i) {
        out.ranges_m.push_back(fields.reading("range"));
    }
    fields.expect_end("the ranges that the count announces");
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

}  // namespace

std::unique_ptr<RangeConversor> make_conversor_player(const ReadOptions& options) {
    return std::make_unique<ConversorPlayer>(options);
}

}  // namespace hitos
