// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/trajectory_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/median.hpp"
#include "hitos/base/rounding.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/mrclam.hpp"
#include "hitos/services/files/tour_time.hpp"

namespace hitos {
namespace {

/// Stands before the first pose of a tour behind another one; to other programs it is a comment.
constexpr std::string_view kBegins = "# another tour begins";
constexpr std::array<std::string_view, 8> kTrajectoryFields = {"t",  "x",  "y",  "z",
                                                               "qx", "qy", "qz", "qw"};

/// What stands in which column, and how time is counted.
struct Columns {
    std::size_t count = kTrajectoryFields.size();  ///< a line may also have but the first eight
    bool qw_first = false;  ///< t x y z qw qx qy qz, as in the EuRoC data sets
    bool nanoseconds = false;
};

/// By blanks; where a line has others, by commas or semicolons. Commas are decimal ones where
/// there are blanks or semicolons enough without them.
std::vector<std::string_view> separated(std::string_view line) {
    std::vector<std::string_view> words = input::fields(line);
    const bool listed = std::ranges::any_of(
        words, [](std::string_view word) { return word.size() > 1 && word.ends_with(','); });
    const char mark = line.find(';') != std::string_view::npos ? ';' : ',';
    if (line.find(mark) == std::string_view::npos) return words;
    if (mark == ',' && words.size() == kTrajectoryFields.size() && !listed) return words;
    words.clear();
    while (true) {
        const std::size_t at = line.find(mark);
        words.push_back(input::trimmed(line.substr(0, at)));
        if (at == std::string_view::npos) break;
        line.remove_prefix(at + 1);
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// What a line of names says, with or without `#` before it: by the letter that each name ends
/// with (p_RS_R_x [m]); nothing where it is no such line.
std::optional<Columns> named_columns(std::string_view line) {
    line = line.substr(std::min(line.find_first_not_of("# "), line.size()));
    const std::vector<std::string_view> names = separated(line);
    if (names.size() < kTrajectoryFields.size()) return std::nullopt;
    std::string letters;
    for (std::size_t i = 1; i < kTrajectoryFields.size(); ++i) {
        const std::string_view name = input::trimmed(names[i].substr(0, names[i].find('[')));
        letters += name.empty() ? ' ' : name.back();
    }
    if (letters != "xyzxyzw" && letters != "xyzwxyz") return std::nullopt;
    return Columns{names.size(), letters == "xyzwxyz",
                   names[0].find("[ns]") != std::string_view::npos};
}

/// How the poses turn.
struct Turns {
    bool of_plane = false;  ///< about other axes than x
    bool rolls = false;
    bool any = false;                ///< the file has headings
    std::uint64_t none_at_line = 0;  ///< whose quaternion is all zero
};

[[noreturn]] void refuse_length(double length, const input::Place& place) {
    throw FormatError(place.file, place.line,
                      HITOS_TEXT("Errors", "the quaternion's length is %1; expected 1"),
                      fmt::format("{:.6g}", length));
}

StampedPose pose_from(std::string_view line, const Columns& columns, const input::Place& place,
                      Turns& turns) {
    const std::vector<std::string_view> words = separated(line);
    if (words.size() != columns.count) {
        input::require_columns(words.size(), kTrajectoryFields, place);
    }
    std::array<double, kTrajectoryFields.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        constexpr double kGreatestStamp = 1e20;  // of nanoseconds
        values[i] = input::finite_number(words[i], kTrajectoryFields[i], place,
                                         i == 0 ? kGreatestStamp : input::kGreatestNumber);
    }
    if (columns.qw_first) std::rotate(values.begin() + 4, values.begin() + 5, values.end());
    const auto [t, x, y, z, qx, qy, qz, qw] = values;
    // Rounding to two decimals moves the length by less than this.
    constexpr double kTolerance = 0.05;
    const double length = std::hypot(std::hypot(qx, qy), std::hypot(qz, qw));
    // A file of positions alone may have zeros there.
    if (length == 0.0) {
        if (turns.none_at_line == 0) turns.none_at_line = place.line;
        return {t, {x, y, 0.0}};
    }
    if (!(std::abs(length - 1.0) <= kTolerance)) refuse_length(length, place);
    turns.any = true;
    turns.of_plane = turns.of_plane || std::max(std::abs(qy), std::abs(qz)) > 1e-6;
    turns.rolls = turns.rolls || std::min(std::abs(qx), std::abs(qw)) > 1e-3;
    // This form of the yaw holds for a quaternion of any length.
    const double yaw = std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
    return {t, {x, y, wrap_angle(yaw)}};
}

/// By how many the stamps of a clock that began with the tour, as a simulation's, have to be
/// divided: whole numbers so far apart that in seconds the robot would hardly move are of the unit
/// in which it drives like one.
double unit_by_speed(const Trajectory& trajectory) {
    constexpr double kApart = 20.0;     // of milliseconds at 50 Hz; of seconds hardly any path is
    constexpr double kCreeping = 0.01;  // [m/s], on average: slower is no robot in seconds
    constexpr double kUsual = 0.3;      // [m/s]
    constexpr double kLeastWay = 0.5;   // [m]; else its speed says nothing
    constexpr double kShortest = 1e-3;  // from pose to pose [s]
    constexpr double kLongest = 10.0;
    std::vector<double> steps;
    double way_m = 0.0;
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        const double stamp = trajectory[i].time_s;
        if (stamp != std::floor(stamp)) return 1.0;
        if (i == 0) continue;
        const StampedPose& before = trajectory[i - 1];
        steps.push_back(stamp - before.time_s);
        way_m +=
            std::hypot(trajectory[i].pose.x - before.pose.x, trajectory[i].pose.y - before.pose.y);
    }
    const double step = median(steps);
    const double speed = way_m / tour_duration_s(trajectory);
    if (!(step >= kApart) || way_m < kLeastWay || !(speed > 0.0 && speed < kCreeping)) return 1.0;
    const auto unlike = [&](double unit) { return std::abs(std::log(speed * unit / kUsual)); };
    double best = 1.0;
    for (const double unit : {1e3, 1e6, 1e9}) {
        if (step < kShortest * unit || step > kLongest * unit) continue;
        if (best == 1.0 || unlike(unit) < unlike(best)) best = unit;
    }
    return best;
}

/// Stamps that cannot be seconds are brought to them where there is no doubt: where the way driven
/// does not say what they count, those of a clock of today say it by their size.
void to_seconds(Trajectory& trajectory, const Columns& columns, const std::string& name) {
    const auto [first, last] = std::ranges::minmax_element(trajectory, {}, &StampedPose::time_s);
    const double from = first->time_s;
    double unit = unit_by_speed(trajectory);
    const bool by_size = unit == 1.0;  // from a parked robot, or with decimals
    for (const double next : {1e3, 1e6, 1e9}) {
        if (by_size && from >= next * 1e8 && from >= 1e11 && last->time_s < 1e20) unit = next;
    }
    if (columns.nanoseconds) unit = 1e9;
    constexpr double kLongest = 1e9;  // s, thirty years
    if ((last->time_s - from) / unit > kLongest) {
        throw FormatError(name, 0,
                          HITOS_TEXT("Errors",
                                     "the stamps go from %1 to %2, which cannot be seconds; "
                                     "expected seconds (nanoseconds divided by 1e9)"),
                          from, last->time_s);
    }
    if (unit == 1.0) return;
    for (StampedPose& pose : trajectory) pose.time_s /= unit;
}

/// Robot1_Groundtruth.dat, of which headings are angles.
Trajectory parse_mrclam_way(std::string_view text, const std::string& name) {
    constexpr std::array<std::string_view, 4> kColumns = {"t", "x", "y", "orientation"};
    Trajectory trajectory;
    for (const auto& row : mrclam_rows(text, kColumns, name)) {
        const auto [t, x, y, theta] = row.values;
        trajectory.push_back({t, {x, y, wrap_angle(theta)}});
    }
    return trajectory;
}

}  // namespace

Trajectory read_trajectory(const std::filesystem::path& path) {
    return parse_trajectory(input::read_text(path), path.string());
}

Trajectory parse_trajectory(std::string_view text, const std::string& name) {
    text = input::without_mark(text);
    Trajectory trajectory;
    if (is_of_mrclam(text)) {
        trajectory = parse_mrclam_way(text, name);
        text = {};
    }
    Columns columns;
    Turns turns;
    bool begins = false;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(*line);
        if (content.empty()) continue;
        begins = begins || (content == kBegins && !trajectory.empty());
        if (content.starts_with('#') || trajectory.empty()) {
            if (const auto named = named_columns(content)) {
                columns = *named;
                continue;
            }
        }
        if (content.starts_with('#')) continue;
        trajectory.push_back(pose_from(content, columns, {name, number}, turns));
        trajectory.back().begins = std::exchange(begins, false);
    }
    if (trajectory.empty()) {
        throw FormatError(
            name, 0,
            HITOS_TEXT(
                "Errors",
                "no pose in the file; expected 8 numbers, t x y z qx qy qz qw on each line"));
    }
    if (turns.any && turns.none_at_line > 0) refuse_length(0.0, {name, turns.none_at_line});
    if (turns.rolls && !turns.of_plane) {
        throw FormatError(
            name, 0,
            HITOS_TEXT(
                "Errors",
                "the robot rolls about its x axis and turns about no other, as where qw stands "
                "before qx; expected t x y z qx qy qz qw, or a first line that names the columns"));
    }
    to_seconds(trajectory, columns, name);
    return trajectory;
}

std::string trajectory_to_text(const Trajectory& trajectory) {
    std::string text;
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        const double t = trajectory[i].time_s;
        const Pose& pose = trajectory[i].pose;
        if (!std::isfinite(t) || !std::isfinite(pose.x) || !std::isfinite(pose.y) ||
            !std::isfinite(pose.theta)) {
            throw Error(message(HITOS_TEXT("Errors",
                                           "pose %1 of the trajectory (t %2, x %3, y %4, theta %5) "
                                           "is not finite and cannot be written"),
                                i, t, pose.x, pose.y, pose.theta));
        }
        const double half = wrap_angle(pose.theta) / 2.0;
        if (trajectory[i].begins && i > 0) text.append(kBegins).append(1, '\n');
        text += fmt::format("{} {} {} 0 0 0 {} {}\n", without_sign_of_zero(t),
                            fixed_point(pose.x, 9), fixed_point(pose.y, 9),
                            fixed_point(std::sin(half), 9), fixed_point(std::cos(half), 9));
    }
    return text;
}

void write_trajectory(const Trajectory& trajectory, const std::filesystem::path& path) {
    write_file(path, trajectory_to_text(trajectory));
}

}  // namespace hitos
