// SPDX-License-Identifier: GPL-3.0-or-later
// Tours of the UTIAS Multi-Robot Cooperative Localization and Mapping Dataset (Leung, Halpern,
// Barfoot, Liu: The UTIAS multi-robot cooperative localization and mapping dataset, International
// Journal of Robotics Research 30(8), 2011; file formats as its site describes them): of each robot
// a file of odometry and one of what its camera saw of bar codes, on marks and on other robots.
#include "hitos/capture/mrclam.hpp"

#include <algorithm>
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

constexpr const char* kMeasurements = "_Measurement.dat";
constexpr const char* kOdometry = "_Odometry.dat";
constexpr const char* kBarcodes = "Barcodes.dat";
constexpr std::int64_t kRobots = 5;  // subjects 1 to 5; the marks are those from 6 on

/// "Robot3" of "Robot3_Odometry.dat"; nothing of other names.
std::string robot_of(const std::string& name) {
    constexpr std::string_view kRobot = "Robot";
    const std::size_t end = name.find('_');
    if (end == std::string::npos || !name.starts_with(kRobot)) return {};
    const std::string_view number = std::string_view(name).substr(0, end).substr(kRobot.size());
    const std::string_view rest = std::string_view(name).substr(end);
    const bool tour = rest == kOdometry || rest == kMeasurements;
    return tour && input::parse_whole(number) ? name.substr(0, end) : std::string();
}

std::vector<fs::path> mrclam_files(const fs::path& path) {
    const std::string robot = robot_of(path.filename().string());
    if (robot.empty()) return {};
    const fs::path folder = path.parent_path();
    return {folder / (robot + kMeasurements), folder / (robot + kOdometry), folder / kBarcodes};
}

LineKind classify_mrclam(std::string_view text) {
    const std::size_t fields = Fields(text).remaining();
    if (fields == 4) return LineKind::scan;
    return fields == 3 ? LineKind::odometry : LineKind::damaged;
}

/// The subject of each bar code.
using Subjects = std::map<std::int64_t, std::int64_t>;

Subjects read_subjects(const fs::path& path) {
    const std::string text = input::read_text(path, input::kLargestSettings);
    Subjects subjects;
    std::uint64_t number = 0;
    for (std::string_view rest = input::without_mark(text); !rest.empty();) {
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
            const std::string_view code = fields.peek();
            if (!subjects.emplace(fields.integer("barcode"), subject).second) {
                fields.fail("barcode", code, HITOS_TEXT("Errors", "one that no line before lists"));
            }
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
    std::optional<Scan> read_scan(const RawLine& line);

    ReadOptions options_;
    std::optional<LaserPose> laser_pose_;
    Subjects subjects_;
    std::optional<Scan> scan_;  // of the lines so far that have one time
};

/// A line has a number in both files: damage says in which.
template <class Read>
auto told_with(const char* file, const RawLine& line, const Read& read) {
    try {
        return read();
    } catch (const FormatError& error) {
        throw FormatError("", line.number, message("%1: %2", file + 1, error.problem()));
    }
}

std::optional<Scan> ConversorMrclam::scan(const RawLine& line) {
    return told_with(kMeasurements, line, [&] { return read_scan(line); });
}

std::optional<Scan> ConversorMrclam::read_scan(const RawLine& line) {
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
    return told_with(kOdometry, line, [&] {
        Fields fields(line);
        OdometryRecord record = read_velocities(fields, line);
        fields.expect_end(HITOS_TEXT("Errors", "the velocities"));
        return std::optional(record);
    });
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
    format.may_grow = false;
    format.of_robots = true;
    format.landmarks = true;
    return format;
}

}  // namespace hitos
