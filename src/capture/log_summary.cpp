#include "hitos/capture/log_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "line_reader.hpp"

namespace hitos {
namespace {

std::vector<std::string> first_lines_of(const std::filesystem::path& path) {
    constexpr std::size_t kLines = 12;
    constexpr std::size_t kShown = 200;
    std::vector<std::string> lines;
    LineReader reader(path);
    while (lines.size() < kLines) {
        const std::optional<LineReader::Line> line = reader.next();
        if (!line) break;
        lines.emplace_back(line->damage.empty() ? line->text.substr(0, kShown)
                                                : std::string_view(line->damage));
    }
    return lines;
}

/// Collects what a summary says beyond the counts.
class Stamps {
  public:
    void add(double time_s) {
        first_ = std::min(first_, time_s);
        last_ = std::max(last_, time_s);
    }
    bool any() const { return first_ <= last_; }
    double first() const { return first_; }
    double duration() const { return last_ - first_; }

  private:
    double first_ = std::numeric_limits<double>::infinity();
    double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

LogSummary inspect_log(const std::filesystem::path& path, LogFormat format,
                       const ReadOptions& options, const InspectProgress& progress) {
    std::unique_ptr<Archivo> log = open_log(path, format);
    LogSummary summary;
    summary.format = log->format();
    summary.first_lines = first_lines_of(path);
    Procesador procesador(std::move(log), options);

    Stamps stamps;
    std::optional<double> clock_s;
    std::uint64_t odometry_line = 0;
    const auto read_odometry_to = [&](std::uint64_t line) {
        while (odometry_line < line) {
            const std::optional<Odometria> reading = procesador.next_odometry();
            if (!reading) {
                odometry_line = std::numeric_limits<std::uint64_t>::max();
                return;
            }
            odometry_line = reading->line;
            stamps.add(reading->time_s);
            if (clock_s) {
                const double seconds = reading->time_s - *clock_s;
                summary.distance_m +=
                    std::hypot(reading->twist.v, reading->twist.v_lateral) * seconds;
            }
            clock_s = reading->time_s;
        }
    };
    while (const std::optional<Scan> scan = procesador.next_scan()) {
        if (procesador.report().scans == 1) summary.fan = scan->fan;
        stamps.add(scan->time_s);
        // Both cursors keep together, so that progress means both.
        read_odometry_to(scan->line);
        const double done = procesador.fuente().progress().value_or(0.0);
        if (progress && !progress(done)) {
            summary.complete = false;
            break;
        }
    }
    if (summary.complete) {
        read_odometry_to(std::numeric_limits<std::uint64_t>::max());
        if (progress) progress(1.0);
    }
    summary.report = procesador.report();
    if (stamps.any()) {
        summary.first_stamp_s = stamps.first();
        summary.duration_s = stamps.duration();
    } else if (summary.complete) {
        const ReadReport& report = summary.report;
        throw FormatError(path.string(), report.examples.empty() ? 0 : report.examples.front().line,
                          "nothing in it can be read as " + std::string(to_string(summary.format)) +
                              (report.examples.empty() ? "; it holds neither scans nor odometry"
                                                       : ": " + report.examples.front().reason));
    }
    return summary;
}

}  // namespace hitos
