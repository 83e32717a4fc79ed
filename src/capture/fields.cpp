// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields.hpp"

#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

/// A field as a message may show it: short, whatever the line holds.
std::string shown(std::string_view field) {
    constexpr std::size_t kShown = 24;
    std::string text(1, '"');
    text += field.substr(0, kShown);
    if (field.size() > kShown) text += "...";
    text += '"';
    return text;
}

}  // namespace

std::size_t Fields::remaining() const {
    Fields ahead = *this;
    std::size_t count = 0;
    while (!ahead.at_end()) {
        ahead.take();
        ++count;
    }
    return count;
}

double Fields::odd_number(const char* name) {
    const std::string_view field = word(name);
    const std::optional<double> value = parse_double(field);
    if (!value) fail(name, field, HITOS_TEXT("Errors", "a number"));
    if (!(std::abs(*value) <= kGreatestValue)) {
        const bool time = std::string_view(name).find("time") != std::string_view::npos;
        fail(name, field,
             time && std::isfinite(*value)
                 ? HITOS_TEXT("Errors", "seconds, below 1e12 (nanoseconds divided by 1e9)")
                 : HITOS_TEXT("Errors", "a finite number below 1e12"));
    }
    return *value;
}

double Fields::odd_reading(const char* name) {
    const std::string_view field = word(name);
    const std::optional<double> value = parse_double(field);
    if (!value) fail(name, field, HITOS_TEXT("Errors", "a number"));
    // No sensor measures so far; what is not finite is no point.
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return std::abs(*value) > kGreatestValue ? std::copysign(kFar, *value) : *value;
}

std::uint32_t Fields::count(const char* name, std::int64_t least) {
    const std::string_view field = word(name);
    const std::optional<std::int64_t> value = parse_integer(field);
    if (!value || *value < least || *value > std::numeric_limits<std::int32_t>::max()) {
        fail(name, field,
             least > 0 ? HITOS_TEXT("Errors", "a whole number from 1")
                       : HITOS_TEXT("Errors", "a whole number from 0"));
    }
    return static_cast<std::uint32_t>(*value);
}

void Fields::expect_end(const char* after) const {
    if (at_end()) return;
    fail(message(HITOS_TEXT("Errors", "found %1 after %2, expected the end of the line"),
                 shown(peek()), marked(after)));
}

void Fields::fail(const char* name, std::string_view found, const char* expected) const {
    const char* wanted = input::has_decimal_comma(found)
                             ? HITOS_TEXT("Errors", "a decimal point, not a comma")
                             : expected;
    fail(message(HITOS_TEXT("Errors", "%1: found %2, expected %3"), marked(name), shown(found),
                 marked(wanted)));
}

void Fields::fail(const Message& problem) const {
    throw FormatError("", line_, problem);
}

void Fields::fail_missing(const char* name) const {
    fail(message(HITOS_TEXT("Errors", "%1: found the end of the line, expected a value"),
                 marked(name)));
}

}  // namespace hitos
