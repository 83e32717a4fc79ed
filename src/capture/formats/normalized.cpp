// SPDX-License-Identifier: GPL-3.0-or-later
// The normalised format of [T A.3]: points and velocities, nothing to convert; besides, landmarks
// that a sensor tells by themselves. Written with digits that read back as the same bits.
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "formats/formats.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/archivo.hpp"
#include "laser_pose.hpp"
#include "range_conversor.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

/// Shares ODOM with CARMEN, whose line has nine fields after the name.
bool claims_normalized(std::string_view text) {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "LASER" || name == "LANDMARKS")
        return parse_double(fields.take()) && parse_integer(fields.take());
    if (name != "ODOM") return false;
    const std::size_t count = fields.remaining();
    return (count == 3 || count == 4) && parse_double(fields.take());
}

LineKind classify_normalized(std::string_view text) {
    const std::string_view name = Fields(text).peek();
    if (name == "LASER" || name == "LANDMARKS") return LineKind::scan;
    if (name == "ODOM") return LineKind::odometry;
    return other_or_damaged(text);
}

/// Where the laser sat is not known any more. A place that is given is where the points' origin is.
class ConversorNormalized final : public Conversor {
  public:
    explicit ConversorNormalized(ReadOptions options)
        : options_(std::move(options)), laser_pose_(laser_pose_of(options_.laser_pose)) {}
    std::optional<Scan> scan(const RawLine& line) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    void read_points(Fields& fields, Scan& scan) const;
    void read_landmarks(Fields& fields, Scan& scan) const;
    /// Whether a reading is one of nothing: at the end of the range, or beyond.
    bool too_far(double range_m) const {
        return options_.max_range_m > 0.0 && range_m >= options_.max_range_m;
    }

    ReadOptions options_;
    std::optional<LaserPose> laser_pose_;  // of the options
};

std::optional<Scan> ConversorNormalized::scan(const RawLine& line) {
    Fields fields(line);
    const bool landmarks = fields.word("LASER") == "LANDMARKS";
    Scan scan;
    scan.line = line.number;
    scan.time_s = fields.number("time");
    if (laser_pose_) {
        scan.fan.pose_robot_laser = laser_pose_->pose_robot_laser;
        scan.fan.upside_down = laser_pose_->upside_down;
    }
    if (landmarks) {
        read_landmarks(fields, scan);
    } else {
        read_points(fields, scan);
    }
    return scan;
}

void ConversorNormalized::read_points(Fields& fields, Scan& scan) const {
    // A scan that hit nothing is one too.
    const std::uint32_t count = fields.count("n", 0);
    bool run_open = false;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = options_.range_scale * fields.reading("x");
        const double y = options_.range_scale * fields.reading("y");
        const bool none = (x == 0.0 && y == 0.0) || !std::isfinite(x) || !std::isfinite(y);
        if (none || too_far(std::hypot(x, y))) {
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        scan.points.push_back(laser_pose_ ? laser_pose_->mounted(Point2{x, y}) : Point2{x, y});
    }
    fields.expect_end(HITOS_TEXT("Errors", "the points that n announces"));
}

void ConversorNormalized::read_landmarks(Fields& fields, Scan& scan) const {
    const std::uint32_t count = fields.count("n", 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string_view identity = fields.peek();
        LandmarkSighting seen;
        const std::int64_t named = fields.integer("identity");
        if (named < LandmarkSighting::kNameless ||
            named > std::numeric_limits<std::int32_t>::max()) {
            fields.fail("identity", identity,
                        HITOS_TEXT("Errors", "a whole number from 0, or -1 where it is unknown"));
        }
        seen.identity = static_cast<std::int32_t>(named);
        const std::string_view range = fields.peek();
        seen.range_m = options_.range_scale * fields.number("range");
        if (seen.range_m < 0.0) fields.fail("range", range, HITOS_TEXT("Errors", "no less than 0"));
        seen.bearing_rad = fields.number("bearing");
        if (seen.range_m < options_.min_range_m || too_far(seen.range_m)) continue;
        scan.landmarks.push_back(laser_pose_ ? laser_pose_->mounted(seen) : seen);
    }
    fields.expect_end(HITOS_TEXT("Errors", "the landmarks that n announces"));
}

