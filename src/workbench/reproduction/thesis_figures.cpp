#include "hitos/workbench/thesis_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr std::string_view kHeader = "figure,map,parameter,value,error_m,error_variance,landmarks";
constexpr std::size_t kColumns = 7;

/// The table's numbers for the robot are standard deviations: only so read do they give the
/// thesis's errors.
std::vector<std::string_view> with_always(std::vector<std::string_view> settings,
                                          std::initializer_list<std::string_view> more) {
    // Infinite Neff: the particles are resampled after every scan.
    for (const std::string_view same : {"resampling.rule=always", "motion.model=odometry"})
        settings.push_back(same);
    settings.insert(settings.end(), more);
    return settings;
}

std::vector<ThesisTable> make_tables() {
    const std::initializer_list<std::string_view> slow{
        "motion.sigma_x=0.007", "motion.sigma_y=0.007", "motion.sigma_theta=0.008"};
    const std::initializer_list<std::string_view> fast{"motion.sigma_x=0.01", "motion.sigma_y=0.01",
                                                       "motion.sigma_theta=0.008"};
    constexpr std::string_view kP0 = "association.p0=0.005";
    constexpr std::string_view kParticles = "filter.particles=100";
    constexpr std::string_view kNine = "split_merge.min_points=9";
    constexpr std::string_view kFifteen = "split_merge.min_points=15";
    constexpr std::string_view kDmax = "split_merge.dmax=0.02";
    constexpr std::string_view kLength = "split_merge.min_length=0.4";
    constexpr std::string_view kRho = "observation.var_rho=0.04";
    constexpr std::string_view kTheta = "observation.var_theta=0.00122";
    return {
        {"dmax", "split_merge.dmax", "m", "10.2", "10.4.1",
         with_always({kP0, kParticles, kNine, kLength, kRho, kTheta}, slow)},
        {"mlon", "split_merge.min_length", "m", "10.4", "10.4.2",
         with_always({kP0, kParticles, kFifteen, kDmax, kRho, kTheta}, fast)},
        {"mpuntos", "split_merge.min_points", "", "10.6", "10.4.3",
         with_always({kP0, kParticles, kLength, kDmax, kRho, kTheta}, fast)},
        {"es", "features.corner_distance", "m", "10.10", "10.4.5",
         with_always({kP0, kParticles, kNine, kDmax, kLength, kRho, kTheta}, slow)},
        {"sensor_rho", "observation.var_rho", "m^2", "10.12", "10.5.2",
         with_always({kP0, kParticles, kNine, kDmax, kLength, "observation.var_theta=0.001224"},
                     slow)},
        {"sensor_theta", "observation.var_theta", "rad^2", "10.12", "10.5.2",
         with_always({kP0, kParticles, kNine, kDmax, kLength, "observation.var_rho=0.08"}, slow)},
        {"p0", "association.p0", "", "10.16", "10.6.2",
         with_always({kParticles, kNine, kDmax, kLength, kRho, kTheta}, slow)},
        {"p", "filter.particles", "", "10.17", "10.6.3",
         with_always({kP0, kNine, kDmax, kLength, kRho, kTheta}, fast)},
    };
}

/// What the text says of a parameter, for one world or (no world) for all of them.
struct StatedRange {
    std::string_view parameter;
    std::string_view world;
    WorkingRange range;
};
constexpr std::array kRanges{
    // 10.4.1, world by world.
    StatedRange{"dmax", "recinto", {0.005, 0.05}},
    StatedRange{"dmax", "lineamedia", {0.01, 0.02}},
    StatedRange{"dmax", "bigloop", {0.01, 0.05}},
    StatedRange{"dmax", "bigloop2", {0.005, 0.05}},
    StatedRange{"dmax", "complex", {0.01, 0.03}},
    // 10.4.2 ends with this range for all worlds, and 10.4.6 repeats it.
    StatedRange{"mlon", "", {0.5, 2.0}},
    // 10.4.3: from 9 in every world; an upper end only for two of them.
    StatedRange{"mpuntos", "bigloop", {9, 25}},
    StatedRange{"mpuntos", "complex", {9, 20}},
    StatedRange{"mpuntos", "", {9, 30}},
    // 10.4.5: low values do not touch the error.
    StatedRange{"es", "", {0.001, 1.0}},
    // 10.5.2 names both.
    StatedRange{"sensor_rho", "", {0.001, 0.08}},
    StatedRange{"sensor_theta", "", {0.0008, 0.001224}},
    // 10.6.2 ends with this range.
    StatedRange{"p0", "", {0.001, 1.0}},
    // 10.6.3: where error and number settle, 100 but for recinto and bigloop.
    StatedRange{"p", "lineamedia", {100, 500}},
    StatedRange{"p", "bigloop2", {100, 500}},
    StatedRange{"p", "complex", {100, 500}},
    StatedRange{"p", "", {50, 500}},
};

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

std::string ThesisFigure::stem() const {
    return fmt::format("{}-{}-{}", name.substr(0, name.find('/')), world, table->parameter);
}

std::span<const ThesisTable> thesis_tables() {
    static const std::vector<ThesisTable> tables = make_tables();
    return tables;
}

const ThesisTable& find_thesis_table(std::string_view parameter) {
    for (const ThesisTable& table : thesis_tables()) {
        if (table.parameter == parameter) return table;
    }
    throw ConfigError(std::string(parameter),
                      HITOS_TEXT("Errors", "the thesis has no table for this parameter"));
}

WorkingRange working_range(std::string_view parameter, std::string_view world) {
    for (const StatedRange& stated : kRanges) {
        if (stated.parameter == parameter && (stated.world.empty() || stated.world == world)) {
            return stated.range;
        }
    }
    throw ConfigError(std::string(parameter),
                      HITOS_TEXT("Errors", "the thesis says no range for world '%1'"), world);
}

Configuracion thesis_configuration(const ThesisTable& table) {
    Configuracion configuration;
    for (const std::string_view setting : table.settings) set_parameter(configuration, setting);
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
