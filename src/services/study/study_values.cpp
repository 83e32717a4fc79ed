// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <set>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {
namespace {

constexpr double kLongestRange = 100000.0;  // more values are a slip of the pen

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(input::trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

double range_number(std::string_view range, std::string_view word) {
    const auto number = input::parse_number(word);
    if (!number || !std::isfinite(*number)) {
        throw ConfigError(
            std::string(range),
            HITOS_TEXT("Errors",
                       "%1 is not a number; expected a range from:to:step such as 0.01:0.05:0.01"),
            input::in_quotes(word));
    }
    return *number;
}

/// Digits behind the point that the number needs as it is written, "2.5e-3" four of them.
int decimals(std::string_view word) {
    const std::size_t exponent_at = word.find_first_of("eE");
    const std::string_view mantissa = word.substr(0, exponent_at);
    const std::size_t point = mantissa.find('.');
    int count = point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    if (exponent_at != std::string_view::npos) {
        std::string_view digits = word.substr(exponent_at + 1);
        if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
        int exponent = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        count -= exponent;
    }
    return std::clamp(count, 0, 40);
}

bool is_range(const StudyParameter& parameter, std::string_view word) {
    if (parameter.keys.size() != 1 || word.find(':') == std::string_view::npos) return false;
    const ConfigParameter::Type type = find_parameter(parameter.keys.front()).type;
    return type == ConfigParameter::Type::real || type == ConfigParameter::Type::integer;
}

void append_word(StudyParameter& parameter, std::string_view word) {
    if (!is_range(parameter, word)) {
        parameter.values.push_back({std::string(word)});
        return;
    }
    for (std::string& value : expand_range(word)) parameter.values.push_back({std::move(value)});
}

/// "two values (rho, theta)" for messages.
Message components(const StudyParameter& parameter) {
    for (const ThesisParameter& thesis : thesis_parameters()) {
        if (thesis.name == parameter.name) {
            return message("%1 (%2)", parameter.keys.size(), marked(thesis.meaning));
        }
    }
    return message("%1 (%2)", parameter.keys.size(),
                   fmt::format("{}", fmt::join(parameter.keys, ", ")));
}

/// Whether an empty value means something, as of texts that may be left out.
bool may_be_empty(const StudyParameter& parameter) {
    if (parameter.keys.size() != 1) return false;
    const ConfigParameter& of = find_parameter(parameter.keys.front());
    if (of.type != ConfigParameter::Type::text) return false;
    try {
        Configuracion any;
        of.set(any, "");
        return true;
    } catch (const ConfigError&) {
        return false;
    }
}

StudyParameter from_thesis(const ThesisParameter& thesis) {
    return {std::string(thesis.name), {thesis.keys.begin(), thesis.keys.end()}, {}};
}

void set_value(Configuracion& configuration, const StudyParameter& parameter,
               const StudyValue& value) {
    for (std::size_t i = 0; i < parameter.keys.size(); ++i)
        find_parameter(parameter.keys[i]).set(configuration, value.at(i));
}

/// As check_values() has it, of one.
void check_value(Configuracion configuration, const StudyParameter& parameter,
                 const StudyValue& value, const StudyParameter* other) {
    set_value(configuration, parameter, value);
    if (other == nullptr) return check(configuration);
    std::exception_ptr reason;
    for (const StudyValue& beside : other->values) {
        try {
            Configuracion pair = configuration;
            set_value(pair, *other, beside);
            return check(pair);
        } catch (const ConfigError& error) {
            if (std::ranges::find(other->keys, error.key()) == other->keys.end())
                reason = std::current_exception();
        }
    }
    if (reason) std::rethrow_exception(reason);
}

}  // namespace

std::span<const ThesisParameter> thesis_parameters() {
    static const std::vector<ThesisParameter> table{
        {"p", {"filter.particles"}, HITOS_TEXT("Errors", "number of particles")},
        {"dmax",
         {"split_merge.dmax"},
         HITOS_TEXT("Errors", "greatest distance of a point from its line, m")},
        {"mlon", {"split_merge.min_length"}, HITOS_TEXT("Errors", "shortest line, m")},
        {"mpuntos", {"split_merge.min_points"}, HITOS_TEXT("Errors", "fewest points of a line")},
        {"sensor",
         {"observation.var_rho", "observation.var_theta"},
         HITOS_TEXT("Errors", "variance of rho in m^2, variance of theta in rad^2")},
        {"mov",
         {"motion.sigma_x", "motion.sigma_y", "motion.sigma_theta"},
         HITOS_TEXT("Errors",
                    "standard deviation of x in m, of y in m, of theta in rad; with motion.unit = "
                    "\"variance\" in the configuration the variances of the thesis's text, in m^2, "
                    "m^2, rad^2")},
        {"p0", {"association.p0"}, HITOS_TEXT("Errors", "likelihood of a new landmark")},
        {"col",
         {"split_merge.collinear_rho", "split_merge.collinear_theta"},
         HITOS_TEXT("Errors", "collinearity thresholds: rho in m, theta in rad")},
        {"es",
         {"features.corner_distance"},
         HITOS_TEXT("Errors", "greatest distance of a corner from its lines, m")}};
    return table;
}

StudyParameter find_thesis_parameter(std::string_view name) {
    std::vector<std::string_view> names;
    for (const ThesisParameter& thesis : thesis_parameters()) {
        if (thesis.name == name) return from_thesis(thesis);
        names.push_back(thesis.name);
    }
    throw ConfigError(std::string(name),
                      HITOS_TEXT("Errors", "no such parameter; expected one of %1"),
                      fmt::format("{}", fmt::join(names, ", ")));
}

StudyParameter find_study_parameter(std::string_view name) {
    for (const ThesisParameter& thesis : thesis_parameters()) {
        if (thesis.name == name) return from_thesis(thesis);
    }
    StudyParameter parameter{std::string(name), {}, {}};
    for (const std::string_view key : split(name, '+')) {
        parameter.keys.emplace_back(find_parameter(key).key);
        if (std::count(parameter.keys.begin(), parameter.keys.end(), parameter.keys.back()) > 1) {
            throw ConfigError(std::string(name), HITOS_TEXT("Errors", "names a key twice"));
        }
    }
    return parameter;
}

void set_values(StudyParameter& parameter, std::span<const std::string> words) {
    const std::size_t width = parameter.keys.size();
    if (words.empty() || words.size() % width != 0) {
        throw ConfigError(parameter.name,
                          HITOS_TEXT("Errors", "found %1 values; each run takes %2"), words.size(),
                          components(parameter));
    }
    parameter.values.clear();
    if (width == 1) {
        for (const std::string& word : words) append_word(parameter, input::trimmed(word));
        return;
    }
    for (std::size_t i = 0; i < words.size(); i += width) {
        const auto begin = words.begin() + static_cast<std::ptrdiff_t>(i);
        parameter.values.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(width));
    }
}

