// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a text file, in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "byte_stream.hpp"
#include "hitos/base/message.hpp"

namespace hitos {

/// Hands out one line after the other; LF ends a line, blanks around it are trimmed (so is the CR
/// of CRLF). A line that is too long, or no text, comes as damage. Where compressed data end
/// early, the whole lines come first and then one last piece of damage.
class LineReader {
  public:
    struct Line {
        std::string_view text;     ///< valid until the next call; empty where damaged
        std::uint64_t number = 0;  ///< 1-based
        Message damage;            ///< what is wrong with the line; empty: nothing
        bool too_long = false;     ///< that is what is wrong
    };

    explicit LineReader(const std::filesystem::path& path, FileExtent extent = {})
        : bytes_(path, std::move(extent)) {}
    std::optional<Line> next();

    const ByteStream& bytes() const { return bytes_; }
    /// Bytes of text handed out or skipped so far.
    std::uint64_t consumed() const { return consumed_; }

  private:
    bool fill();
    Line make_line(std::string_view raw);
    std::optional<Line> skip_long_line();
    std::optional<Line> last_line();

    ByteStream bytes_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;    // of the line under way
    std::size_t scanned_ = 0;  // no LF before it
    std::size_t end_ = 0;
    std::uint64_t number_ = 0;
    std::uint64_t consumed_ = 0;
    bool told_damage_ = false;
};

}  // namespace hitos
