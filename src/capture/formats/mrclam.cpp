// Tours of the UTIAS Multi-Robot Cooperative Localization and Mapping Dataset (Leung, Halpern,
// Barfoot, Liu: The UTIAS multi-robot cooperative localization and mapping dataset, International
// Journal of Robotics Research 30(8), 2011; file formats as its site describes them): of each robot
// a file of odometry and one of what its camera saw of bar codes, on marks and on other robots.
#include "hitos/capture/mrclam.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "formats/formats.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "laser_pose.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBarcodes = "Barcodes.dat";
constexpr std::int64_t kRobots = 5;  // subjects 1 to 5; the marks are those from 6 on

/// Its number in "Robot3_Odometry.dat"; nothing of other names.
std::optional<int> robot_of(const std::string& name) {
    constexpr std::string_view kRobot = "Robot";
    if (!name.starts_with(kRobot)) return std::nullopt;
    int robot = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + kRobot.size(), end, robot);
    const std::string_view rest(stop, static_cast<std::size_t>(end - stop));
    const bool tour = rest == "_Odometry.dat" || rest == "_Measurement.dat";
    return error == std::errc() && tour ? std::optional(robot) : std::nullopt;
}

std::vector<fs::path> mrclam_files(const fs::path& path) {
    const std::optional<int> robot = robot_of(path.filename().string());
    if (!robot) return {};
    const fs::path folder = path.parent_path();
    const std::string name = "Robot" + std::to_string(*robot);
    return {folder / (name + "_Measurement.dat"), folder / (name + "_Odometry.dat"),
            folder / kBarcodes};
}

LineKind classify_mrclam(std::string_view text) {
    const std::size_t fields = Fields(text).remaining();
    if (fields == 4) return LineKind::scan;
    return fields == 3 ? LineKind::odometry : LineKind::damaged;
}

/// The subject of each bar code.
using Subjects = std::map<std::int64_t, std::int64_t>;

Subjects read_subjects(const fs::path& path) {
    const std::string text = input::read_text(path);
    Subjects subjects;
    std::uint64_t number = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        Fields fields(line, ++number);
        if (fields.at_end() || fields.peek().starts_with('#')) continue;
        try {
            const std::string_view word = fields.peek();
            const std::int64_t subject = fields.integer("subject");
            if (subject < 1 || subject > std::numeric_limits<std::int32_t>::max()) {
                fields.fail("subject", word, HITOS_TEXT("Errors", "a whole number from 1"));
            }
            subjects[fields.integer("barcode")] = subject;
            fields.expect_end("barcode");
        } catch (const FormatError& error) {
            throw FormatError(path.string(), number, error.problem());
        }
    }
    return subjects;
}

class ConversorMrclam final : public Conversor {
  public:
    ConversorMrclam(const ReadOptions& options, Subjects subjects)
        : options_(options),
          laser_pose_(laser_pose_of(options.laser_pose)),
          subjects_(std::move(subjects)) {}
    std::optional<Scan> scan(const RawLine& line) override;
    std::optional<Scan> last_scan() override { return std::exchange(scan_, std::nullopt); }
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    ReadOptions options_;
    std::optional<LaserPose> laser_pose_;
    Subjects subjects_;
    std::optional<Scan> scan_;  // of the lines so far that have one time
};

std::optional<Scan> ConversorMrclam::scan(const RawLine& line) {
    Fields fields(line);
    const double time_s = fields.number("time");
    const std::string_view code = fields.peek();
    const auto subject = subjects_.find(fields.integer("barcode"));
    if (subject == subjects_.end()) {
        fields.fail("barcode", code, HITOS_TEXT("Errors", "one that Barcodes.dat lists"));
    }
    LandmarkSighting seen;
    const std::string_view range = fields.peek();
    seen.range_m = options_.range_scale * fields.number("range");
    if (seen.range_m < 0.0) fields.fail("range", range, HITOS_TEXT("Errors", "no less than 0"));
    seen.bearing_rad = fields.number("bearing");
    fields.expect_end("bearing");
    if (subject->second <= kRobots) return std::nullopt;  // it drives about
    if (options_.max_range_m > 0.0 && seen.range_m >= options_.max_range_m) return std::nullopt;
    if (seen.range_m < options_.min_range_m) return std::nullopt;
    seen.identity = static_cast<std::int32_t>(subject->second);
    std::optional<Scan> whole;
    if (!scan_ || scan_->time_s != time_s) {
        whole = std::exchange(scan_, Scan());
        scan_->time_s = time_s;
        scan_->line = line.number;
        if (laser_pose_) {
            scan_->fan.pose_robot_laser = laser_pose_->pose_robot_laser;
            scan_->fan.upside_down = laser_pose_->upside_down;
        }
    }
    scan_->landmarks.push_back(laser_pose_ ? laser_pose_->mounted(seen) : seen);
    return whole;
}

std::optional<OdometryRecord> ConversorMrclam::odometry(const RawLine& line) {
    Fields fields(line);
    OdometryRecord record = read_velocities(fields, line);
    fields.expect_end(HITOS_TEXT("Errors", "the velocities"));
    return record;
}

std::unique_ptr<Conversor> make_conversor_mrclam(const Fuente& fuente, const ReadOptions& options) {
    const fs::path barcodes = fs::path(fuente.name()).parent_path() / kBarcodes;
    return std::make_unique<ConversorMrclam>(options, read_subjects(barcodes));
}

}  // namespace

LogFormat mrclam_format() {
    LogFormat format = {{"mrclam", HITOS_TEXT("ParameterChoice", "MRCLAM"),
                         "a robot's Odometry.dat, with Measurement.dat and Barcodes.dat beside it"},
                        "*.dat",
                        is_of_mrclam,
                        classify_mrclam,
                        make_conversor_mrclam};
    format.files = mrclam_files;
    format.of_robots = true;
    return format;
}

}  // namespace hitos
