// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/text_input.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <memory>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos::input {
namespace {

constexpr std::string_view kWhite = " \t\r\n\v\f";
constexpr std::size_t kChunk = std::size_t{1} << 16;

struct GzipCloser {
    void operator()(gzFile file) const { gzclose_r(file); }
};

/// A few bytes of gzip may unpack to any number; no text that means something comes near.
constexpr std::size_t kMuch = std::size_t{1} << 26;
constexpr std::size_t kMostTimes = 64;

bool is_bomb(gzFile file, std::size_t unpacked) {
    const z_off_t packed = gzoffset(file);
    return packed > 0 && unpacked / kMostTimes > static_cast<std::size_t>(packed);
}

/// Two bytes a letter: by the mark at its beginning, or by a beginning of plain letters.
bool is_utf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    constexpr std::size_t kLetters = 8;
    if (text.size() < 2 * kLetters) return false;
    const auto plain_at = [&](std::size_t first) {
        for (std::size_t i = 0; i < 2 * kLetters; i += 2) {
            const char letter = text[i + first];
            const bool plain =
                (letter >= ' ' && letter <= '~') || kWhite.find(letter) != std::string_view::npos;
            if (!plain || text[i + 1 - first] != '\0') return false;
        }
        return true;
    };
    return plain_at(0) || plain_at(1);
}

/// As spreadsheets and editors save it: without a byte order mark, and lines of old Macs, which end
/// with CR alone, as lines. Pictures, which are read by this too, hold zeros.
std::string as_is_written(std::string text, const std::filesystem::path& path) {
    if (is_utf16(text)) {
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors", "is UTF-16 text; save it as UTF-8"));
    }
    text.erase(0, text.size() - without_mark(text).size());
    if (text.find('\n') == std::string::npos && text.find('\0') == std::string::npos)
        std::ranges::replace(text, '\r', '\n');
    return text;
}

[[noreturn]] void refuse_endless(const std::filesystem::path& path) {
    throw FileError(path.string(),
                    HITOS_TEXT("Errors", "is a device or a pipe; expected a file on a disk"));
}

}  // namespace

std::string read_text(const std::filesystem::path& path, std::size_t largest) {
    std::error_code problem;
    const auto status = std::filesystem::status(path, problem);
    if (status.type() == std::filesystem::file_type::not_found) {
        throw FileError(path.string(), HITOS_TEXT("Errors", "no such file"));
    }
    if (std::filesystem::is_directory(status)) {
        throw FileError(path.string(), HITOS_TEXT("Errors", "is a directory; expected a file"));
    }
    if (!problem && !std::filesystem::is_regular_file(status)) refuse_endless(path);
    errno = 0;
    // Some files of the kernel call themselves regular, and would wait for what is to come.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const std::unique_ptr<gzFile_s, GzipCloser> file(descriptor < 0 ? nullptr
                                                                    : gzdopen(descriptor, "rb"));
    if (!file) {
        if (descriptor >= 0) ::close(descriptor);
        throw FileError(path.string(), HITOS_TEXT("Errors", "cannot open: %1"),
                        system_message(errno));
    }
    std::string text;
    for (;;) {
        const std::size_t used = text.size();
        text.resize(used + kChunk);
        const int got = gzread(file.get(), text.data() + used, static_cast<unsigned>(kChunk));
        text.resize(used + static_cast<std::size_t>(got > 0 ? got : 0));
        if (got <= 0) break;
        if (text.size() > largest) {
            throw FileError(path.string(), HITOS_TEXT("Errors", "is greater than %1 MiB"),
                            largest >> 20U);
        }
        if (text.size() > kMuch && is_bomb(file.get(), text.size())) {
            throw FileError(path.string(),
                            HITOS_TEXT("Errors",
                                       "unpacks to more than %1 MiB, %2 times its size; expected a "
                                       "text, which packs less well"),
                            kMuch >> 20U, kMostTimes);
        }
    }
    int code = Z_OK;
    const char* reason = gzerror(file.get(), &code);
    if (code == Z_ERRNO && errno == EAGAIN) refuse_endless(path);
    if (code == Z_ERRNO) {
        throw FileError(path.string(), HITOS_TEXT("Errors", "cannot read: %1"),
                        system_message(errno));
    }
    if (code != Z_OK && code != Z_STREAM_END) {
        throw FileError(path.string(), HITOS_TEXT("Errors", "damaged gzip file: %1"), reason);
    }
    return as_is_written(std::move(text), path);
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kWhite);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kWhite) - first + 1);
}

std::string_view without_mark(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    return text;
}

std::vector<std::string_view> fields(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t at = text.find_first_not_of(kWhite); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(kWhite, at), text.size());
        words.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(kWhite, end);
    }
    return words;
}

std::string_view unquoted(std::string_view text) {
    const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                        text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string_view> listed(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        if (const auto word = trimmed(text.substr(0, comma)); !word.empty()) words.push_back(word);
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return words;
}

std::optional<std::string_view> next_line(std::string_view& rest) {
    if (rest.empty()) return std::nullopt;
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
}

std::optional<double> parse_number(std::string_view text) {
    // from_chars knows no plus sign.
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error != std::errc{}) return std::nullopt;
    return value;
}

std::optional<std::uint64_t> parse_whole(std::string_view text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error != std::errc{}) return std::nullopt;
    return value;
}

bool has_decimal_comma(std::string_view word) {
    const std::size_t comma = word.find(',');
    const auto is_digit = [&](std::size_t at) {
        return at < word.size() && word[at] >= '0' && word[at] <= '9';
    };
    if (comma == std::string_view::npos || comma == 0) return false;
    if (!is_digit(comma - 1) || !is_digit(comma + 1)) return false;
    std::string point(word);
    point[comma] = '.';
    return parse_number(point).has_value();
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::size_t length = std::min(text.size(), kLongest);
    // Not in the middle of a UTF-8 character.
    while (length > 0 && length < text.size() &&
           (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    return fmt::format("\"{}{}\"", on_one_line(text.substr(0, length)),
                       length < text.size() ? "..." : "");
}

double finite_number(std::string_view word, std::string_view column, const Place& place,
                     double greatest) {
    const std::optional<double> value = parse_number(word);
    if (value && std::abs(*value) <= greatest) return *value;
    if (value && std::isfinite(*value)) {
        throw FormatError(place.file, place.line,
                          HITOS_TEXT("Errors", "%1 is %2; expected a number from -%3 to %3"),
                          column, in_quotes(word), fmt::format("{:g}", greatest));
    }
    if (has_decimal_comma(word)) {
        throw FormatError(
            place.file, place.line,
            HITOS_TEXT("Errors", "%1 is %2, with a decimal comma; expected a decimal point"),
            column, in_quotes(word));
    }
    throw FormatError(place.file, place.line,
                      HITOS_TEXT("Errors", "%1 is %2; expected a finite number"), column,
                      in_quotes(word));
}

void require_columns(std::size_t found, std::span<const std::string_view> columns,
                     const Place& place) {
    if (found == columns.size()) return;
    throw FormatError(place.file, place.line,
                      HITOS_TEXT("Errors", "found %1 fields; expected %2 numbers, %3"), found,
                      columns.size(), fmt::format("{}", fmt::join(columns, " ")));
}

}  // namespace hitos::input
