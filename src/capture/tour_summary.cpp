// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/tour_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "line_reader.hpp"

namespace hitos {
namespace {

constexpr std::uint64_t kWholeTour = std::numeric_limits<std::uint64_t>::max();
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Collects what a summary says beyond the counts.
class Stamps {
  public:
    /// `begins`: another tour does.
    void add(double time_s, bool begins = false) {
        if (begins) pauses_ += std::max(0.0, time_s - last_);
        first_ = std::min(first_, time_s);
        last_ = std::max(last_, time_s);
    }
    bool any() const { return first_ <= last_; }
    double first() const { return first_; }
    double duration() const { return last_ - first_ - pauses_; }

  private:
    double first_ = std::numeric_limits<double>::infinity();
    double last_ = -std::numeric_limits<double>::infinity();
    double pauses_ = 0.0;  // between tours
};

[[noreturn]] void refuse_empty(const TourReader& reader) {
    const ReadReport& report = reader.report();
    if (report.examples.empty()) {
        throw FormatError(
            reader.name(), 0,
            HITOS_TEXT("Errors",
                       "nothing in it can be read as %1; it holds neither scans nor odometry"),
            reader.format());
    }
    const ReadReport::Skip& first = report.examples.front();
    throw FormatError(reader.name(), report.of_recording ? 0 : first.line,
                      HITOS_TEXT("Errors", "nothing in it can be read as %1: %2"), reader.format(),
                      report.of_recording ? report.placed(first) : first.reason);
}

/// A message tells all other control characters in words.
std::string in_one_line(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return name;
}

}  // namespace

std::vector<Message> lines_of(const std::vector<RecordedTopic>& topics) {
    constexpr std::size_t kMost = 200;
    std::vector<Message> lines;
    for (const RecordedTopic& topic : topics) {
        if (lines.size() == kMost) break;
        lines.push_back(message("%1  %2  %3", in_one_line(topic.name), in_one_line(topic.type),
                                topic.messages));
    }
    return lines;
}

std::vector<RecordedTopic> topics_of(const std::filesystem::path& path) {
    const LogFormat* recording = recording_format(path);
    return recording != nullptr ? recording->topics(path) : std::vector<RecordedTopic>{};
}

std::vector<Message> first_lines_of(const std::filesystem::path& path) {
    constexpr std::size_t kLines = 30;
    constexpr std::size_t kShown = 200;
    if (recording_format(path) != nullptr) return lines_of(topics_of(path));
    std::vector<Message> lines;
    LineReader reader(path);
    while (lines.size() < kLines) {
        const std::optional<LineReader::Line> line = reader.next();
        if (!line) break;
        lines.push_back(line->damage.empty() ? verbatim(std::string(line->text.substr(0, kShown)))
                                             : line->damage);
    }
    return lines;
}

TourSummary inspect_tour(TourReader& reader, const InspectProgress& progress) {
    TourSummary summary;
    summary.format = reader.format();
    Stamps stamps;
    TourExamination examination(reader.options());
    std::optional<double> clock_s;
    std::optional<Odometria> reading;
    bool more = true;
    // As far as a run reads it with a scan, so that both examine the same.
    const auto read_odometry_to = [&](std::uint64_t line, double time_s) {
        while (more && (!reading || (reading->line < line && reading->time_s < time_s))) {
            reading = reader.next_odometry();
            more = reading.has_value();
            if (!more) return;
            stamps.add(reading->time_s, reading->lines_before > 0);
            examination.note(*reading);
            const double seconds = reading->time_s - clock_s.value_or(reading->time_s);
            summary.distance_m += std::hypot(reading->twist.v, reading->twist.v_lateral) * seconds;
            clock_s = reading->time_s;
        }
    };
    while (const std::optional<Scan> scan = reader.next_scan()) {
        if (reader.report().scans == 1) summary.fan = scan->fan;
        if (scan->begins_tour) summary.scans_of_map = reader.report().scans - 1;
        stamps.add(scan->time_s, scan->begins_tour.has_value());
        summary.points += scan->points.size();
        summary.sightings += scan->landmarks.size();
        for (const LandmarkSighting& seen : scan->landmarks) {
            if (seen.identity == LandmarkSighting::kNameless) {
                ++summary.nameless;
            } else {
                summary.identities.insert(seen.identity);
            }
        }
        examination.note(*scan);
        scan->carries_odometry ? read_odometry_to(scan->line, kNever)
                               : read_odometry_to(kWholeTour, scan->time_s);
        if (progress && !progress(reader.progress().value_or(0.0))) {
            summary.complete = false;
            break;
        }
    }
    if (summary.complete) {
        read_odometry_to(kWholeTour, kNever);
        if (progress) progress(1.0);
        summary.findings = examination.findings(reader.findings());
        if (!stamps.any()) refuse_empty(reader);
    }
    summary.report = reader.report();
    if (stamps.any()) {
        summary.first_stamp_s = stamps.first();
        summary.duration_s = stamps.duration();
    }
    return summary;
}

}  // namespace hitos
