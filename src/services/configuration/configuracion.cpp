#include "hitos/services/configuration/configuracion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <optional>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "parameter_table.hpp"

namespace hitos {
namespace {

/// A bound of an integer parameter. 2^63 stands for the greatest integer, which no double holds.
std::int64_t as_integer(double bound) {
    return bound >= 0x1p63 ? std::numeric_limits<std::int64_t>::max()
                           : static_cast<std::int64_t>(bound);
}

bool allows(const Parameter& parameter, double value) {
    return value >= parameter.minimum && value <= parameter.maximum;  // false for NaN
}

bool allows(const Parameter& parameter, std::int64_t value) {
    if (parameter.type == Parameter::Type::choice) {
        return value >= 0 && static_cast<std::size_t>(value) < parameter.choices.size();
    }
    return value >= as_integer(parameter.minimum) && value <= as_integer(parameter.maximum);
}

[[noreturn]] void refuse(const Parameter& parameter, std::string_view problem) {
    throw ConfigError(std::string(parameter.key),
                      fmt::format("{}; allowed: {}", problem, parameter.allowed()));
}

double real_from(const Parameter& parameter, std::string_view text) {
    const std::optional<double> value = input::parse_number(text);
    if (!value) refuse(parameter, input::in_quotes(text) + " is not a number");
    if (!allows(parameter, *value)) refuse(parameter, fmt::format("{} is out of range", text));
    return *value;
}

std::int64_t integer_from(const Parameter& parameter, std::string_view text) {
    std::string_view digits = text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    std::int64_t value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) {
        refuse(parameter, input::in_quotes(text) + " is not an integer");
    }
    if (error == std::errc::result_out_of_range || !allows(parameter, value)) {
        refuse(parameter, fmt::format("{} is out of range", text));
    }
    return value;
}

std::int64_t choice_from(const Parameter& parameter, std::string_view text) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) {
        refuse(parameter, input::in_quotes(text) + " is none of the choices");
    }
    return found - parameter.choices.begin();
}

/// Levenshtein's distance: insertions, deletions and exchanges of characters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchange = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchange, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::string_view name_in_group(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

/// The keys that the user may have meant, nearest first; a right name in a wrong group counts as
/// one slip.
std::vector<std::string_view> near_keys(std::string_view key) {
    constexpr std::size_t kMost = 3;
    constexpr std::size_t kLongestKey = 100;  // beyond it nothing is near
    std::vector<std::pair<std::size_t, std::string_view>> near;
    if (key.size() > kLongestKey) return {};
    const std::string_view name = name_in_group(key);
    for (const Parameter& parameter : parameters()) {
        const std::string_view its_name = name_in_group(parameter.key);
        const std::size_t distance =
            std::min(edit_distance(key, parameter.key), edit_distance(name, its_name) + 1);
        if (distance <= std::max<std::size_t>(2, its_name.size() / 3)) {
            near.emplace_back(distance, parameter.key);
        }
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string_view> keys;
    for (const auto& [distance, near_key] : near) {
        if (keys.size() < kMost) keys.push_back(near_key);
    }
    return keys;
}

}  // namespace

std::string Parameter::text(const Configuracion& configuration) const {
    switch (type) {
        case Type::real:
            return fmt::format("{}", get_real(configuration));
        case Type::integer:
            return fmt::format("{}", get_integer(configuration));
        case Type::choice: {
            const std::int64_t place = get_integer(configuration);
            // A value out of its enum is a bug of the code that filled the struct; check() tells.
            return allows(*this, place) ? std::string(choices[static_cast<std::size_t>(place)])
                                        : fmt::format("{}", place);
        }
        case Type::text:
            break;
    }
    return get_words(configuration);
}

void Parameter::set(Configuracion& configuration, std::string_view value) const {
    switch (type) {
        case Type::real:
            real(configuration) = real_from(*this, input::trimmed(value));
            break;
        case Type::integer:
            set_integer(configuration, integer_from(*this, input::trimmed(value)));
            break;
        case Type::choice:
            set_integer(configuration, choice_from(*this, input::trimmed(value)));
            break;
        case Type::text:
            words(configuration) = value;
            break;
    }
}

std::string Parameter::allowed() const {
    const std::string_view space = unit.empty() ? "" : " ";
    switch (type) {
        case Type::real:
            return fmt::format("{} to {}{}{}", minimum, maximum, space, unit);
        case Type::integer:
            return fmt::format("integers from {} to {}{}{}", as_integer(minimum),
                               as_integer(maximum), space, unit);
        case Type::choice:
            return fmt::format("one of {}", fmt::join(choices, ", "));
        case Type::text:
            break;
    }
    return "any text";
}

void Parameter::check(const Configuracion& configuration) const {
    const bool good =
        type == Type::text || (type == Type::real ? allows(*this, get_real(configuration))
                                                  : allows(*this, get_integer(configuration)));
    if (!good) refuse(*this, text(configuration) + " is out of range");
}

std::span<const Parameter> parameters() {
    static const std::vector<Parameter> table = make_parameter_table();
    return table;
}

const Parameter& find_parameter(std::string_view key) {
    for (const Parameter& parameter : parameters()) {
        if (parameter.key == key) return parameter;
    }
    const std::vector<std::string_view> near = near_keys(key);
    throw ConfigError(
        std::string(key),
        near.empty() ? "no such parameter; init.cfg lists all of them"
                     : fmt::format("no such parameter; did you mean {}?", fmt::join(near, " or ")));
}

void set_parameter(Configuracion& configuration, std::string_view assignment) {
    const std::size_t sign = assignment.find('=');
    if (sign == std::string_view::npos) {
        throw ConfigError(std::string(assignment), "expected key=value");
    }
    find_parameter(input::trimmed(assignment.substr(0, sign)))
        .set(configuration, assignment.substr(sign + 1));
}

void check(const Configuracion& configuration) {
    for (const Parameter& parameter : parameters()) parameter.check(configuration);

    const MotionParams& motion = configuration.filter.motion;
    if (motion.model == "no-odometry" && motion.sigma_x_m == 0.0 && motion.sigma_y_m == 0.0 &&
        motion.sigma_theta_rad == 0.0) {
        throw ConfigError("motion.model",
                          "no-odometry with motion.sigma_x, motion.sigma_y and motion.sigma_theta "
                          "all 0 can never move; give at least one of them a value above 0");
    }
    const AssociationParams& association = configuration.filter.association;
    if (configuration.filter.algorithm == "ekf-slam" &&
        association.new_probability < association.gate_probability) {
        throw ConfigError("association.new_probability",
                          fmt::format("{} is less than association.gate_probability {}; an "
                                      "observation inside that gate cannot be new",
                                      association.new_probability, association.gate_probability));
    }
    const GridParams& grid = configuration.grid;
    if (grid.log_odds_hit == 0.0 && grid.log_odds_miss == 0.0) {
        throw ConfigError("grid.hit",
                          "grid.hit and grid.miss both 0 draw nothing; give at least one of them "
                          "another value");
    }
    if (grid.max_range_m > 0.0 && grid.max_range_m < grid.resolution_m) {
        throw ConfigError("grid.max_range",
                          fmt::format("{} m is less than a cell (grid.resolution {} m); 0 draws "
                                      "rays whole",
                                      grid.max_range_m, grid.resolution_m));
    }
}

}  // namespace hitos