StudyParameter parse_study_parameter(std::string_view assignment) {
    const std::size_t sign = assignment.find('=');
    if (sign == std::string_view::npos) {
        throw ConfigError(std::string(assignment),
                          HITOS_TEXT("Errors", "expected name=value,value,… or name=from:to:step"));
    }
    StudyParameter parameter = find_study_parameter(input::trimmed(assignment.substr(0, sign)));
    for (const std::string_view word : split(assignment.substr(sign + 1), ',')) {
        if (word.empty() && !may_be_empty(parameter)) {
            throw ConfigError(parameter.name, HITOS_TEXT("Errors", "found an empty value"));
        }
        if (parameter.keys.size() == 1) {
            append_word(parameter, word);
            continue;
        }
        const std::vector<std::string_view> parts = split(word, '/');
        if (parts.size() != parameter.keys.size()) {
            throw ConfigError(
                parameter.name,
                HITOS_TEXT("Errors", "found %1 of %2 components; each run takes %3, joined by '/'"),
                input::in_quotes(word), parts.size(), components(parameter));
        }
        parameter.values.emplace_back(parts.begin(), parts.end());
    }
    return parameter;
}

void check_values(const StudyParameter& parameter) {
    std::set<StudyValue> there;
    for (const StudyValue& value : parameter.values) {
        Configuracion scratch;
        set_value(scratch, parameter, value);
        StudyValue texts;  // so that 0.020 and 2e-2 are one value
        for (const std::string& key : parameter.keys)
            texts.push_back(find_parameter(key).text(scratch));
        const std::string words = fmt::format("{}", fmt::join(texts, ", "));
        if (there.insert(std::move(texts)).second) continue;
        throw ConfigError(parameter.name, HITOS_TEXT("Errors", "the value %1 is given twice"),
                          words);
    }
}

void check_values(const Configuracion& configuration, const StudyParameter& parameter,
                  const StudyParameter* other) {
    for (const StudyValue& value : parameter.values)
        check_value(configuration, parameter, value, other);
}

void check_values(const Configuracion& configuration, std::span<const StudyParameter> parameters) {
    if (parameters.size() == 1) return check_values(configuration, parameters[0], nullptr);
    if (parameters.size() != 2) return;  // there is no such study
    check_values(configuration, parameters[0], &parameters[1]);
    check_values(configuration, parameters[1], &parameters[0]);
}

std::vector<std::string> expand_range(std::string_view range) {
    const std::vector<std::string_view> parts = split(range, ':');
    if (parts.size() != 3) {
        throw ConfigError(std::string(range),
                          HITOS_TEXT("Errors", "expected a range from:to:step"));
    }
    const double from = range_number(range, parts[0]);
    const double to = range_number(range, parts[1]);
    const double step = range_number(range, parts[2]);
    // A step that ends a rounding error short of `to` reaches it.
    constexpr double kSlack = 1e-9;
    const double steps = step == 0.0 ? -1.0 : std::floor((to - from) / step + kSlack);
    if (!(steps >= 0.0)) {
        throw ConfigError(
            std::string(range),
            HITOS_TEXT("Errors", "the step does not lead from the first to the last"));
    }
    if (steps >= kLongestRange) {
        throw ConfigError(std::string(range), HITOS_TEXT("Errors", "has more than %1 values"),
                          kLongestRange);
    }
    const int digits = std::max(decimals(parts[0]), decimals(parts[2]));
    std::vector<std::string> values;
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        values.push_back(fmt::format("{:.{}f}", from + i * step, digits));
    }
    return values;
}

}  // namespace hitos
