// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/file_growth.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "hitos/base/translatable.hpp"
#include "regular_file.hpp"

namespace hitos {
namespace {

/// Where the system tells of no change, as of a network's folder.
constexpr int kLookMilliseconds = 20;
/// More are thinned out: they then tell the time of every other piece.
constexpr std::size_t kMostArrivals = std::size_t{1} << 16;

}  // namespace

FileGrowth::FileGrowth(const std::filesystem::path& file) : path_(file) {
    before_ = size_ = RegularFile(file).size();
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) {
        throw FileError(file.string(), HITOS_TEXT("Errors", "cannot be opened for reading: %1"),
                        system_message(errno));
    }
    over_ = ::eventfd(0, EFD_CLOEXEC);
    events_ = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    if (events_ >= 0 && ::inotify_add_watch(events_, file.c_str(), IN_MODIFY) < 0) {
        ::close(events_);
        events_ = -1;
    }
    watch_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

FileGrowth::~FileGrowth() {
    end();
    watch_.request_stop();
    if (over_ >= 0) ::eventfd_write(over_, 1);
    watch_.join();
    if (over_ >= 0) ::close(over_);
    if (events_ >= 0) ::close(events_);
    ::close(descriptor_);
}

void FileGrowth::watch(const std::stop_token& stop) {
    std::array<char, 4096> told{};
    while (!stop.stop_requested()) {
        // Without descriptors it waits alone.
        std::array<pollfd, 2> events{pollfd{events_, POLLIN, 0}, pollfd{over_, POLLIN, 0}};
        ::poll(events.data(), events.size(), kLookMilliseconds);
        while (events_ >= 0 && ::read(events_, told.data(), told.size()) > 0) {
        }
        const std::scoped_lock lock(mutex_);
        look();
    }
}

void FileGrowth::look() {
    struct stat status {};
    if (ended_ || ::fstat(descriptor_, &status) != 0) return;
    struct stat named {};
    const bool there = ::stat(path_.c_str(), &named) == 0;
    const bool same = there && named.st_dev == status.st_dev && named.st_ino == status.st_ino;
    if (!same && !problem_) {
        problem_ = FileError(path_.string(),
                             HITOS_TEXT("Errors",
                                        "has been renamed, removed or replaced while it was "
                                        "followed; what was opened first is what counts, and is "
                                        "not under this name any more"));
    }
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size == size_) return;
    if (size < size_) {
        problem_ = FileError(path_.string(),
                             HITOS_TEXT("Errors",
                                        "has become shorter while it was followed, from %1 to %2 "
                                        "bytes; what it had before that is what counts"),
                             size_, size);
        ended_ = true;
        size_ = size;
        more_.notify_all();
        return;
    }
    size_ = size;
    if (arrivals_.size() == kMostArrivals) {
        std::size_t kept = 0;
        for (std::size_t i = 1; i < arrivals_.size(); i += 2) arrivals_[kept++] = arrivals_[i];
        arrivals_.resize(kept);
    }
    arrivals_.push_back({size, Clock::now()});
    more_.notify_all();
}

bool FileGrowth::wait_beyond(std::uint64_t bytes) const {
    std::unique_lock lock(mutex_);
    while (size_ <= bytes && !ended_) {
        const std::uint64_t nudges = nudges_;
        const auto work = meanwhile_.find(std::this_thread::get_id());
        if (work != meanwhile_.end()) {
            lock.unlock();
            work->second();  // only this thread takes it away
            lock.lock();
        }
        more_.wait(lock, [&] { return size_ > bytes || ended_ || nudges_ != nudges; });
    }
    return size_ > bytes;
}

FileGrowth::Meanwhile::Meanwhile(FileGrowth& growth, std::function<void()> work) : growth_(growth) {
    const std::scoped_lock lock(growth_.mutex_);
    growth_.meanwhile_.insert_or_assign(std::this_thread::get_id(), std::move(work));
}

FileGrowth::Meanwhile::~Meanwhile() {
    const std::scoped_lock lock(growth_.mutex_);
    growth_.meanwhile_.erase(std::this_thread::get_id());
}

void FileGrowth::nudge() {
    const std::scoped_lock lock(mutex_);
    ++nudges_;
    more_.notify_all();
}

void FileGrowth::end() {
    const std::scoped_lock lock(mutex_);
    look();
    ended_ = true;
    more_.notify_all();
}

bool FileGrowth::ended() const {
    const std::scoped_lock lock(mutex_);
    return ended_;
}

std::uint64_t FileGrowth::size() const {
    const std::scoped_lock lock(mutex_);
    return size_;
}

std::optional<FileError> FileGrowth::problem() const {
    const std::scoped_lock lock(mutex_);
    return problem_;
}

void FileGrowth::note_taken(std::uint64_t bytes) {
    const std::scoped_lock lock(mutex_);
    taken_ = std::max(taken_, bytes);
    passed_ = std::max(passed_, bytes);
    while (!arrivals_.empty() && arrivals_.front().bytes < taken_) arrivals_.pop_front();
}

std::optional<FileGrowth::Clock::time_point> FileGrowth::taken_came() const {
    const std::scoped_lock lock(mutex_);
    if (taken_ <= before_ || arrivals_.empty()) return std::nullopt;
    return arrivals_.front().at;
}

std::uint64_t FileGrowth::waiting() const {
    const std::scoped_lock lock(mutex_);
    return size_ - std::min(size_, passed_);
}

void FileGrowth::note_passed(std::uint64_t bytes) {
    const std::scoped_lock lock(mutex_);
    passed_ = std::max(passed_, bytes);
}

}  // namespace hitos
