// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of small text files share.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hitos::input {

inline constexpr std::size_t kLargestText = std::size_t{1} << 30;
/// Of what people write by hand: configurations, worlds; and of a study's records.
inline constexpr std::size_t kLargestSettings = std::size_t{1} << 24;

/// The whole content of a file, plain or gzip, without a byte order mark, its lines ended by "\n"
/// where a lone "\r" ended them. Throws FileError where it is missing, no regular file (a device
/// may have no end), unreadable, damaged or greater than `largest` bytes, FormatError where it is
/// UTF-16.
std::string read_text(const std::filesystem::path& path, std::size_t largest = kLargestText);

/// The text without white space at both ends.
std::string_view trimmed(std::string_view text);

/// The text without a pair of quotes, double or single, around it.
std::string_view unquoted(std::string_view text);

/// What some editors write before the first line.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
/// The text without it.
std::string_view without_mark(std::string_view text);

/// The words between white space.
std::vector<std::string_view> fields(std::string_view text);

/// The words between commas, trimmed, without empty ones.
std::vector<std::string_view> listed(std::string_view text);

/// Cuts the next line, without its end, off the front of `rest`; nothing where `rest` is empty.
std::optional<std::string_view> next_line(std::string_view& rest);

/// The number that is the whole text, infinities and NaN among them; nothing for other text and for
/// numbers beyond the range of a double.
std::optional<double> parse_number(std::string_view text);

/// The whole number, of digits alone, that is the whole text; nothing for other text and beyond 64
/// bits.
std::optional<std::uint64_t> parse_whole(std::string_view text);

/// Whether the word is a number but for a comma in the place of its point, as programs write it
/// under the settings of many languages.
bool has_decimal_comma(std::string_view word);

/// What was found, for messages: in quotes, control characters escaped, long text cut.
std::string in_quotes(std::string_view text);

/// Where a line of a text file is, for messages.
struct Place {
    const std::string& file;
    std::uint64_t line;
};

/// Beyond it a number of metres, radians or seconds is a mistake, and sums and squares of it would
/// be none.
inline constexpr double kGreatestNumber = 1e12;

/// The finite number that the word is. Throws FormatError that names the column, also where it is
/// greater than `greatest`, whatever its sign.
double finite_number(std::string_view word, std::string_view column, const Place& place,
                     double greatest = kGreatestNumber);

/// Throws FormatError where a line has another number of fields than columns.
void require_columns(std::size_t found, std::span<const std::string_view> columns,
                     const Place& place);

/// The finite numbers of a line that has exactly these columns. Throws FormatError.
template <std::size_t N>
std::array<double, N> finite_numbers(std::string_view line,
                                     const std::array<std::string_view, N>& columns,
                                     const Place& place) {
    const std::vector<std::string_view> words = fields(line);
    require_columns(words.size(), columns, place);
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) values[i] = finite_number(words[i], columns[i], place);
    return values;
}

}  // namespace hitos::input
