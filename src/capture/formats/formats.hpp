// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of the table of log formats, one file each, and what they share.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "fields.hpp"
#include "hitos/capture/conversor.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "range_conversor.hpp"

namespace hitos {

LogFormat player_format();
LogFormat radish_format();
LogFormat normalized_format();
LogFormat carmen_format();
LogFormat mrclam_format();
LogFormat rosbag_format();
LogFormat mcap_format();
LogFormat db3_format();
LogFormat rosbag2_format();

std::unique_ptr<LogWriter> make_mcap_writer(const std::filesystem::path& path);

inline bool begins_with_letter(std::string_view text) {
    if (text.empty()) return false;
    const char c = text.front();
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A line that begins with a word is some message that is not needed; anything else is damage.
inline LineKind other_or_damaged(std::string_view text) {
    return begins_with_letter(text) ? LineKind::other : LineKind::damaged;
}

/// "time V W" of a line, whose rest is left: m/s, rad/s.
OdometryRecord read_velocities(Fields& fields, const RawLine& line);

/// Tells a converter of ranges by which value the log says "no return" where nothing states it.
template <class Made>
void look_for_no_return(const Fuente& fuente, const ReadOptions& options, Made& conversor) {
    if (options.max_range_m > 0.0) return;
    Made scratch(options);  // looking ahead leaves metadata in it
    conversor.set_no_return(find_no_return(fuente, scratch));
}

template <class Made>
std::unique_ptr<Conversor> make_range_conversor(const Fuente& fuente, const ReadOptions& options) {
    auto conversor = std::make_unique<Made>(options);
    look_for_no_return(fuente, options, *conversor);
    return conversor;
}

/// What there is to doubt about the ranges of a log.
template <class Made>
std::vector<TourFinding> range_doubts(const Fuente& fuente, const ReadOptions& options) {
    Made conversor(options);
    look_for_no_return(fuente, options, conversor);
    const std::optional<TourFinding> units = doubt_units(fuente, options, conversor);
    return units ? std::vector{*units} : std::vector<TourFinding>{};
}

template <class Made>
std::unique_ptr<Conversor> make_plain_conversor(const Fuente& /*fuente*/,
                                                const ReadOptions& options) {
    return std::make_unique<Made>(options);
}

template <class Made>
std::unique_ptr<LogWriter> make_writer(const std::filesystem::path& path) {
    return std::make_unique<Made>(path);
}

}  // namespace hitos
