// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/tracing/occupancy_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <system_error>

#include "files/map_server_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/drawing/picture_file.hpp"

namespace hitos {
namespace {

constexpr double kLeastResolution = 1e-4;  // m
constexpr double kGreatestResolution = 10.0;
constexpr double kOpaque = 255.0;

struct Entry {
    std::string value;
    std::uint64_t line = 0;
};

/// A comment begins behind a blank, or with the line, and not in quotes.
std::string_view without_comment(std::string_view line) {
    char quote = '\0';
    for (std::size_t at = 0; at < line.size(); ++at) {
        const char c = line[at];
        if (quote != '\0') {
            if (c == quote) quote = '\0';
        } else if ((c == '"' || c == '\'') &&
                   (at == 0 || std::string_view(" \t[{,:").find(line[at - 1]) < 6)) {
            quote = c;
        } else if (c == '#' && (at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t')) {
            line = line.substr(0, at);
            break;
        }
    }
    return input::trimmed(line);
}

/// The lines `key: value` that map_server's files are made of, also where a library wrote them:
/// lists item by item, over several lines, or all in one pair of braces.
class MapServerFile {
  public:
    explicit MapServerFile(const std::filesystem::path& path) : path_(path) {
        const std::string text = input::read_text(path, input::kLargestSettings);
        std::string_view rest = input::without_mark(text);
        std::uint64_t number = 0;
        Entry* last = nullptr;
        while (const auto line = input::next_line(rest)) {
            ++number;
            const std::string_view content = without_comment(*line);
            if (content.empty() || content == "---" || content == "..." || content[0] == '%') {
                continue;
            }
            if (last != nullptr && !last->value.empty() && last->value.front() == '[' &&
                last->value.back() != ']') {
                last->value.append(" ").append(content);
            } else if (last != nullptr && content.starts_with("- ")) {
                const bool first = last->value.empty();
                if (!first) last->value.back() = ',';
                last->value.append(first ? "[" : " ").append(input::trimmed(content.substr(2)));
                last->value += ']';
            } else if (content.front() == '{' && content.back() == '}') {
                take_braces(content.substr(1, content.size() - 2), number);
            } else {
                last = &take_entry(content, number);
            }
        }
    }

    /// Where the image lies elsewhere than the file says.
    Message note;

    const Entry* find(const std::string& key) const {
        const auto found = entries_.find(key);
        return found == entries_.end() ? nullptr : &found->second;
    }

    const Entry& need(const std::string& key, const char* expected) const {
        if (const Entry* entry = find(key)) return *entry;
        throw FormatError(
            path_.string(), 0,
            HITOS_TEXT("Errors",
                       "has no %1; expected a line %1: %2, as in the YAML files of map_server"),
            key, expected);
    }

    [[noreturn]] void refuse(const std::string& key, const Entry& entry,
                             std::string_view expected) const {
        throw FormatError(path_.string(), entry.line,
                          HITOS_TEXT("Errors", "%1: found %2, expected %3"), key,
                          input::in_quotes(entry.value), expected);
    }

    double number(const std::string& key, double otherwise, double least, double greatest) const {
        const Entry* entry = find(key);
        if (entry == nullptr) return otherwise;
        const auto value = input::parse_number(input::unquoted(entry->value));
        if (!value || !(*value >= least && *value <= greatest))
            refuse(key, *entry, fmt::format("{:g} to {:g}", least, greatest));
        return *value;
    }

    Pose origin() const {
        constexpr double kFarthest = 1e6;  // m
        const Entry& entry = need("origin", "[x, y, yaw]");
        std::string_view list = entry.value;
        std::array<double, 3> values{};
        bool good = list.size() > 2 && list.front() == '[' && list.back() == ']';
        if (good) list = list.substr(1, list.size() - 2);
        for (std::size_t i = 0; good && i < values.size(); ++i) {
            const std::size_t comma = list.find(',');
            const auto value =
                input::parse_number(input::unquoted(input::trimmed(list.substr(0, comma))));
            good = value && std::abs(*value) <= kFarthest &&
                   (comma == std::string_view::npos) == (i + 1 == values.size());
            if (!good) break;
            values[i] = *value;
            list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
        }
        if (!good) refuse("origin", entry, "[x, y, yaw] in metres and radians");
        if (std::abs(values[2]) > 2.0 * kPi) {
            throw FormatError(
                path_.string(), entry.line,
                HITOS_TEXT("Errors",
                           "origin: found a yaw of %1, which is more than a turn in radians; if "
                           "it is in degrees, write %2"),
                values[2], fmt::format("{:.6g}", values[2] * (kPi / 180.0)));
        }
        return {values[0], values[1], wrap_angle(values[2])};
    }

    bool flag(const std::string& key) const {
        const Entry* entry = find(key);
        if (entry == nullptr) return false;
        std::string word(input::unquoted(entry->value));
        std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
        if (word == "true" || word == "yes" || word == "on") return true;
        if (word == "false" || word == "no" || word == "off") return false;
        return number(key, 0, 0, 1) != 0.0;
    }

    std::filesystem::path image() {
        const Entry& entry = need("image", "PICTURE");
        const std::string name(input::unquoted(entry.value));
        if (name.empty()) refuse("image", entry, "the name of a picture");
        std::filesystem::path said = path_.parent_path() / name;
        // The machine that saved the map has other folders, and perhaps another system.
        const std::size_t behind = name.find_last_of("/\\") + 1;
        std::filesystem::path beside = path_.parent_path() / name.substr(behind);
        std::error_code error;
        if (std::filesystem::exists(said, error)) return said;
        if (!std::filesystem::is_regular_file(beside, error)) {
            refuse("image", entry, "the name of a picture that is there");
        }
        if (behind == 0) return said;
        note =
            message(HITOS_TEXT("Errors",
                               "the picture is the file of that name beside %1, as there is no %2"),
                    path_.filename().string(), name);
        return beside;
    }

  private:
    Entry& take_entry(std::string_view content, std::uint64_t number) {
        const std::size_t colon = content.find(':');
        if (colon == std::string_view::npos) {
            throw FormatError(
                path_.string(), number,
                HITOS_TEXT("Errors",
                           "found %1, expected key: value, as in the YAML files of map_server"),
                input::in_quotes(content));
        }
        const std::string_view key = input::unquoted(input::trimmed(content.substr(0, colon)));
        Entry& entry = entries_[std::string(key)];
        if (entry.line > 0) {
            throw FormatError(
                path_.string(), number,
                HITOS_TEXT("Errors", "%1 stands in line %2 already; leave one of them out"),
                input::in_quotes(key), entry.line);
        }
        entry = {std::string(input::trimmed(content.substr(colon + 1))), number};
        return entry;
    }

    void take_braces(std::string_view content, std::uint64_t number) {
        int depth = 0;
        std::size_t begin = 0;
        for (std::size_t at = 0; at <= content.size(); ++at) {
            const char c = at < content.size() ? content[at] : ',';
            depth += (c == '[') - (c == ']');
            if (c != ',' || (depth > 0 && at < content.size())) continue;
            const auto entry = input::trimmed(content.substr(begin, at - begin));
            if (!entry.empty()) take_entry(entry, number);
            begin = at + 1;
        }
    }

    std::filesystem::path path_;
    std::map<std::string, Entry> entries_;
};

template <class Occupied>
OccupancyPicture occupancy(const MeanPicture& mean, Occupied&& occupied) {
    const Grid::Picture& picture = mean.grey;
    OccupancyPicture result;
    result.columns = picture.width;
    result.rows = picture.height;
    result.occupied.reserve(picture.grey.size());
    for (std::size_t i = 0; i < picture.grey.size(); ++i) {
        const double alpha = mean.alpha.empty() ? kOpaque : mean.alpha[i];
        const auto grey = static_cast<double>(picture.grey[i]);
        // What nobody sees is no wall, whatever its colour.
        result.occupied.push_back(alpha > 0.0 && occupied(grey, alpha) ? 1 : 0);
    }
    return result;
}

}  // namespace

OccupancyPicture read_map_server(const std::filesystem::path& yaml) {
    MapServerFile file(yaml);
    file.need("resolution", "METRES");
    const double resolution = file.number("resolution", 0, kLeastResolution, kGreatestResolution);
    const Pose origin = file.origin();
    const bool negate = file.flag("negate");
    const double from = file.number("occupied_thresh", kOccupiedFrom, 0, 1);
    const double below = file.number("free_thresh", kFreeBelow, 0, 1);
    const Entry* const occupied_said = file.find("occupied_thresh");
    const Entry* const free_said = file.find("free_thresh");
    if (occupied_said != nullptr && free_said != nullptr && from <= below) {
        throw FormatError(yaml.string(), occupied_said->line,
                          HITOS_TEXT("Errors",
                                     "occupied_thresh: found %1, expected more than free_thresh, "
                                     "which is %2 in line %3; are they the wrong way round?"),
                          from, below, free_said->line);
    }
    std::string mode = "trinary";
    if (const Entry* said = file.find("mode")) {
        mode = input::unquoted(said->value);
        if (mode != "trinary" && mode != "scale" && mode != "raw") {
            file.refuse("mode", *said, "trinary, scale or raw");
        }
    }
    const std::filesystem::path image = file.image();
    const MeanPicture mean = read_mean_picture(image);
    const bool has_alpha = !mean.alpha.empty();
    const auto is_wall = [&](double pixel, double alpha) {
        if (mode == "raw") return pixel <= 100.0 && pixel / 100.0 > from;
        // Any transparency says "unknown" in mode scale; else map_server takes it for a colour.
        if (mode == "scale" && alpha < kOpaque) return false;
        if (mode == "trinary" && has_alpha) pixel = (3.0 * pixel + alpha) / 4.0;
        return (negate ? pixel : 255.0 - pixel) / 255.0 > from;
    };
    OccupancyPicture picture = occupancy(mean, is_wall);
    if (mode != "raw") {  // which knows no negate
        const auto is_free = [&](double pixel, double alpha, bool negated) {
            if (mode == "scale" && alpha < kOpaque) return false;
            if (mode == "trinary" && has_alpha) pixel = (3.0 * pixel + alpha) / 4.0;
            return (negated ? pixel : 255.0 - pixel) / 255.0 < below;
        };
        const auto free = [&](bool negated) {
            return occupancy(mean, [&](double pixel,
                                       double alpha) { return is_free(pixel, alpha, negated); })
                .occupied;
        };
        picture.free = free(negate);
        picture.free_otherwise = free(!negate);
        const Entry* const said = file.find("negate");
        picture.negate_line = said == nullptr ? 0 : said->line;
        picture.negate = negate;
    }
    picture.note = file.note;
    picture.resolution_m = resolution;
    picture.origin = origin;
    return picture;
}

Message doubt_of_negate(const OccupancyPicture& picture, const Point2& start) {
    constexpr double kHardlyAny = 0.02;  // shares of the picture
    constexpr double kPlenty = 0.1;
    if (picture.free.empty()) return {};
    const auto share = [&](const std::vector<std::uint8_t>& of) {
        return static_cast<double>(std::ranges::count(of, 1)) / static_cast<double>(of.size());
    };
    const double now = share(picture.free);
    const double otherwise = share(picture.free_otherwise);
    if (otherwise <= now || otherwise < kPlenty) return {};
    const Point2 inside = transform(inverse(picture.origin), start);
    const double column = std::floor(inside.x / picture.resolution_m);
    const double row = picture.rows - 1.0 - std::floor(inside.y / picture.resolution_m);
    bool on_it = false;  // and only otherwise on free ground
    if (column >= 0.0 && column < picture.columns && row >= 0.0 && row < picture.rows) {
        const std::size_t cell =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.columns) +
            static_cast<std::size_t>(column);
        on_it = picture.free[cell] == 0 && picture.free_otherwise[cell] != 0;
    }
    if (!on_it && now >= kHardlyAny) return {};
    const auto percent = [](double of) { return fmt::format("{:.0f} %", 100.0 * of); };
    const int other = picture.negate ? 0 : 1;
    if (picture.negate_line == 0) {
        return message(HITOS_TEXT("Errors",
                                  "the file has no negate, which may be wrong: by it %1 of the "
                                  "picture is free ground, with negate: %2 it would be %3"),
                       percent(now), other, percent(otherwise));
    }
    return message(HITOS_TEXT("Errors",
                              "negate in line %1 may be the wrong way round: by it %2 of the "
                              "picture is free ground, with negate: %3 it would be %4"),
                   picture.negate_line, percent(now), other, percent(otherwise));
}

OccupancyPicture read_wall_picture(const std::filesystem::path& path, double resolution_m) {
    if (!(resolution_m >= kLeastResolution && resolution_m <= kGreatestResolution)) {
        throw ConfigError("resolution", HITOS_TEXT("Errors", "found %1, expected %2"), resolution_m,
                          fmt::format("{:g} to {:g} m", kLeastResolution, kGreatestResolution));
    }
    OccupancyPicture picture = occupancy(read_mean_picture(path), [](double pixel, double) {
        return (255.0 - pixel) / 255.0 > kOccupiedFrom;
    });
    picture.resolution_m = resolution_m;
    return picture;
}

}  // namespace hitos
