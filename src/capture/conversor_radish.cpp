// The text format of [T A.2].
#include "range_conversor.hpp"

namespace hitos {
namespace {

class ConversorRadish final : public RangeConversor {
  public:
    using RangeConversor::RangeConversor;
    bool parse_scan(const RawLine& line, Readings& out) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    std::optional<std::int64_t> laser_;     // index of the device in use: the first that is sound
    std::optional<std::int64_t> position_;  // likewise
};

bool ConversorRadish::parse_scan(const RawLine& line, Readings& out) {
    Fields fields(line);
    fields.word("laser");
    const std::int64_t index = fields.integer("index");
    out.time_s = fields.number("time");
    if (fields.at_end()) fields.fail("readings: found none, expected range bearing intensity");
    while (!fields.at_end()) {
        out.ranges_m.push_back(fields.reading("range"));
        out.bearings_rad.push_back(fields.number("bearing"));
        fields.reading("intensity");
    }
    if (laser_ && *laser_ != index) return false;
    laser_ = index;
    out.fan = fan_of_bearings(out.bearings_rad);
    return true;
}

std::optional<OdometryRecord> ConversorRadish::odometry(const RawLine& line) {
    Fields fields(line);
    fields.word("position");
    const std::int64_t index = fields.integer("index");
    OdometryRecord record;
    record.line = line.number;
    record.time_s = fields.number("time");
    Pose pose;
    pose.x = fields.number("px");
    pose.y = fields.number("py");
    pose.theta = fields.number("pa");
    Twist velocity;
    velocity.v = fields.number("vx");
    velocity.v_lateral = fields.number("vy");
    velocity.w = fields.number("va");
    fields.expect_end("va");
    if (position_ && *position_ != index) return std::nullopt;
    position_ = index;
    record.pose_odom_robot = pose;
    record.velocity = velocity;
    return record;
}

}  // namespace

std::unique_ptr<RangeConversor> make_conversor_radish(const ReadOptions& options) {
    return std::make_unique<ConversorRadish>(options);
}

}  // namespace hitos
