// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/map_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/mrclam.hpp"

namespace hitos {
namespace {

constexpr const char* kExpectedFeature = HITOS_TEXT(
    "Errors", "expected \"rho: <metres> theta: <degrees>\" or \"x: <metres> y: <metres>\"");

double radians(double degrees) {
    return degrees * (kPi / 180.0);
}

std::int32_t identity_of(double number, const input::Place& place) {
    constexpr double kMost = std::numeric_limits<std::int32_t>::max();
    if (number < 0.0 || number > kMost || number != std::floor(number)) {
        throw FormatError(
            place.file, place.line,
            HITOS_TEXT("Errors", "identity: found %1, expected a whole number from 0"),
            fmt::format("{}", number));
    }
    return static_cast<std::int32_t>(number);
}

/// Reads one line of a map, from its left to its right.
class LineParser {
  public:
    LineParser(std::string_view line, const std::string& name, std::uint64_t number)
        : line_(line), rest_(line), name_(name), number_(number) {}

    ICaracteristica feature() {
        ICaracteristica landmark;
        const std::string first = key();
        if (first == "rho") {
            const double rho = value("rho");
            if (key() != "theta") fail_line();
            landmark.value = line_from(rho, value("theta"));
        } else if (first == "x") {
            const double x = value("x");
            if (key() != "y") fail_line();
            const double y = value("y");
            landmark.value = Esquina{x, y};
            if (rest_.find(':') != std::string_view::npos) landmark.identity = identity();
        } else {
            fail_line();
        }
        if (!input::trimmed(rest_).empty()) {
            fail(message(
                HITOS_TEXT("Errors", "found %1 after the feature; expected the end of the line"),
                input::in_quotes(input::trimmed(rest_))));
        }
        return landmark;
    }

  private:
    std::int32_t identity() {
        if (key() != "identity") fail_line();
        return identity_of(value("identity"), {name_, number_});
    }

    /// In degrees every step to the normal form is exact.
    static Recta line_from(double rho, double degrees) {
        if (rho < 0.0) degrees = std::remainder(degrees, 360.0) + 180.0;
        degrees = std::remainder(degrees, 360.0);
        if (degrees <= -180.0) degrees = 180.0;
        return {std::abs(rho), radians(degrees)};
    }

    /// The word before the next colon, in lower case.
    std::string key() {
        const std::size_t colon = rest_.find(':');
        if (colon == std::string_view::npos) fail_line();
        std::string word(input::trimmed(rest_.substr(0, colon)));
        for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        rest_.remove_prefix(colon + 1);
        return word;
    }

    double value(std::string_view what) {
        rest_ = input::trimmed(rest_);
        const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\v\f"));
        const double number = input::finite_number(word, what, {name_, number_});
        rest_.remove_prefix(word.size());
        return number;
    }

    [[noreturn]] void fail_line() const {
        fail(message(HITOS_TEXT("Errors", "found %1; %2"), input::in_quotes(input::trimmed(line_)),
                     marked(kExpectedFeature)));
    }
    [[noreturn]] void fail(const Message& problem) const {
        throw FormatError(name_, number_, problem);
    }

    std::string_view line_;
    std::string_view rest_;
    const std::string& name_;
    std::uint64_t number_;
};

/// The shortest decimal number of degrees that reads back to the angle, so that a file of round
/// degrees stays one; the nearest double where none does.
double degrees_that_read_back(double theta_rad) {
    constexpr int kDigitsOfDouble = 17;
    const double nearest = theta_rad * (180.0 / kPi);
    for (int digits = 1; digits <= kDigitsOfDouble; ++digits) {
        std::array<char, 32> buffer{};
        const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), nearest,
                                           std::chars_format::scientific, digits - 1);
        double degrees = 0.0;
        std::from_chars(buffer.data(), written.ptr, degrees);
        if (radians(degrees) == theta_rad) return degrees;
    }
    return nearest;
}

std::string feature_text(const ICaracteristica& landmark) {
    if (const auto* recta = std::get_if<Recta>(&landmark.value)) {
        return fmt::format("rho: {} theta: {}\n", without_sign_of_zero(recta->rho),
                           without_sign_of_zero(degrees_that_read_back(recta->theta)));
    }
    const auto& esquina = std::get<Esquina>(landmark.value);
    const std::string identity =
        landmark.identity < 0 ? "" : fmt::format(" identity: {}", landmark.identity);
    return fmt::format("x: {} y: {}{}\n", without_sign_of_zero(esquina.x),
                       without_sign_of_zero(esquina.y), identity);
}

LandmarkMap parse_lines(std::string_view text, const std::string& name) {
    LandmarkMap map;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(line->substr(0, line->find('#')));
        if (!content.empty()) map.push_back(LineParser(content, name, number).feature());
    }
    return map;
}

/// The marks of Landmark_Groundtruth.dat, which says how sure their places are too.
LandmarkMap parse_mrclam_marks(std::string_view text, const std::string& name) {
    constexpr std::array<std::string_view, 5> kColumns = {"subject", "x", "y", "x std-dev",
                                                          "y std-dev"};
    LandmarkMap map;
    for (const auto& [values, line] : mrclam_rows(text, kColumns, name)) {
        ICaracteristica& mark = map.emplace_back();
        mark.value = Esquina{values[1], values[2]};
        mark.identity = identity_of(values[0], {name, line});
    }
    return map;
}

}  // namespace

LandmarkMap read_map(const std::filesystem::path& path) {
    return parse_map(input::read_text(path), path.string());
}

LandmarkMap parse_map(std::string_view text, const std::string& name) {
    LandmarkMap map = is_of_mrclam(text) ? parse_mrclam_marks(text, name) : parse_lines(text, name);
    if (map.empty()) {
        throw FormatError(name, 0, HITOS_TEXT("Errors", "no landmark in the file; %1"),
                          marked(kExpectedFeature));
    }
    return map;
}

std::string map_to_text(const LandmarkMap& map) {
    for (std::size_t i = 0; i < map.size(); ++i) {
        const auto* recta = std::get_if<Recta>(&map[i].value);
        const auto* esquina = std::get_if<Esquina>(&map[i].value);
        const auto [first, second] = recta != nullptr ? std::pair(recta->rho, recta->theta)
                                                      : std::pair(esquina->x, esquina->y);
        if (!std::isfinite(first) || !std::isfinite(second)) {
            const Message kind = recta != nullptr ? message(HITOS_TEXT("Errors", "line"))
                                                  : message(HITOS_TEXT("Errors", "corner"));
            throw Error(message(
                HITOS_TEXT(
                    "Errors",
                    "landmark %1 of the map, a %2 (%3, %4), is not finite and cannot be written"),
                i, kind, first, second));
        }
    }
    std::string text;
    for (const FeatureKind kind : {FeatureKind::line, FeatureKind::corner}) {
        for (const ICaracteristica& landmark : map) {
            if (landmark.kind() == kind) text += feature_text(landmark);
        }
    }
    return text;
}

void write_map(const LandmarkMap& map, const std::filesystem::path& path) {
    write_file(path, map_to_text(map));
}

}  // namespace hitos
