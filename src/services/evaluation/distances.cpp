// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/distances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/text_table.hpp"

namespace hitos {
namespace {

constexpr double kLineAway = 0.5;       // m, of a line from its point
constexpr double kLineAwayShare = 0.5;  // of the distance, likewise
constexpr const char* kExpectedDistance =
    HITOS_TEXT("Errors", "expected 5 fields, name x1 y1 x2 y2");
constexpr const char* kExpectedName =
    HITOS_TEXT("Errors", "expected a word without commas and quotes");

NamedDistance distance_from(std::string_view line, const std::string& file, std::uint64_t number) {
    const std::vector<std::string_view> words = input::fields(line);
    if (words.size() != 5) {
        throw FormatError(file, number, HITOS_TEXT("Errors", "found %1 fields; %2"), words.size(),
                          marked(kExpectedDistance));
    }
    if (!is_distance_name(words[0])) {
        throw FormatError(file, number, HITOS_TEXT("Errors", "the name is %1; %2"),
                          input::in_quotes(words[0]), marked(kExpectedName));
    }
    constexpr std::array<std::string_view, 4> kColumns = {"x1", "y1", "x2", "y2"};
    std::array<double, kColumns.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = input::finite_number(words[i + 1], kColumns[i], {file, number});
    }
    NamedDistance distance{std::string(words[0]), {values[0], values[1]}, {values[2], values[3]}};
    if (!(distance.true_m() >= kLeastDistance)) {
        throw FormatError(file, number,
                          HITOS_TEXT("Errors",
                                     "the two points of %1 are %2 m apart; expected points on two "
                                     "walls, at least %3 m apart"),
                          distance.name, distance.true_m(), kLeastDistance);
    }
    return distance;
}

double away(const Recta& line, const Point2& point) {
    return std::abs(signed_distance(line, point));
}

MeasuredDistance measure(const LandmarkMap& map, const NamedDistance& distance) {
    MeasuredDistance measured{distance, {}, -1, -1, {}};
    const double across = std::atan2(distance.b.y - distance.a.y, distance.b.x - distance.a.x);
    const double greatest = std::min(kLineAway, kLineAwayShare * distance.true_m());
    measured.line_a = nearest_line(map, distance.a, across, greatest);
    measured.line_b = nearest_line(map, distance.b, across, greatest);
    if (measured.line_a < 0 || measured.line_b < 0) {
        measured.missing = fmt::format("no line across it within {:g} m of {}", greatest,
                                       measured.line_a >= 0   ? "its second point"
                                       : measured.line_b >= 0 ? "its first point"
                                                              : "either point");
        return measured;
    }
    if (measured.line_a == measured.line_b) {
        measured.missing = "one line is nearest to both points";
        return measured;
    }
    const auto& line_a = std::get<Recta>(map[static_cast<std::size_t>(measured.line_a)].value);
    const auto& line_b = std::get<Recta>(map[static_cast<std::size_t>(measured.line_b)].value);
    measured.slam_m = (away(line_b, projected(line_a, distance.a)) +
                       away(line_a, projected(line_b, distance.b))) /
                      2.0;
    return measured;
}

/// The line's place in the map file, where lines stand before corners; empty for none.
std::string place(int number) {
    return number < 0 ? "" : std::to_string(number + 1);
}

}  // namespace

bool is_distance_name(std::string_view name) {
    return !name.empty() && input::fields(name).size() == 1 && input::trimmed(name) == name &&
           name.find_first_of(",\"#") == std::string_view::npos;
}

