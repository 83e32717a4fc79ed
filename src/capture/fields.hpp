// SPDX-License-Identifier: GPL-3.0-or-later
// The blank-separated fields of one line, and the numbers in them.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "hitos/base/message.hpp"
#include "hitos/capture/fuente.hpp"
#include "plain_decimal.hpp"

namespace hitos {

/// Greater magnitudes are damage: no coordinate in metres, stamp in seconds or angle has them, and
/// beyond them a millisecond no longer moves a stamp.
inline constexpr double kGreatestValue = 1e12;

/// A whole field as a floating-point number, "nan" and "inf" included; independent of the locale.
inline std::optional<double> parse_double(std::string_view field) {
    const char* end = field.data() + field.size();
    const plain::Decimal plain = plain::decimal(field.data(), end);
    if (plain.length > 0 && plain.length == field.size()) return plain.value;
    double value = 0.0;
    if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
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
    explicit Fields(std::string_view text, std::uint64_t line = 0)
        : at_(behind_blanks(text.data(), text.data() + text.size())),
          end_(text.data() + text.size()),
          line_(line) {}
    explicit Fields(const RawLine& line) : Fields(line.text, line.number) {}

    bool at_end() const { return at_ == end_; }
    /// How many fields are left; walks over them.
    std::size_t remaining() const;
    std::string_view peek() const { return {at_, word_length()}; }
    /// The line from the next field on.
    std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

    std::string_view word(const char* name) {
        if (at_end()) fail_missing(name);
        return take();
    }
    /// The next field, or nothing (empty) at the end.
    std::string_view take() {
        const std::string_view field = peek();
        pass(field.size());
        return field;
    }
    /// A finite number of believable size.
    double number(const char* name) {
        const plain::Decimal plain = plain::decimal(at_, end_);
        if (plain.length == 0) return odd_number(name);
        pass(plain.length);
        return plain.value;
    }
    /// A number that may be anything, NaN and infinities included.
    double reading(const char* name) {
        const plain::Decimal plain = plain::decimal(at_, end_);
        if (plain.length == 0) return odd_reading(name);
        pass(plain.length);
        return plain.value;
    }
    /// `count` times one reading of each name; `take` gets the place of the name and the value.
    template <std::size_t N, class Take>
    void readings(std::uint32_t count, const std::array<const char*, N>& names, Take take) {
        // In a local, since for all the compiler knows others see the member.
        const char* at = at_;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::size_t name = 0; name < N; ++name) {
                const plain::Decimal plain = plain::decimal(at, end_);
                if (plain.length > 0) {
                    at = behind_blanks(at + plain.length, end_);
                    take(name, plain.value);
                } else {
                    at_ = at;
                    take(name, odd_reading(names[name]));
                    at = at_;
                }
            }
        }
        at_ = at;
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
    double odd_number(const char* name);
    double odd_reading(const char* name);

    std::size_t word_length() const {
        const char* stop = at_;
        while (stop != end_ && !plain::is_blank(*stop)) ++stop;
        return static_cast<std::size_t>(stop - at_);
    }
    void pass(std::size_t length) { at_ = behind_blanks(at_ + length, end_); }
    static const char* behind_blanks(const char* at, const char* end) {
        while (at != end && plain::is_blank(*at)) ++at;
        return at;
    }
    [[noreturn]] void fail_missing(const char* name) const;

    const char* at_;  // the next field
    const char* end_;
    std::uint64_t line_ = 0;
};

}  // namespace hitos
