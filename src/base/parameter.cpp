// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/parameter.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <numeric>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

using Type = ParameterFacts::Type;

/// A bound of an integer parameter. 2^63 stands for the greatest integer, which no double holds.
std::int64_t as_integer(double bound) {
    return bound >= 0x1p63 ? std::numeric_limits<std::int64_t>::max()
                           : static_cast<std::int64_t>(bound);
}

[[noreturn]] void refuse(const ParameterFacts& parameter, const Message& problem) {
    throw ConfigError(std::string(parameter.key), HITOS_TEXT("Errors", "%1; allowed: %2"), problem,
                      parameter.allowed_message());
}

Message out_of_range(std::string_view text) {
    return message(HITOS_TEXT("Errors", "%1 is out of range"), text);
}

Message none_of_the_choices(std::string_view word) {
    return message(HITOS_TEXT("Errors", "%1 is none of the choices"), input::in_quotes(word));
}

double real_from(const ParameterFacts& parameter, std::string_view text) {
    const std::optional<double> value = input::parse_number(text);
    if (!value) {
        refuse(parameter,
               message(HITOS_TEXT("Errors", "%1 is not a number"), input::in_quotes(text)));
    }
    if (!parameter.allows(*value)) refuse(parameter, out_of_range(text));
    return *value;
}

std::int64_t integer_from(const ParameterFacts& parameter, std::string_view text) {
    std::string_view digits = text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    std::int64_t value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) {
        refuse(parameter,
               message(HITOS_TEXT("Errors", "%1 is not an integer"), input::in_quotes(text)));
    }
    if (error == std::errc::result_out_of_range || !parameter.allows(value)) {
        refuse(parameter, out_of_range(text));
    }
    return value;
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

std::string_view name_in_table(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

}  // namespace

ParameterFacts declare::facts_of(const WordFacts& facts, ParameterFacts::Type type,
                                 std::vector<ParameterChoice> choices) {
    return {.key = facts.key,
            .label = facts.label,
            .description = facts.description,
            .card = facts.card,
            .choices = std::move(choices),
            .type = type};
}

std::vector<ParameterChoice> declare::off_on() {
    return {{"off", HITOS_TEXT("ParameterChoice", "Off")},
            {"on", HITOS_TEXT("ParameterChoice", "On")}};
}

std::optional<std::size_t> ParameterFacts::place_of(std::string_view word) const {
    const auto found = std::ranges::find(choices, word, &ParameterChoice::word);
    if (found == choices.end()) return std::nullopt;
    return static_cast<std::size_t>(found - choices.begin());
}

Message ParameterFacts::allowed_message() const {
    const std::string ending = unit.empty() ? "" : fmt::format(" {}", unit);
    switch (type) {
        case Type::real:
            return message(HITOS_TEXT("Errors", "%1 to %2%3"), minimum, maximum, ending);
        case Type::integer:
            return message(HITOS_TEXT("Errors", "integers from %1 to %2%3"), as_integer(minimum),
                           as_integer(maximum), ending);
        case Type::choice: {
            std::vector<std::string_view> words;
            for (const ParameterChoice& choice : choices) words.emplace_back(choice.word);
            return message(HITOS_TEXT("Errors", "one of %1"),
                           parameter_detail::joined(words, ", "));
        }
        case Type::text:
            break;
    }
    return message(HITOS_TEXT("Errors", "any text"));
}

std::string ParameterFacts::allowed() const {
    return allowed_message().english();
}

bool ParameterFacts::allows(const Value& value) const {
    switch (type) {
        case Type::real: {
            const double number = std::get<double>(value);
            return number >= minimum && number <= maximum;  // false for NaN
        }
        case Type::integer: {
            const std::int64_t number = std::get<std::int64_t>(value);
            return number >= as_integer(minimum) && number <= as_integer(maximum);
        }
        case Type::choice:
            return place_of(std::get<std::string>(value)).has_value();
        case Type::text:
            break;
    }
    return true;
}

std::string ParameterFacts::text_of(const Value& value) const {
    return std::visit([](const auto& content) { return fmt::format("{}", content); }, value);
}

ParameterFacts::Value ParameterFacts::value_from(std::string_view text) const {
    const std::string_view word = input::trimmed(text);
    switch (type) {
        case Type::real:
            return real_from(*this, word);
        case Type::integer:
            return integer_from(*this, word);
        case Type::choice:
            if (!place_of(word)) refuse(*this, none_of_the_choices(word));
            return std::string(word);
        case Type::text:
            break;
    }
    return std::string(text);
}

void ParameterFacts::check_value(const Value& value) const {
    if (allows(value)) return;
    if (type == Type::choice) {
        refuse(*this, none_of_the_choices(text_of(value)));
    }
    refuse(*this, out_of_range(text_of(value)));
}

namespace parameter_detail {

std::string joined(std::span<const std::string_view> words, std::string_view last) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) list += i + 1 == words.size() ? last : std::string_view(", ");
        list += words[i];
    }
    return list;
}

/// The keys that the user may have meant, nearest first; a right name in a wrong table counts as
/// one slip.
std::vector<std::string_view> near_keys(std::string_view key,
                                        std::span<const std::string_view> keys) {
    constexpr std::size_t kMost = 3;
    constexpr std::size_t kLongestKey = 100;  // beyond it nothing is near
    std::vector<std::pair<std::size_t, std::string_view>> near;
    if (key.size() > kLongestKey) return {};
    const std::string_view name = name_in_table(key);
    for (const std::string_view known : keys) {
        const std::string_view its_name = name_in_table(known);
        const std::size_t distance =
            std::min(edit_distance(key, known), edit_distance(name, its_name) + 1);
        if (distance <= std::max<std::size_t>(2, its_name.size() / 3)) {
            near.emplace_back(distance, known);
        }
    }
    std::ranges::stable_sort(near, {}, &std::pair<std::size_t, std::string_view>::first);
    std::vector<std::string_view> nearest;
    for (const auto& [distance, known] : near) {
        if (nearest.size() < kMost) nearest.push_back(known);
    }
    return nearest;
}

void refuse_key(std::string_view key, std::span<const std::string_view> near,
                const Message& otherwise) {
    Message list;
    for (const std::string_view known : near) {
        list = list.empty() ? verbatim(std::string(known))
                            : message(HITOS_TEXT("Errors", "%1 or %2"), list, known);
    }
    throw ConfigError(
        std::string(key),
        near.empty() ? message(HITOS_TEXT("Errors", "no such parameter; %1"), otherwise)
                     : message(HITOS_TEXT("Errors", "no such parameter; did you mean %1?"), list));
}

}  // namespace parameter_detail
}  // namespace hitos
