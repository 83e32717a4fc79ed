// SPDX-License-Identifier: GPL-3.0-or-later
// Files of which nothing stays.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "hitos/base/message.hpp"

namespace hitos {

/// A file for reading and writing that has no name, in the folder for temporary files (TMPDIR, else
/// /tmp): nothing of it stays, even after a kill. It leaves some of the file system to others.
class NamelessFile {
  public:
    /// What fails is told as a FileError of `shown` by `problem`: %1 is the folder, %2 the reason.
    NamelessFile(std::string shown, MessageText<2> problem);
    ~NamelessFile();
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    void write(std::span<const char> bytes);
    std::uint64_t size() const { return size_; }
    int descriptor() const { return descriptor_; }
    /// The descriptor, which from now on is the caller's to close.
    int release();

  private:
    [[noreturn]] void fail(int error) const;
    void leave_room() const;

    std::string shown_;
    MessageText<2> problem_;
    std::filesystem::path folder_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace hitos
