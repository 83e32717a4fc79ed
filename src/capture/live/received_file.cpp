// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/received_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"

namespace hitos {
namespace {

constexpr const char* kCannotBeMade =
    HITOS_TEXT("Errors", "cannot be made to keep what comes in: %1");

constexpr const char* kFormer = ".before";

/// An open file, which its program holds for itself alone.
class Held {
  public:
    explicit Held(const std::filesystem::path& file)
        : descriptor_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC)) {
        free_ =
            descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    }
    ~Held() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    /// Nobody else held it.
    bool free() const { return free_; }

  private:
    int descriptor_;
    bool free_ = true;
};

/// Beside the file, and free: what a run that was killed has left there is not lost either.
std::filesystem::path name_of_former(const std::filesystem::path& file) {
    std::filesystem::path name = file;
    name += kFormer;
    std::error_code unknown;
    for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(name, unknown)); ++i) {
        name = file;
        name += kFormer;
        name += '-';
        name += std::to_string(i);
    }
    return name;
}

}  // namespace

ReceivedFile::ReceivedFile(std::filesystem::path file, bool replace) : file_(std::move(file)) {
    const auto in_use = [this] {
        return FileError(file_.string(),
                         HITOS_TEXT("Errors",
                                    "is being received into by another run; name another file, or "
                                    "end that one first"));
    };
    const auto open = [&] {
        descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                             S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
        if (descriptor_ < 0) return false;
        // Another run may have come in between, and taken it for an old one.
        const bool held = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
        if (held && is_at_its_name()) return true;
        ::close(descriptor_);
        throw in_use();
    };
    if (open()) return;
    if (errno != EEXIST) throw FileError(file_.string(), kCannotBeMade, system_message(errno));
    before_ = name_of_former(file_);
    if (!replace) {
        std::filesystem::path before = file_;
        before += kFormer;
        throw FileError(
            file_.string(),
            before == before_
                ? message(HITOS_TEXT("Errors",
                                     "is there already, and may be what another run received; say "
                                     "--replace to receive in its place, or another name with "
                                     "--received"))
                : message(HITOS_TEXT("Errors",
                                     "is there already, of a run that was broken off; what it was "
                                     "to replace is %1. Say which of both is to stay by its name; "
                                     "--replace receives in the place of the first"),
                          before.string()));
    }
    std::error_code failed;
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file_, failed))) {
        throw FileError(file_.string(), HITOS_TEXT("Errors",
                                                   "is no file that can be replaced; name another "
                                                   "one"));
    }
    const Held former(file_);  // while it goes
    if (!former.free()) throw in_use();
    std::filesystem::rename(file_, before_, failed);
    if (failed) throw FileError(file_.string(), kCannotBeMade, failed.message());
    if (open()) return;
    const int reason = errno;
    std::filesystem::rename(before_, file_, failed);
    throw FileError(file_.string(), kCannotBeMade, system_message(reason));
}

ReceivedFile::~ReceivedFile() {
    give_back();
    ::close(descriptor_);
}

void ReceivedFile::append(std::span<const char> bytes, bool of_worth) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(descriptor_, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) {
            throw FileError(file_.string(),
                            HITOS_TEXT("Errors",
                                       "cannot keep what comes in: %1; the tour ends with what it "
                                       "has"),
                            system_message(errno));
        }
        if (of_worth && put > 0) something_ = true;  // also where the disk is full behind it
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
}

void ReceivedFile::replace() {
    const std::scoped_lock lock(mutex_);
    if (before_.empty()) return;
    std::error_code ignored;
    std::filesystem::remove(before_, ignored);
    before_.clear();
}

/// Nobody has moved it, or put another one there.
bool ReceivedFile::is_at_its_name() const {
    struct stat own {};
    struct stat named {};
    return ::fstat(descriptor_, &own) == 0 && ::stat(file_.c_str(), &named) == 0 &&
           own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

bool ReceivedFile::give_back() {
    const std::scoped_lock lock(mutex_);
    if (something_ || std::exchange(given_back_, true) || !is_at_its_name()) return false;
    std::error_code failed;
    if (before_.empty()) {
        std::filesystem::remove(file_, failed);
        return false;
    }
    std::filesystem::rename(before_, file_, failed);
    if (!failed) before_.clear();
    return !failed;
}

std::filesystem::path ReceivedFile::former() const {
    const std::scoped_lock lock(mutex_);
    return before_;
}

}  // namespace hitos
