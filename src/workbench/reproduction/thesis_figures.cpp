#include "hitos/workbench/thesis_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr std::string_view kHeader = "figure,map,parameter,value,error_m,error_variance,landmarks";
constexpr std::size_t kColumns = 7;

std::vector<std::string> split(const std::string& line) {
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

/// One line of the file at a time, each with its place for messages.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : path_(path.string()), in_(path) {
        if (!in_) throw FileError(path_, HITOS_TEXT("Errors", "cannot be read"));
    }

    bool next() {
        ++line_;
        return static_cast<bool>(std::getline(in_, text_));
    }
    const std::string& text() const { return text_; }
    [[noreturn]] void fail(const Message& problem) const {
        throw FormatError(path_, line_, problem);
    }
    double number(const std::string& word) const {
        double value = 0.0;
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (error != std::errc{} || stop != end || std::isnan(value) || value < 0.0) {
            fail(verbatim(fmt::format("found '{}', expected a number from 0 or inf", word)));
        }
        return value;
    }
    double finite(const std::string& word) const {
        const double value = number(word);
        if (!std::isfinite(value)) {
            fail(verbatim(fmt::format("found '{}', expected a finite number", word)));
        }
        return value;
    }

  private:
    std::string path_;
    std::ifstream in_;
    std::string text_;
    std::uint64_t line_ = 0;
};

ThesisFigure make_figure(const Reader& reader, const std::vector<std::string>& words) {
    try {
        return {words[0],
                words[1],
                &find_thesis_table(words[2]),
                working_range(words[2], words[1]),
                {}};
    } catch (const ConfigError& error) {
        reader.fail(error.message());
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
    Reader reader(path);
    if (!reader.next() || split(reader.text()) != split(std::string(kHeader))) {
        reader.fail(
            verbatim(fmt::format("found '{}', expected the header {}", reader.text(), kHeader)));
    }
    std::vector<ThesisFigure> figures;
    while (reader.next()) {
        const std::vector<std::string> words = split(reader.text());
        if (words.size() != kColumns) {
            reader.fail(
                verbatim(fmt::format("found {} columns, expected {}", words.size(), kColumns)));
        }
        if (figures.empty() || figures.back().name != words[0]) {
            figures.push_back(make_figure(reader, words));
        }
        ThesisFigure& figure = figures.back();
        if (figure.world != words[1] || figure.table->parameter != words[2]) {
            reader.fail(verbatim("world or parameter changes within a figure"));
        }
        static_cast<void>(reader.finite(words[3]));
        const double error = reader.number(words[4]);
        figure.rows.push_back({words[3], std::isfinite(error) ? std::optional(error) : std::nullopt,
                               reader.finite(words[5]), reader.finite(words[6])});
    }
    return figures;
}

}  // namespace hitos
