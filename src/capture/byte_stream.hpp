// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a file, unpacked where it is gzip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "hitos/base/message.hpp"
#include "regular_file.hpp"

namespace hitos {

/// What packed data are read by.
inline constexpr std::size_t kInputBytes = std::size_t{1} << 16;

/// Reads a regular file from its beginning. Gzip is known by its first two bytes, whatever the
/// file's name; several gzip members in a row are read as one.
class ByteStream {
  public:
    /// Throws FileError where the path is missing, no regular file, or cannot be opened.
    explicit ByteStream(const std::filesystem::path& path, FileExtent extent = {});
    ~ByteStream();
    ByteStream(const ByteStream&) = delete;
    ByteStream& operator=(const ByteStream&) = delete;

    /// Fills the front of `out` and returns how many bytes it gave; 0 only at the end. Throws
    /// FileError where the medium fails.
    std::size_t read(std::span<char> out);

    /// Why the data ended before their time, once they have; empty for a sound file.
    const Message& damage() const { return damage_; }
    bool is_gzip() const { return inflater_ != nullptr; }
    /// How much of the file on disk has been taken in, 0 … 1.
    double progress() const;

  private:
    struct Inflater;
    bool refill();
    /// What the medium gives at once, 0 at the end.
    std::size_t take(std::span<char> out);
    std::size_t read_inflated(std::span<char> out);
    bool next_member();

    RegularFile file_;
    std::uint64_t taken_ = 0;
    std::vector<char> input_;
    std::size_t input_begin_ = 0;
    std::size_t input_end_ = 0;
    std::unique_ptr<Inflater> inflater_;
    bool ended_ = false;
    Message damage_;
};

}  // namespace hitos