std::optional<OdometryRecord> ConversorNormalized::odometry(const RawLine& line) {
    Fields fields(line);
    fields.word("ODOM");
    OdometryRecord record = read_velocities(fields, line);
    if (!fields.at_end()) record.velocity->v_lateral = fields.number("VL");
    fields.expect_end(HITOS_TEXT("Errors", "the velocities"));
    return record;
}

/// Behind the time: "n x y …"; runs of neighbours are parted by "0 0".
void append_points(std::string& out, const Scan& scan) {
    const std::size_t breaks = scan.run_starts.empty() ? 0 : scan.run_starts.size() - 1;
    append_count(out, scan.points.size() + breaks);
    std::size_t run = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (run < scan.run_starts.size() && scan.run_starts[run] == i) {
            if (run > 0) out += " 0 0";
            ++run;
        }
        Point2 point = scan.points[i];
        // The origin itself would read as a break; this is as near as it gets.
        constexpr double kNearOrigin = 1e-300;
        if (point.x == 0.0 && point.y == 0.0) point.x = kNearOrigin;
        out += ' ';
        append_exact(out, point.x);
        out += ' ';
        append_exact(out, point.y);
    }
}

/// Behind the time: "n identity range bearing …".
void append_landmarks(std::string& out, const Scan& scan) {
    append_count(out, scan.landmarks.size());
    for (const LandmarkSighting& seen : scan.landmarks) {
        out += ' ';
        out += std::to_string(seen.identity);
        out += ' ';
        append_exact(out, seen.range_m);
        out += ' ';
        append_exact(out, seen.bearing_rad);
    }
}

/// "ODOM time V W", and VL where there is a lateral velocity.
void append_odometry(std::string& out, const Odometria& odometry) {
    out += "ODOM ";
    append_exact(out, odometry.time_s);
    out += ' ';
    append_exact(out, odometry.twist.v);
    out += ' ';
    append_exact(out, odometry.twist.w);
    if (odometry.twist.v_lateral != 0.0) {
        out += ' ';
        append_exact(out, odometry.twist.v_lateral);
    }
}

class LogWriterNormalized final : public TourWriter {
  public:
    using TourWriter::TourWriter;

  private:
    Prepared prepare(const Scan& scan) override;
    bool says_landmarks() const override { return true; }
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
};

TourWriter::Prepared LogWriterNormalized::prepare(const Scan& scan) {
    Prepared prepared;
    prepared.landmarks = !scan.landmarks.empty();  // then it has no points: each is a line
    if (prepared.landmarks) {
        append_landmarks(prepared.text, scan);
    } else {
        append_points(prepared.text, scan);
    }
    return prepared;
}

void LogWriterNormalized::put_scan(std::string& out, const Prepared& scan, double time_s,
                                   const Pose& /*pose_odom_robot*/) {
    out += scan.landmarks ? "LANDMARKS " : "LASER ";
    append_exact(out, time_s);
    out += ' ';
    out += scan.text;
    out += '\n';
}

void LogWriterNormalized::put_odometry(std::string& out, const Odometria& odometry,
                                       const Pose& /*pose_odom_robot*/) {
    append_odometry(out, odometry);
    out += '\n';
}

}  // namespace

OdometryRecord read_velocities(Fields& fields, const RawLine& line) {
    OdometryRecord record;
    record.line = line.number;
    record.time_s = fields.number("time");
    Twist velocity;
    velocity.v = fields.number("V");
    velocity.w = fields.number("W");
    record.velocity = velocity;
    return record;
}

LogFormat normalized_format() {
    LogFormat format = {{"normalized", HITOS_TEXT("ParameterChoice", "Normalised"),
                         "points and velocities as text, exact to the last bit"},
                        "*.log *.txt",
                        claims_normalized,
                        classify_normalized,
                        make_plain_conversor<ConversorNormalized>,
                        make_writer<LogWriterNormalized>};
    format.landmarks = true;
    return format;
}

}  // namespace hitos
