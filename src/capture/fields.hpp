// The blank-separated fields of one line, and the numbers in them.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "hitos/base/message.hpp"
#include "hitos/capture/fuente.hpp"

namespace hitos {

/// Greater magnitudes are damage: no coordinate in metres, stamp in seconds or angle has them, and
/// beyond them a millisecond no longer moves a stamp.
inline constexpr double kGreatestValue = 1e12;

/// A whole field as a floating-point number, "nan" and "inf" included; independent of the locale.
inline std::optional<double> parse_double(std::string_view field) {
    if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
    double value = 0.0;
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

/// A whole field as a decimal integer; leading zeros do not make it octal.
inline std::optional<std::int64_t> parse_integer(std::string_view field) {
    if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
    std::int64_t value = 0;
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

/// Walks over a line's fields. Each taker names the field, and words among the
/// names are marked by HITOS_TEXT; what is missing or wrong throws FormatError with that name, what
/// was found and what was expected.
class Fields {
  public:
    explicit Fields(std::string_view text, std::uint64_t line = 0) : rest_(text), line_(line) {
        skip_blanks();
    }
    explicit Fields(const RawLine& line) : Fields(line.text, line.number) {}

    bool at_end() const { return rest_.empty(); }
    /// How many fields are left; walks over them.
    std::size_t remaining() const;
    std::string_view peek() const { return rest_.substr(0, word_length()); }
    /// The line from the next field on.
    std::string_view rest() const { return rest_; }

    std::string_view word(const char* name) {
        if (rest_.empty()) fail_missing(name);
        return take();
    }
    /// The next field, or nothing (empty) at the end.
    std::string_view take() {
        const std::string_view field = rest_.substr(0, word_length());
        rest_.remove_prefix(field.size());
        skip_blanks();
        return field;
    }
    /// A finite number of believable size.
    double number(const char* name) {
        const std::string_view field = word(name);
        const std::optional<double> value = parse_double(field);
        if (!value) fail(name, field, HITOS_TEXT("Errors", "a number"));
        if (!(std::abs(*value) <= kGreatestValue)) {
            fail(name, field, HITOS_TEXT("Errors", "a finite number below 1e12"));
        }
        return *value;
    }
    /// A number that may be anything, NaN and infinities included.
    double reading(const char* name) {
        const std::string_view field = word(name);
        const std::optional<double> value = parse_double(field);
        if (!value) fail(name, field, HITOS_TEXT("Errors", "a number"));
        // No sensor measures so far; what is not finite is no point.
        constexpr double kFar = std::numeric_limits<double>::infinity();
        return std::abs(*value) > kGreatestValue ? std::copysign(kFar, *value) : *value;
    }
    std::int64_t integer(const char* name) {
        const std::string_view field = word(name);
        const std::optional<std::int64_t> value = parse_integer(field);
        if (!value) fail(name, field, HITOS_TEXT("Errors", "a whole number"));
        return *value;
    }
    /// How many readings follow: at least `least`.
    std::uint32_t count(const char* name, std::int64_t least = 1);
    /// Throws where fields are left over.
    void expect_end(const char* after) const;
    [[noreturn]] void fail(const char* name, std::string_view found, const char* expected) const;
    [[noreturn]] void fail(const Message& problem) const;

  private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    std::size_t word_length() const {
        std::size_t length = 0;
        while (length < rest_.size() && !is_blank(rest_[length])) ++length;
        return length;
    }
    void skip_blanks() {
        std::size_t blanks = 0;
        while (blanks < rest_.size() && is_blank(rest_[blanks])) ++blanks;
        rest_.remove_prefix(blanks);
    }
    [[noreturn]] void fail_missing(const char* name) const;

    std::string_view rest_;
    std::uint64_t line_ = 0;
};

}  // namespace hitos
