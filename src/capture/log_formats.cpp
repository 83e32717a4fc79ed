// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

bool writable(const LogFormat& format) {
    return format.make_writer != nullptr;
}

}  // namespace

Registry<LogFormat>& log_formats() {
    static Registry<LogFormat> table(
        "log format", "source.format",
        {player_format(), radish_format(), normalized_format(), carmen_format(), mrclam_format(),
         rosbag_format(), mcap_format(), db3_format(), rosbag2_format()});
    return table;
}

std::string log_format_choices() {
    return std::string(kAutoFormat) + ", " + log_formats().either().english();
}

std::string checked_log_format(std::string_view word, const std::string& option) {
    if (word == kAutoFormat || log_formats().knows(word)) return std::string(word);
    throw ConfigError(option, HITOS_TEXT("Errors", "found \"%1\", expected %2"), word,
                      message("%1, %2", kAutoFormat, log_formats().either()));
}

std::string log_endings() {
    std::vector<std::string_view> known;
    std::string endings;
    for (const LogFormat& format : log_formats().entries()) {
        for (const std::string_view ending : input::fields(format.endings)) {
            if (std::ranges::find(known, ending) != known.end()) continue;
            known.push_back(ending);
            endings.append(endings.empty() ? "" : " ").append(ending);
        }
    }
    return endings;
}

std::string writable_formats() {
    return log_formats().either(writable).english();
}

std::string checked_target_format(std::string_view word, const std::string& option) {
    if (log_formats().knows(word) && log_formats().find(word).make_writer != nullptr) {
        return std::string(word);
    }
    throw ConfigError(option, HITOS_TEXT("Errors", "found \"%1\", expected %2"), word,
                      log_formats().either(writable));
}

std::string format_by_ending(const std::filesystem::path& path, std::string_view wished) {
    const std::filesystem::path name = path.extension() == ".gz" ? path.stem() : path.filename();
    const std::string ending = "*" + name.extension().string();
    std::vector<std::string> owners;
    for (const LogFormat& format : log_formats().entries()) {
        const std::vector<std::string_view> endings = input::fields(format.endings);
        if (writable(format) && std::ranges::find(endings, ending) != endings.end()) {
            owners.emplace_back(format.word);
        }
    }
    return owners.size() == 1 ? owners.front() : std::string(wished);
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
        writer.write(*scan, reading ? &*reading : nullptr);
        if (told) told();
    }
    for (; reading; reading = reader.next_odometry()) writer.write(*reading);
}

std::unique_ptr<LogWriter> make_log_writer(std::string_view format,
                                           const std::filesystem::path& path) {
    return log_formats().find(checked_target_format(format, path.string())).make_writer(path);
}

}  // namespace hitos
