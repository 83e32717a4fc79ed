#include "hitos/workbench/source_inspection.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "hitos/capture/procesador.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos::window {
namespace {

std::vector<std::string> first_lines_of(const std::string& path) {
    constexpr std::size_t kLines = 30;
    constexpr std::size_t kLongest = 200;
    std::vector<std::string> lines;
    std::ifstream file(path);
    for (std::string line; lines.size() < kLines && std::getline(file, line);)
        lines.push_back(line.substr(0, kLongest));
    return lines;
}

}  // namespace

LogSummary inspect_source(const SourceParams& source, const InspectProgress& progress) {
    if (!is_world_file(source.file)) {
        return inspect_log(source.file, source.format, source.read, progress);
    }
    LogSummary summary;
    Procesador reader(open_tour(source), source.read);
    summary.format = reader.fuente().format();
    summary.first_lines = first_lines_of(source.file);
    bool first = true;
    double last_s = 0.0;
    while (const auto scan = reader.next_scan()) {
        if (first) summary.first_stamp_s = scan->time_s;
        first = false;
        summary.duration_s = scan->time_s - summary.first_stamp_s;
        if (progress && !progress(reader.fuente().progress().value_or(0.0))) {
            summary.complete = false;
            break;
        }
    }
    while (summary.complete) {
        const auto reading = reader.next_odometry();
        if (!reading) break;
        summary.distance_m += std::abs(reading->twist.v) * std::max(0.0, reading->time_s - last_s);
        last_s = reading->time_s;
    }
    summary.report = reader.report();
    return summary;
}

}  // namespace hitos::window
