// SPDX-License-Identifier: GPL-3.0-or-later
// The text format of [T A.2]. It has no place for the laser's mounting: ranges and bearings are
// written as seen from the robot.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "fan_fit.hpp"
#include "formats/formats.hpp"
#include "hitos/base/translatable.hpp"
#include "range_conversor.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

/// A word, the device's index, a time, and numbers.
bool claims_radish(std::string_view text) {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name != "position" && name != "laser") return false;
    return parse_integer(fields.take()) && parse_double(fields.take()) &&
           parse_double(fields.take());
}

LineKind classify_radish(std::string_view text) {
    const std::string_view name = Fields(text).peek();
    if (name == "laser") return LineKind::scan;
    if (name == "position") return LineKind::odometry;
    return other_or_damaged(text);
}

class ConversorRadish final : public RangeConversor {
  public:
    using RangeConversor::RangeConversor;
    bool parse_scan(const RawLine& line, Readings& out) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    void refuse_other_columns(const Fields& fields, const Readings& readings) const;

    std::vector<double> numbers_;           // of the line, as they stand
    std::optional<std::int64_t> laser_;     // index of the device in use: the first that is sound
    std::optional<std::int64_t> position_;  // likewise
};

/// Whether the numbers go one way and never back, as no ranges do.
bool sweeps(const std::vector<double>& numbers, std::size_t first, std::size_t stride) {
    const bool upwards = numbers[first + stride] > numbers[first];
    for (std::size_t i = first + stride; i < numbers.size(); i += stride) {
        const double step = numbers[i] - numbers[i - stride];
        if (!(upwards ? step > 0.0 : step < 0.0)) return false;
    }
    return true;
}

/// Three numbers a reading may also be two, of which three happen to be as many, or stand in
/// another order: then others than the bearings sweep.
void ConversorRadish::refuse_other_columns(const Fields& fields, const Readings& readings) const {
    constexpr std::size_t kFewReadings = 8;  // may go one way by chance
    if (readings.ranges_m.size() < kFewReadings || sweeps(readings.bearings_rad, 0, 1)) return;
    const char* found = nullptr;
    if (numbers_.size() % 2 == 0 && (sweeps(numbers_, 1, 2) || sweeps(numbers_, 0, 2))) {
        found = HITOS_TEXT("Errors", "two numbers for each, without an intensity");
    } else if (sweeps(readings.ranges_m, 0, 1)) {
        found = HITOS_TEXT("Errors", "the bearings in the place of the ranges");
    }
    if (found == nullptr) return;
    fields.fail(message(
        HITOS_TEXT("Errors", "readings: found %1, expected range bearing intensity for each"),
        marked(found)));
}

bool ConversorRadish::parse_scan(const RawLine& line, Readings& out) {
    Fields fields(line);
    fields.word("laser");
    const std::int64_t index = fields.integer("index");
    out.time_s = fields.number("time");
    if (fields.at_end()) {
        fields.fail(message(
            HITOS_TEXT("Errors", "readings: found none, expected range bearing intensity")));
    }
    numbers_.clear();
    while (!fields.at_end()) {
        out.ranges_m.push_back(fields.reading("range"));
        out.bearings_rad.push_back(fields.number("bearing"));
        numbers_.push_back(out.ranges_m.back());
        numbers_.push_back(out.bearings_rad.back());
        numbers_.push_back(fields.reading("intensity"));
    }
    refuse_other_columns(fields, out);
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
    std::size_t next = 0;
    for (std::uint32_t ray = 0; ray < scan.fan.count; ++ray) {
        if (next < scan.rays.size() && scan.rays[next] == ray) {
            const Point2& point = scan.points[next++];
            append_reading(out, std::max(1e-4, std::hypot(point.x, point.y)),
                           std::atan2(point.y, point.x));
        } else {
            append_no_return(out,
                             wrap_angle(scan.fan.pose_robot_laser.theta + scan.fan.min_angle_rad +
                                        ray * scan.fan.step_rad()),
                             scan.fan.max_range_m);
        }
    }
}

/// The points alone, with one reading without return between two runs.
void append_readings(std::string& out, const Scan& scan) {
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
        append_readings(prepared.text, scan);
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

LogFormat radish_format() {
    LogFormat format = {{"radish", HITOS_TEXT("ParameterChoice", "Radish"),
                         "the text format of the thesis for Radish tours"},
                        "*.log *.txt",
                        claims_radish,
                        classify_radish,
                        make_range_conversor<ConversorRadish>,
                        make_writer<LogWriterRadish>};
    format.of_robots = true;
    format.doubts = range_doubts<ConversorRadish>;
    return format;
}

}  // namespace hitos
