// SPDX-License-Identifier: GPL-3.0-or-later
// The file that keeps what comes in.
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <span>

namespace hitos {

/// It grows from the first moment on, so that readers can follow it. One that was there already
/// stands beside it as NAME.before until its owner says that what came is worth more.
class ReceivedFile {
  public:
    /// Throws FileError where the file is there already, unless it is to be replaced, where another
    /// program receives into it, or it cannot be made.
    ReceivedFile(std::filesystem::path file, bool replace);
    /// Where nothing has come the file goes again, and what was there before is back.
    ~ReceivedFile();
    ReceivedFile(const ReceivedFile&) = delete;
    ReceivedFile& operator=(const ReceivedFile&) = delete;

    const std::filesystem::path& path() const { return file_; }
    /// `of_worth`: it is to be kept, as more than what describes what comes. Throws FileError.
    void append(std::span<const char> bytes, bool of_worth);
    /// Something has come that is worth to be kept.
    bool holds_something() const { return something_; }
    /// What has come is worth more than what was there before, which goes.
    void replace();
    /// What was there before, as long as it stands beside; else empty.
    std::filesystem::path former() const;
    /// What the destructor does, at once; whether what was there before is back.
    bool give_back();

  private:
    bool is_at_its_name() const;

    std::filesystem::path file_;
    mutable std::mutex mutex_;
    std::filesystem::path before_;  ///< where it is meanwhile; empty where there is none
    std::atomic<bool> something_ = false;
    bool given_back_ = false;
    int descriptor_ = -1;
};

}  // namespace hitos
