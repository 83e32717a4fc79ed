#include <string>

#include "formats/formats.hpp"
#include "hitos/base/error.hpp"

namespace hitos {

Registry<LogFormat>& log_formats() {
    static Registry<LogFormat> table(
        "log format", "source.format",
        {player_format(), radish_format(), normalized_format(), carmen_format()});
    return table;
}

std::string log_format_choices() {
    return std::string(kAutoFormat) + ", " + log_formats().words(" or ");
}

std::string checked_log_format(std::string_view word, const std::string& option) {
    if (word == kAutoFormat || log_formats().knows(word)) return std::string(word);
    throw ConfigError(option,
                      "found \"" + std::string(word) + "\", expected " + log_format_choices());
}

std::string checked_target_format(std::string_view word, const std::string& option) {
    std::string writable;
    for (const LogFormat& format : log_formats().entries()) {
        if (format.make_writer == nullptr) continue;
        if (format.word == word) return format.word;
        writable += (writable.empty() ? "" : ", ") + format.word;
    }
    throw ConfigError(option, "found \"" + std::string(word) + "\", expected one of " + writable);
}

void write_tour(TourReader& reader, LogWriter& writer, const std::function<void()>& told) {
    std::optional<Odometria> reading = reader.next_odometry();
    while (const std::optional<Scan> scan = reader.next_scan()) {
        // A scan whose line carries odometry goes by line: stamps may jitter there.
        const auto belongs_before = [&scan](const Odometria& next) {
            return scan->carries_odometry ? next.line <= scan->line : next.time_s <= scan->time_s;
        };
        for (; reading && belongs_before(*reading); reading = reader.next_odometry()) {
            writer.write(*reading);
        }
        writer.write(*scan);
        if (told) told();
    }
    for (; reading; reading = reader.next_odometry()) writer.write(*reading);
}

std::unique_ptr<LogWriter> make_log_writer(std::string_view format,
                                           const std::filesystem::path& path) {
    return log_formats().find(checked_target_format(format, path.string())).make_writer(path);
}

}  // namespace hitos
