// SPDX-License-Identifier: GPL-3.0-or-later
// The one way in which Hitos writes files: beside the target, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hitos/base/message.hpp"

namespace hitos {

/// Collects a file's content in a file without a name, or in a temporary sibling where the file
/// system knows none; commit() flushes it to disk and renames it over the target. Destroyed without
/// commit, it leaves the target as it was and nothing beside it; without a name not even a kill
/// does. Throws FileError with the system's reason on every failure.
class AtomicFile {
  public:
    /// A path ending in .gz is compressed where `compress_gz` is set.
    explicit AtomicFile(std::filesystem::path target, bool compress_gz = false);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();

  private:
    void open_beside();
    void name_it();
    void flush();
    void discard();
    [[noreturn]] void fail(const Message& doing) const;

    std::filesystem::path target_;
    std::filesystem::path temporary_;
    std::size_t noted_ = 0;  ///< for remove_temporary_files()
    int descriptor_ = -1;
    void* gzip_ = nullptr;  // gzFile, kept out of this header
    std::string buffer_;
};

/// Removes the temporary siblings of all AtomicFiles of this process; for its end by a signal, in
/// whose handler it may be called.
void remove_temporary_files() noexcept;

/// Writes a whole small file atomically.
void write_file(const std::filesystem::path& target, std::string_view content);

}  // namespace hitos
