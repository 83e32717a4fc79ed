// SPDX-License-Identifier: GPL-3.0-or-later
// A regular file, read by its descriptor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>

#include "hitos/capture/file_growth.hpp"

namespace hitos {

/// How much of a file is read.
struct FileExtent {
    /// As if it had no more bytes.
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
    /// Of a file that is being written: reading waits for more. Null: it is whole.
    std::shared_ptr<FileGrowth> growth = {};

    bool grows() const { return growth != nullptr && !growth->ended(); }
};

class RegularFile {
  public:
    /// Throws FileError where the path is missing, no regular file, or cannot be opened.
    explicit RegularFile(const std::filesystem::path& path, FileExtent extent = {});
    /// One that is open already, to be told of by that path.
    RegularFile(int descriptor, std::uint64_t size, std::filesystem::path path);
    ~RegularFile();
    RegularFile(RegularFile&& other) noexcept;
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    /// As it was when the file was opened; of one that grows, as it is.
    std::uint64_t size() const { return extent_.growth ? extent_.growth->size() : size_; }
    const FileExtent& extent() const { return extent_; }
    /// What the medium gives at once, 0 at the end; where the file grows, once there is some.
    /// Throws FileError where it fails.
    std::size_t read(std::span<char> out);
    /// What stands at that byte, wherever the next read() begins; less only at the end.
    std::size_t read_at(std::uint64_t offset, std::span<char> out) const;
    /// The next read begins at that byte.
    void seek(std::uint64_t offset);

  private:
    std::filesystem::path path_;
    FileExtent extent_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    std::uint64_t position_ = 0;
};

}  // namespace hitos
