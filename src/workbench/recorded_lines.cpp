#include "hitos/workbench/recorded_lines.hpp"

namespace hitos {

void RecordedLines::Lines::add(const RawLine& line) {
    text += line.text;
    lines.push_back({text.size(), line.number});
}

std::optional<RawLine> RecordedLines::Lines::line(std::size_t k) const {
    if (k >= lines.size()) return std::nullopt;
    const std::size_t begin = k == 0 ? 0 : lines[k - 1].end;
    return RawLine{std::string_view(text).substr(begin, lines[k].end - begin), lines[k].number,
                   false};
}

RecordedLines::RecordedLines(Fuente& fuente) {
    while (const auto line = fuente.read_scan_line()) scans_.add(*line);
    while (const auto line = fuente.read_odometry_line()) odometry_.add(*line);
    scans_.text.shrink_to_fit();
}

const RecordedLines& FuenteGrabada::lines() {
    if (!lines_) lines_ = open_();
    return *lines_;
}

std::optional<RawLine> FuenteGrabada::read_scan_line() {
    const auto line = lines().scan_line(scan_);
    if (line) ++scan_;
    return line;
}

std::optional<RawLine> FuenteGrabada::read_odometry_line() {
    const auto line = lines().odometry_line(reading_);
    if (line) ++reading_;
    return line;
}

std::optional<double> FuenteGrabada::progress() const {
    if (!lines_ || lines_->scan_lines() == 0) return 0.0;
    return static_cast<double>(scan_) / static_cast<double>(lines_->scan_lines());
}

std::unique_ptr<Fuente> FuenteGrabada::reopen() const {
    return std::make_unique<FuenteGrabada>(name_, open_);
}

}  // namespace hitos
