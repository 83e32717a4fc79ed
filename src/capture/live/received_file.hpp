// SPDX-License-Identifier: GPL-3.0-or-later
// The file that keeps what comes in.
#pragma once

#include <filesystem>
#include <mutex>
#include <span>

namespace hitos {

/// It grows from the first moment on, so that readers can follow it. One that was there already is
/// not lost before something has come that takes its place.
class ReceivedFile {
  public:
    /// Throws FileError where the file is there already, unless it is to be replaced, or cannot be
    /// made.
    ReceivedFile(std::filesystem::path file, bool replace);
    ~ReceivedFile();
    ReceivedFile(const ReceivedFile&) = delete;
    ReceivedFile& operator=(const ReceivedFile&) = delete;

    const std::filesystem::path& path() const { return file_; }
    /// Throws FileError.
    void append(std::span<const char> bytes);
    /// Something has come that is worth to be kept: what was there before goes.
    void keep();
    /// Nothing has: the file goes, and what was there before is back; whether there was anything.
    bool give_back();

  private:
    std::filesystem::path file_;
    std::mutex mutex_;
    std::filesystem::path before_;  ///< where it is meanwhile; empty where there was none
    bool kept_ = false;
    int descriptor_ = -1;
};

}  // namespace hitos
