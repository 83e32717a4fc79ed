#include "hitos/services/maps/occupancy_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/maps/picture_file.hpp"
#include "map_server_file.hpp"

namespace hitos {
namespace {

constexpr double kLeastResolution = 1e-4;  // m
constexpr double kGreatestResolution = 10.0;
constexpr std::size_t kMostPixels = 100'000'000;

struct Entry {
    std::string value;
    std::uint64_t line = 0;
};

/// The lines `key: value` that map_server's files are made of.
class MapServerFile {
  public:
    explicit MapServerFile(const std::filesystem::path& path) : path_(path) {
        const std::string text = input::read_text(path, input::kLargestSettings);
        std::string_view rest = text;
        std::uint64_t number = 0;
        while (const auto line = input::next_line(rest)) {
            ++number;
            const std::string_view content = without_comment(*line);
            if (content.empty() || content == "---" || content == "...") continue;
            const std::size_t colon = content.find(':');
            if (colon == std::string_view::npos) {
                throw FormatError(
                    path.string(), number,
                    message(HITOS_TEXT("Errors",
                                       "found %1, expected key: value, as in the YAML files of "
                                       "map_server"),
                            input::in_quotes(content)));
            }
            entries_[std::string(input::trimmed(content.substr(0, colon)))] = {
                std::string(input::trimmed(content.substr(colon + 1))), number};
        }
    }

    const Entry* find(const std::string& key) const {
        const auto found = entries_.find(key);
        return found == entries_.end() ? nullptr : &found->second;
    }

    const Entry& need(const std::string& key, const char* expected) const {
        if (const Entry* entry = find(key)) return *entry;
        throw FormatError(path_.string(), 0,
                          message(HITOS_TEXT("Errors",
                                             "has no %1; expected a line %1: %2, as in "
                                             "the YAML files of map_server"),
                                  key, expected));
    }

    [[noreturn]] void refuse(const std::string& key, const Entry& entry,
                             std::string_view expected) const {
        throw FormatError(path_.string(), entry.line,
                          message(HITOS_TEXT("Errors", "%1: found %2, expected %3"), key,
                                  input::in_quotes(entry.value), expected));
    }

    double number(const std::string& key, double otherwise, double least, double greatest) const {
        const Entry* entry = find(key);
        if (entry == nullptr) return otherwise;
        const auto value = input::parse_number(entry->value);
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
            const auto value = input::parse_number(input::trimmed(list.substr(0, comma)));
            good = value && std::abs(*value) <= kFarthest &&
                   (comma == std::string_view::npos) == (i + 1 == values.size());
            if (!good) break;
            values[i] = *value;
            list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
        }
        if (!good) refuse("origin", entry, "[x, y, yaw] in metres and radians");
        return {values[0], values[1], wrap_angle(values[2])};
    }

    std::filesystem::path image() const {
        const Entry& entry = need("image", "PICTURE");
        std::string_view name = entry.value;
        if (name.size() >= 2 && (name.front() == '"' || name.front() == '\'') &&
            name.back() == name.front())
            name = name.substr(1, name.size() - 2);
        if (name.empty()) refuse("image", entry, "the name of a picture");
        return path_.parent_path() / name;
    }

  private:
    static std::string_view without_comment(std::string_view line) {
        for (std::size_t at = line.find('#'); at != std::string_view::npos;
             at = line.find('#', at + 1)) {
            if (at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t') {
                line = line.substr(0, at);
                break;
            }
        }
        return input::trimmed(line);
    }

    std::filesystem::path path_;
    std::map<std::string, Entry> entries_;
};

template <class Occupied>
OccupancyPicture occupancy(const std::filesystem::path& file, const Grid::Picture& picture,
                           Occupied&& occupied) {
    if (picture.grey.size() > kMostPixels) {
        throw FormatError(file.string(), 0,
                          message(HITOS_TEXT("Errors", "has %1 pixels; expected at most %2"),
                                  picture.grey.size(), kMostPixels));
    }
    std::array<std::uint8_t, 256> of_grey{};
    for (std::size_t grey = 0; grey < of_grey.size(); ++grey)
        of_grey[grey] = occupied(static_cast<double>(grey)) ? 1 : 0;
    OccupancyPicture result;
    result.columns = picture.width;
    result.rows = picture.height;
    result.occupied.reserve(picture.grey.size());
    for (const std::uint8_t grey : picture.grey) result.occupied.push_back(of_grey[grey]);
    return result;
}

}  // namespace

OccupancyPicture read_map_server(const std::filesystem::path& yaml) {
    const MapServerFile file(yaml);
    file.need("resolution", "METRES");
    const double resolution = file.number("resolution", 0, kLeastResolution, kGreatestResolution);
    const Pose origin = file.origin();
    const bool negate = file.number("negate", 0, 0, 1) != 0.0;
    const double from = file.number("occupied_thresh", kOccupiedFrom, 0, 1);
    file.number("free_thresh", kFreeBelow, 0, 1);
    bool raw = false;
    if (const Entry* mode = file.find("mode")) {
        raw = mode->value == "raw";
        if (!raw && mode->value != "trinary" && mode->value != "scale")
            file.refuse("mode", *mode, "trinary, scale or raw");
    }
    const std::filesystem::path image = file.image();
    OccupancyPicture picture = occupancy(image, read_grey_picture(image), [&](double pixel) {
        if (raw) return pixel <= 100.0 && pixel / 100.0 > from;
        return (negate ? pixel : 255.0 - pixel) / 255.0 > from;
    });
    picture.resolution_m = resolution;
    picture.origin = origin;
    return picture;
}

OccupancyPicture read_wall_picture(const std::filesystem::path& path, double resolution_m) {
    if (!(resolution_m >= kLeastResolution && resolution_m <= kGreatestResolution)) {
        throw ConfigError(
            "resolution",
            message(HITOS_TEXT("Errors", "found %1, expected %2"), resolution_m,
                    fmt::format("{:g} to {:g} m", kLeastResolution, kGreatestResolution)));
    }
    OccupancyPicture picture = occupancy(path, read_grey_picture(path), [](double pixel) {
        return (255.0 - pixel) / 255.0 > kOccupiedFrom;
    });
    picture.resolution_m = resolution_m;
    return picture;
}

}  // namespace hitos