int nearest_line(const LandmarkMap& map, const Point2& point, double normal_rad,
                 double greatest_m) {
    const Recta across = normalized({0.0, normal_rad});  // only its direction counts
    int nearest = -1;
    double least = greatest_m;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const auto* line = std::get_if<Recta>(&map[i].value);
        if (line == nullptr || !(difference(*line, across).theta <= kGreatestTurn)) continue;
        const double distance = away(*line, point);
        if (!(distance <= least)) continue;
        least = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

Point2 projected(const Recta& line, const Point2& point) {
    const double d = signed_distance(line, point);
    return {point.x - d * std::cos(line.theta), point.y - d * std::sin(line.theta)};
}

double NamedDistance::true_m() const {
    return std::hypot(b.x - a.x, b.y - a.y);
}

std::optional<double> MeasuredDistance::error_m() const {
    if (!slam_m) return std::nullopt;
    return *slam_m - distance.true_m();
}

std::optional<double> MeasuredDistance::error_percent() const {
    const std::optional<double> error = error_m();
    if (!error) return std::nullopt;
    return 100.0 * std::abs(*error) / distance.true_m();
}

std::vector<NamedDistance> read_distances(const std::filesystem::path& path) {
    return parse_distances(input::read_text(path), path.string());
}

std::vector<NamedDistance> parse_distances(std::string_view text, const std::string& name) {
    std::vector<NamedDistance> distances;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(line->substr(0, line->find('#')));
        if (content.empty()) continue;
        NamedDistance distance = distance_from(content, name, number);
        if (std::ranges::find(distances, distance.name, &NamedDistance::name) != distances.end()) {
            throw FormatError(
                name, number,
                HITOS_TEXT("Errors", "%1 stands twice in the file; expected each name once"),
                input::in_quotes(distance.name));
        }
        distances.push_back(std::move(distance));
    }
    if (distances.empty()) {
        throw FormatError(name, 0, HITOS_TEXT("Errors", "no distance in the file; %1"),
                          marked(kExpectedDistance));
    }
    return distances;
}

std::string distances_text(std::span<const NamedDistance> distances) {
    if (distances.empty()) {
        throw Error(
            message(HITOS_TEXT("Errors", "there is no distance between two walls to write")));
    }
    std::string text = "# name x1 y1 x2 y2: a point on each of two parallel walls [m]\n";
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const auto& [name, a, b] = distances[i];
        if (!is_distance_name(name)) {
            throw Error(message(HITOS_TEXT("Errors", "a distance is named %1; %2"),
                                input::in_quotes(name), marked(kExpectedName)));
        }
        if (std::ranges::find(distances.first(i), name, &NamedDistance::name) !=
            distances.begin() + static_cast<std::ptrdiff_t>(i)) {
            throw Error(
                message(HITOS_TEXT("Errors", "two distances are named %1; expected each name once"),
                        input::in_quotes(name)));
        }
        if (!(distances[i].true_m() >= kLeastDistance)) {
            throw Error(message(
                HITOS_TEXT("Errors", "the two points of %1 are %2 m apart; expected at least %3 m"),
                name, distances[i].true_m(), kLeastDistance));
        }
        text += fmt::format("{} {} {} {} {}\n", name, a.x, a.y, b.x, b.y);
    }
    return text;
}

std::vector<MeasuredDistance> measure_distances(const LandmarkMap& map,
                                                std::span<const NamedDistance> distances) {
    std::vector<MeasuredDistance> measured;
    measured.reserve(distances.size());
    for (const NamedDistance& distance : distances) measured.push_back(measure(map, distance));
    return measured;
}

std::string distance_table(std::span<const MeasuredDistance> measured) {
    std::size_t width = 8;
    for (const MeasuredDistance& row : measured) width = std::max(width, row.distance.name.size());
    std::string text = fmt::format("{:<{}}  {:>8}  {:>8}  {:>9}  {:>9}\n", "distance", width,
                                   "SLAM [m]", "true [m]", "error [m]", "error [%]");
    double sum_m = 0.0;
    double sum_percent = 0.0;
    int found = 0;
    for (const MeasuredDistance& row : measured) {
        text += fmt::format("{:<{}}  ", row.distance.name, width);
        if (!row.slam_m) {
            text += fmt::format("{:>8}  {:>8.3f}  {}\n", "-", row.distance.true_m(), row.missing);
            continue;
        }
        text += fmt::format("{:>8.3f}  {:>8.3f}  {:>9.3f}  {:>9.2f}\n", *row.slam_m,
                            row.distance.true_m(), *row.error_m(), *row.error_percent());
        sum_m += std::abs(*row.error_m());
        sum_percent += *row.error_percent();
        ++found;
    }
    if (found > 0) {
        text += fmt::format("{:<{}}  {:>8}  {:>8}  {:>9.3f}  {:>9.2f}\n", "mean |e|", width, "", "",
                            sum_m / found, sum_percent / found);
    }
    return text;
}

std::string distances_csv(std::span<const MeasuredDistance> measured) {
    std::string text = "name,true_m,slam_m,error_m,error_percent,line_a,line_b\n";
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{:.6f}", *value) : std::string();
    };
    for (const MeasuredDistance& row : measured) {
        text += csv_line({row.distance.name, number(row.distance.true_m()), number(row.slam_m),
                          number(row.error_m()), number(row.error_percent()), place(row.line_a),
                          place(row.line_b)});
    }
    return text;
}

}  // namespace hitos
