// The normalised format of [T A.3]: points and velocities, nothing to convert. Written with digits
// that read back as the same bits.
#include <cmath>
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
    if (name == "LASER") return parse_double(fields.take()) && parse_integer(fields.take());
    if (name != "ODOM") return false;
    const std::size_t count = fields.remaining();
    return (count == 3 || count == 4) && parse_double(fields.take());
}

LineKind classify_normalized(std::string_view text) {
    const std::string_view name = Fields(text).peek();
    if (name == "LASER") return LineKind::scan;
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
    ReadOptions options_;
    std::optional<LaserPose> laser_pose_;  // of the options
};

std::optional<Scan> ConversorNormalized::scan(const RawLine& line) {
    Fields fields(line);
    fields.word("LASER");
    Scan scan;
    scan.line = line.number;
    scan.time_s = fields.number("time");
    if (laser_pose_) {
        scan.fan.pose_robot_laser = laser_pose_->pose_robot_laser;
        scan.fan.upside_down = laser_pose_->upside_down;
    }
    // A scan that hit nothing is one too.
    const std::uint32_t count = fields.count("n", 0);
    const double greatest = options_.max_range_m;
    bool run_open = false;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = options_.range_scale * fields.reading("x");
        const double y = options_.range_scale * fields.reading("y");
        const bool none = (x == 0.0 && y == 0.0) || !std::isfinite(x) || !std::isfinite(y);
        if (none || (greatest > 0.0 && std::hypot(x, y) >= greatest)) {
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        scan.points.push_back(laser_pose_ ? laser_pose_->mounted({x, y}) : Point2{x, y});
    }
    fields.expect_end(HITOS_TEXT("Errors", "the points that n announces"));
    return scan;
}

std::optional<OdometryRecord> ConversorNormalized::odometry(const RawLine& line) {
    Fields fields(line);
    fields.word("ODOM");
    OdometryRecord record;
    record.line = line.number;
    record.time_s = fields.number("time");
    Twist velocity;
    velocity.v = fields.number("V");
    velocity.w = fields.number("W");
    if (!fields.at_end()) velocity.v_lateral = fields.number("VL");
    fields.expect_end(HITOS_TEXT("Errors", "the velocities"));
    record.velocity = velocity;
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
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
};

TourWriter::Prepared LogWriterNormalized::prepare(const Scan& scan) {
    Prepared prepared;
    append_points(prepared.text, scan);
    return prepared;
}

void LogWriterNormalized::put_scan(std::string& out, const Prepared& scan, double time_s,
                                   const Pose& /*pose_odom_robot*/) {
    out += "LASER ";
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

LogFormat normalized_format() {
    return {{"normalized", HITOS_TEXT("ParameterChoice", "Normalised"),
             "points and velocities as text, exact to the last bit"},
            "*.log *.txt",
            claims_normalized,
            classify_normalized,
            make_plain_conversor<ConversorNormalized>,
            make_writer<LogWriterNormalized>};
}

}  // namespace hitos
