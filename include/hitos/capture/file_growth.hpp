// SPDX-License-Identifier: GPL-3.0-or-later
// A log that is read while it is being written.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "hitos/base/error.hpp"

namespace hitos {

/// Watches a file that grows, and knows when which of its bytes came. Any number of readers may
/// wait for more at the same time.
class FileGrowth {
  public:
    using Clock = std::chrono::steady_clock;

    /// Watches from now on. Throws FileError where the path is missing, no regular file, or cannot
    /// be opened.
    explicit FileGrowth(const std::filesystem::path& file);
    ~FileGrowth();
    FileGrowth(const FileGrowth&) = delete;
    FileGrowth& operator=(const FileGrowth&) = delete;

    /// Waits until the file has more than so many bytes; false where it is over and has not.
    bool wait_beyond(std::uint64_t bytes) const;
    /// What the thread that makes it does while it waits for more: before it does, and whenever it
    /// is nudged. Ends with the object, which must not outlive the growth.
    class Meanwhile {
      public:
        Meanwhile(FileGrowth& growth, std::function<void()> work);
        ~Meanwhile();
        Meanwhile(const Meanwhile&) = delete;
        Meanwhile& operator=(const Meanwhile&) = delete;

      private:
        FileGrowth& growth_;
    };
    /// There is something to do for threads that wait.
    void nudge();
    /// No more is waited for: the file is what it has now.
    void end();
    bool ended() const;
    /// How many bytes it has; once it is over, those with which it ended, whatever comes later.
    std::uint64_t size() const;
    /// Why what was read is not what is there: it became shorter, or its name leads elsewhere.
    /// Nothing where all is well.
    std::optional<FileError> problem() const;

    /// A reader is about to hand out a scan, which ends with that byte.
    void note_taken(std::uint64_t bytes);
    /// A reader has come so far, whatever it found there.
    void note_passed(std::uint64_t bytes);
    /// When the last byte of that scan came; nothing before the first, and where it was in the file
    /// already.
    std::optional<Clock::time_point> taken_came() const;
    /// How many bytes wait for a reader.
    std::uint64_t waiting() const;

  private:
    struct Arrival {
        std::uint64_t bytes = 0;  ///< that the file had then
        Clock::time_point at;
    };
    void watch(const std::stop_token& stop);
    void look();  // with the mutex held

    std::filesystem::path path_;
    int descriptor_ = -1;
    int events_ = -1;  // of the system, which tells of changes; -1 where it does not
    int over_ = -1;    // tells the watch that it is over
    std::uint64_t before_ = 0;
    mutable std::mutex mutex_;
    mutable std::condition_variable more_;
    std::uint64_t size_ = 0;
    std::uint64_t taken_ = 0;
    std::uint64_t passed_ = 0;
    bool ended_ = false;
    std::optional<FileError> problem_;
    std::map<std::thread::id, std::function<void()>> meanwhile_;
    std::uint64_t nudges_ = 0;
    std::deque<Arrival> arrivals_;  // of what is not taken yet, and the one before
    std::jthread watch_;            // last: it uses everything above
};

}  // namespace hitos
