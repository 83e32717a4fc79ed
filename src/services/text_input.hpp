// What the readers of small text files share.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hitos::input {

/// The whole content of a file, plain or gzip. Throws FileError where it is missing, a directory,
/// unreadable, damaged, or greater than kLargestText.
std::string read_text(const std::filesystem::path& path);
inline constexpr std::size_t kLargestText = std::size_t{1} << 30;

/// The text without white space at both ends.
std::string_view trimmed(std::string_view text);

/// The words between white space.
std::vector<std::string_view> fields(std::string_view text);

/// Cuts the next line, without its end, off the front of `rest`; nothing where `rest` is empty.
std::optional<std::string_view> next_line(std::string_view& rest);

/// The number that is the whole text, infinities and NaN among them; nothing for other text and for
/// numbers beyond the range of a double.
std::optional<double> parse_number(std::string_view text);

/// What was found, for messages: in quotes, control characters escaped, long text cut.
std::string in_quotes(std::string_view text);

}  // namespace hitos::input
