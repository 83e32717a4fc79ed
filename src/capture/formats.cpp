#include "formats.hpp"

#include <algorithm>
#include <cstddef>

#include "fields.hpp"

namespace hitos {
namespace {

using Kind = Archivo::LineKind;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool begins_with_letter(std::string_view text) {
    return !text.empty() && is_letter(text.front());
}

/// A line that begins with a word is some message that is not needed; anything else is damage.
Kind other_or_damaged(std::string_view text) {
    return begins_with_letter(text) ? Kind::other : Kind::damaged;
}

bool is_carmen_scan(std::string_view name) {
    return name == "FLASER" || name == "ROBOTLASER1" || name == "RAWLASER1";
}

bool is_carmen_parameter(std::string_view name) {
    constexpr std::array<std::string_view, 5> kNames = {
        "robot_front_laser_max", "laser_front_laser_resolution", "robot_frontlaser_offset",
        "robot_frontlaser_side_offset", "robot_frontlaser_angular_offset"};
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

bool looks_like_player(std::string_view text) {
    return text.starts_with("## Player version") || split_player_header(text).has_value();
}

/// A.2: a word, the device's index, a time, and numbers.
bool looks_like_radish(std::string_view text) {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name != "position" && name != "laser") return false;
    return parse_integer(fields.take()) && parse_double(fields.take()) &&
           parse_double(fields.take());
}

/// A.3 shares ODOM with CARMEN, whose line has nine fields after the name.
bool looks_like_normalized(std::string_view text) {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "LASER") return parse_double(fields.take()) && parse_integer(fields.take());
    if (name != "ODOM") return false;
    const std::size_t count = fields.remaining();
    return (count == 3 || count == 4) && parse_double(fields.take());
}

bool looks_like_carmen(std::string_view text) {
    if (text.starts_with("# CARMEN Logfile")) return true;
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "ODOM") return fields.remaining() >= 8 && parse_double(fields.take());
    if (name == "PARAM") return fields.remaining() >= 2;
    constexpr std::array<std::string_view, 3> kStems = {"RAWLASER", "ROBOTLASER", "TRUEPOS"};
    const auto stem = [name](std::string_view s) { return name.starts_with(s); };
    return name == "FLASER" || name == "RLASER" || std::any_of(kStems.begin(), kStems.end(), stem);
}

bool looks_like(LogFormat format, std::string_view text) {
    switch (format) {
        case LogFormat::player:
            return looks_like_player(text);
        case LogFormat::radish:
            return looks_like_radish(text);
        case LogFormat::normalized:
            return looks_like_normalized(text);
        case LogFormat::carmen:
            return looks_like_carmen(text);
        case LogFormat::automatic:
            break;
    }
    return false;
}

}  // namespace

bool PlayerHeader::is(std::int64_t wanted_type, std::int64_t wanted_subtype) const {
    return parse_integer(type) == wanted_type && parse_integer(subtype) == wanted_subtype;
}

std::optional<PlayerHeader> split_player_header(std::string_view text) {
    Fields fields(text);
    PlayerHeader header;
    header.time = fields.take();
    fields.take();  // host: a number or a name
    fields.take();  // robot: the port
    header.interface = fields.take();
    header.index = fields.take();
    const std::string_view sixth = fields.take();
    if (header.time.empty() || is_letter(header.time.front()) || sixth.empty()) return std::nullopt;
    if (!begins_with_letter(header.interface) || !parse_integer(header.index)) return std::nullopt;
    if (sixth.find('.') == std::string_view::npos) {
        header.type = sixth;
        header.subtype = fields.take();
        if (header.subtype.empty()) return std::nullopt;
    }
    header.payload = fields.rest();
    return header;
}

Kind ArchivoPlayer::classify(std::string_view text) const {
    const std::optional<PlayerHeader> header = split_player_header(text);
    if (!header) return Kind::damaged;
    const bool laser = header->interface == "laser";
    const bool ranger = header->interface == "ranger";
    const bool position = header->interface == "position2d" || header->interface == "position";
    if (!laser && !ranger && !position) return Kind::other;
    const Kind kind = position ? Kind::odometry : Kind::scan;
    if (header->old_layout()) return kind;
    // Digits that are none must reach the converter, which says what is wrong with them.
    if (!parse_integer(header->type) || !parse_integer(header->subtype)) return kind;
    const bool data = header->is(1, 1);
    if (position) return data ? kind : Kind::other;
    // writelog leaves the payload out of messages that it does not know.
    if (header->payload.empty() && !data) return Kind::other;
    const bool geometry = header->is(4, 1);
    if (laser) return data || geometry || header->is(1, 2) || header->is(1, 3) ? kind : Kind::other;
    return data || geometry || header->is(4, 5) ? kind : Kind::other;
}

Kind ArchivoRadish::classify(std::string_view text) const {
    const std::string_view name = Fields(text).peek();
    if (name == "laser") return Kind::scan;
    if (name == "position") return Kind::odometry;
    return other_or_damaged(text);
}

Kind ArchivoNormalizado::classify(std::string_view text) const {
    const std::string_view name = Fields(text).peek();
    if (name == "LASER") return Kind::scan;
    if (name == "ODOM") return Kind::odometry;
    return other_or_damaged(text);
}

Kind ArchivoCarmen::classify(std::string_view text) const {
    Fields fields(text);
    const std::string_view name = fields.take();
    if (name == "ODOM") return Kind::odometry;
    if (is_carmen_scan(name)) return name == "RAWLASER1" ? Kind::scan : Kind::both;
    if (name == "PARAM") return is_carmen_parameter(fields.take()) ? Kind::scan : Kind::other;
    return other_or_damaged(text);
}

std::optional<LogFormat> format_of_line(std::string_view text) {
    std::optional<LogFormat> found;
    for (const LogFormat format : kFormats) {
        if (!looks_like(format, text)) continue;
        if (found) return std::nullopt;
        found = format;
    }
    return found;
}

std::unique_ptr<Archivo> make_archivo(LogFormat format, const std::filesystem::path& path) {
    switch (format) {
        case LogFormat::radish:
            return std::make_unique<ArchivoRadish>(path);
        case LogFormat::normalized:
            return std::make_unique<ArchivoNormalizado>(path);
        case LogFormat::carmen:
            return std::make_unique<ArchivoCarmen>(path);
        case LogFormat::player:
        case LogFormat::automatic:
            break;
    }
    return std::make_unique<ArchivoPlayer>(path);
}

}  // namespace hitos
