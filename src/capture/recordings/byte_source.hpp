// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes that are read once, from front to back, and parts of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "regular_file.hpp"

namespace hitos {

class ByteSource {
  public:
    virtual ~ByteSource() = default;
    /// Fills `out` and returns how many bytes it gave; fewer than asked for only at the end.
    virtual std::size_t read(std::span<char> out) = 0;
    /// Passes over so many bytes and returns how many there were.
    virtual std::uint64_t skip(std::uint64_t count);
};

/// A file. What is passed over is not read from the disk.
class FileBytes final : public ByteSource {
  public:
    explicit FileBytes(RegularFile file);

    std::size_t read(std::span<char> out) override;
    std::uint64_t skip(std::uint64_t count) override;
    /// The next byte that is read is this one, which there is.
    void go_to(std::uint64_t position);
    /// How many bytes were read or passed over.
    std::uint64_t position() const { return position_; }
    std::uint64_t size() const { return file_.size(); }
    const FileExtent& extent() const { return file_.extent(); }
    /// What stands there, wherever the next read() begins; fewer bytes where there are fewer.
    std::size_t read_at(std::uint64_t offset, std::span<char> out) const {
        return file_.read_at(offset, out);
    }
    /// The last bytes, likewise.
    std::size_t read_end(std::span<char> out) const {
        return file_.read_at(size() - std::min<std::uint64_t>(size(), out.size()), out);
    }

  private:
    RegularFile file_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::uint64_t position_ = 0;
};

/// At most so many of the next bytes of another source, which must live longer.
class Section final : public ByteSource {
  public:
    Section(ByteSource& whole, std::uint64_t length) : whole_(whole), left_(length) {}

    std::size_t read(std::span<char> out) override;
    std::uint64_t skip(std::uint64_t count) override;
    std::uint64_t left() const { return left_; }
    /// No more than so many bytes are left.
    void shorten(std::uint64_t left) { left_ = std::min(left_, left); }
    /// So many are left, wherever the source was sent to.
    void set_left(std::uint64_t left) { left_ = left; }

    /// The next section of so many bytes. Throws FormatError where fewer are left.
    Section section(std::uint64_t length);

    // The takers throw FormatError where the bytes end before.
    void take(std::span<char> out);
    std::uint8_t take_u8() { return static_cast<std::uint8_t>(take_little_endian(1)); }
    std::uint16_t take_u16() { return static_cast<std::uint16_t>(take_little_endian(2)); }
    std::uint32_t take_u32() { return static_cast<std::uint32_t>(take_little_endian(4)); }
    std::uint64_t take_u64() { return take_little_endian(8); }
    /// So many bytes; also where they are more than `most`, FormatError.
    std::string take_text(std::uint64_t length, std::uint64_t most);
    /// Passes over what is left. Throws where the source has less.
    void finish();

  private:
    std::uint64_t take_little_endian(std::size_t bytes);

    ByteSource& whole_;
    std::uint64_t left_;
};

}  // namespace hitos
