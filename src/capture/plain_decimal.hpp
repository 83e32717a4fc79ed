// SPDX-License-Identifier: GPL-3.0-or-later
// Decimals as logs write them, eight characters at a time: what std::from_chars gives, sooner.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace hitos::plain {

// Not within the function: there they would be laid out anew for every number.
inline constexpr std::array<double, 9> kPowersOfTen = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

constexpr bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// A word of eight equal bytes.
constexpr std::uint64_t eight_of(char c) {
    return 0x0101010101010101U * static_cast<unsigned char>(c);
}

/// The eight characters from `at` on, the first in the lowest byte; behind the end are blanks.
inline std::uint64_t eight_from(const char* at, const char* end) {
    std::uint64_t word = 0;
    if (end - at >= 8) {
        std::memcpy(&word, at, sizeof word);
        return word;
    }
    std::array<char, 8> padded{' ', ' ', ' ', ' ', ' ', ' ', ' ', ' '};
    for (std::size_t i = 0; at != end; ++i) padded[i] = *at++;
    std::memcpy(&word, padded.data(), sizeof word);
    return word;
}

/// The highest bit of every byte that is ten or more.
constexpr std::uint64_t no_digits(std::uint64_t bytes) {
    constexpr std::uint64_t kLow = eight_of('\x7f');
    return (((bytes & kLow) + eight_of('\x76')) | bytes) & ~kLow;
}

/// The byte of the lowest bit; 8 where there is none.
constexpr unsigned place_of_first(std::uint64_t bits) {
    return static_cast<unsigned>(std::countr_zero(bits)) / 8;
}

/// One of eight characters less '0'.
constexpr char character(std::uint64_t bytes, unsigned place) {
    return static_cast<char>(((bytes >> (8 * place)) & 0xff) ^ '0');
}

/// The number that the first `count` bytes, 1 ... 8, are the digits of: neighbours are joined into
/// numbers of two, of four and of eight digits.
constexpr std::uint64_t joined(std::uint64_t digits, unsigned count) {
    constexpr std::uint64_t kEveryFourth = 0x000000ff000000ffU;
    digits <<= 8 * (8 - count);
    digits = digits * 10 + (digits >> 8);
    const std::uint64_t outer = (digits & kEveryFourth) * (100 + (std::uint64_t{1000000} << 32));
    const std::uint64_t inner =
        ((digits >> 16) & kEveryFourth) * (1 + (std::uint64_t{10000} << 32));
    return (outer + inner) >> 32;
}

/// A whole number below 2^53 over a power of ten below 10^23: both are exact, so that the quotient
/// is the double next to the decimal (Clinger 1990).
inline double scaled(std::uint64_t whole, unsigned decimals) {
    return static_cast<double>(whole) / kPowersOfTen[decimals];
}

/// What a field begins with. Of length 0 where it is no plain decimal; it may be a number all the
/// same.
struct Decimal {
    std::size_t length = 0;
    double value = 0.0;
};

/// Digits with a point at most among them, seven characters in all.
inline Decimal short_decimal(const char* at, const char* end) {
    const std::uint64_t bytes = eight_from(at, end) ^ eight_of('0');
    std::uint64_t others = no_digits(bytes);
    const unsigned whole = place_of_first(others);
    if (whole == 0 || whole == 8) return {};
    const char behind = character(bytes, whole);
    if (is_blank(behind)) return {whole, static_cast<double>(joined(bytes, whole))};
    others &= others - 1;
    if (behind != '.' || others == 0) return {};
    const unsigned length = place_of_first(others);
    if (!is_blank(character(bytes, length))) return {};
    const std::uint64_t before_point = (std::uint64_t{1} << (8 * whole)) - 1;
    const std::uint64_t digits = (bytes & before_point) | ((bytes >> 8) & ~before_point);
    return {length, scaled(joined(digits, length - 1), length - 1 - whole)};
}

/// A sign perhaps, up to ten digits and up to eight behind a point.
Decimal long_decimal(const char* at, const char* end);

/// The plain decimal at the front: a sign perhaps, digits, a point perhaps and more digits, of
/// ordinary length and with a blank or the end behind them. Its value is below 1e10 and to the last
/// bit what std::from_chars gives.
inline Decimal decimal(const char* at, const char* end) {
    if constexpr (std::endian::native != std::endian::little) return {};
    const Decimal found = short_decimal(at, end);
    return found.length > 0 ? found : long_decimal(at, end);
}

}  // namespace hitos::plain
