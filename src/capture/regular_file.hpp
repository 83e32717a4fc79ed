// SPDX-License-Identifier: GPL-3.0-or-later
// A regular file, read by its descriptor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace hitos {

class RegularFile {
  public:
    /// Throws FileError where the path is missing, no regular file, or cannot be opened.
    explicit RegularFile(const std::filesystem::path& path);
    /// One that is open already, to be told of by that path.
    RegularFile(int descriptor, std::uint64_t size, std::filesystem::path path);
    ~RegularFile();
    RegularFile(RegularFile&& other) noexcept;
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    /// As it was when the file was opened.
    std::uint64_t size() const { return size_; }
    /// What the medium gives at once, 0 at the end. Throws FileError where it fails.
    std::size_t read(std::span<char> out);
    /// What stands at that byte, wherever the next read() begins; less only at the end.
    std::size_t read_at(std::uint64_t offset, std::span<char> out) const;
    /// The next read begins at that byte.
    void seek(std::uint64_t offset);

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace hitos
