// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/thesis_figures.hpp"

#include <fmt/format.h>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

constexpr std::string_view kHeader = "figure,map,parameter,value,error_m,error_variance,landmarks";
constexpr std::size_t kColumns = 7;

/// The words between commas, empty ones too.
std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> words(1);
    for (const char c : line) {
        if (c == ',') {
            words.emplace_back();
        } else if (c != '\r') {
            words.back() += c;
        }
    }
    return words;
}

[[noreturn]] void refuse(const input::Place& place, const Message& problem) {
    throw FormatError(place.file, place.line, problem);
}

double number(const std::string& word, std::string_view column, const input::Place& place) {
    const double value = input::finite_number(word, column, place);
    if (value < 0.0)
        refuse(place, verbatim(fmt::format("{} is {}; expected 0 or more", column, word)));
    return value;
}

ThesisFigure make_figure(const std::vector<std::string>& words, const input::Place& place) {
    try {
        return {words[0],
                words[1],
                &find_thesis_table(words[2]),
                working_range(words[2], words[1]),
                {}};
    } catch (const ConfigError& error) {
        refuse(place, error.message());
    }
}

}  // namespace

std::string thesis_stem(const std::string& figure, const std::string& place,
                        const std::string& parameter) {
    return fmt::format("{}-{}-{}", figure.substr(0, figure.find('/')), place, parameter);
}

bool names_thesis(std::string_view word, const std::string& figure, const std::string& place,
                  const std::string& parameter) {
    return word == figure || word == place || word == parameter ||
           word == thesis_stem(figure, place, parameter) ||
           fmt::format("/{}/", figure).find(fmt::format("/{}/", word)) != std::string::npos;
}

std::string ThesisFigure::stem() const {
    return thesis_stem(name, world, table->parameter);
}

bool ThesisFigure::is_named(std::string_view word) const {
    return names_thesis(word, name, world, table->parameter);
}

const ThesisTable& find_thesis_table(std::string_view parameter) {
    for (const ThesisTable& table : thesis_tables()) {
        if (table.parameter == parameter) return table;
    }
    throw ConfigError(std::string(parameter),
                      HITOS_TEXT("Errors", "the thesis has no table for this parameter"));
}

WorkingRange working_range(std::string_view parameter, std::string_view world) {
    for (const auto& [stated, range] : find_thesis_table(parameter).ranges) {
        if (stated == "any" || stated == world) return range;
    }
    throw ConfigError(std::string(parameter),
                      HITOS_TEXT("Errors", "the thesis says no range for world '%1'"), world);
}

Configuracion thesis_configuration(const ThesisTable& table) {
    Configuracion configuration;
    for (const std::string& setting : table.settings) set_parameter(configuration, setting);
    return configuration;
}

std::vector<ThesisFigure> read_thesis_figures(const std::filesystem::path& path) {
    const std::string file = path.string();
    const std::string text = input::read_text(path);
    std::string_view rest = text;
    input::Place place{file, 1};
    const std::string_view header = input::next_line(rest).value_or("");
    if (split(header) != split(kHeader)) {
        refuse(place, verbatim(fmt::format("found {}, expected the header {}",
                                           input::in_quotes(header), kHeader)));
    }
    std::vector<ThesisFigure> figures;
    while (const auto line = input::next_line(rest)) {
        ++place.line;
        const std::vector<std::string> words = split(*line);
        if (words.size() != kColumns) {
            refuse(place,
                   verbatim(fmt::format("found {} columns, expected {}", words.size(), kColumns)));
        }
        if (figures.empty() || figures.back().name != words[0]) {
            figures.push_back(make_figure(words, place));
        }
        ThesisFigure& figure = figures.back();
        if (figure.world != words[1] || figure.table->parameter != words[2]) {
            refuse(place, verbatim("world or parameter changes within a figure"));
        }
        static_cast<void>(number(words[3], "value", place));
        ThesisRow& row = figure.rows.emplace_back();
        row.value = words[3];
        if (words[4] != "inf") row.error_m = number(words[4], "error_m", place);
        row.error_variance = number(words[5], "error_variance", place);
        row.landmarks = number(words[6], "landmarks", place);
    }
    return figures;
}

}  // namespace hitos
