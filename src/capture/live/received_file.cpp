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

/// Who receives into a file holds it for itself alone.
bool is_locked(const std::filesystem::path& file) {
    const int there = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (there < 0) return false;
    const bool locked = ::flock(there, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(there);
    return locked;
}

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
    const auto open = [&] {
        descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                             S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
        if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX | LOCK_NB);
        return descriptor_ >= 0;
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
    if (is_locked(file_)) {
        throw FileError(file_.string(),
                        HITOS_TEXT("Errors",
                                   "is being received into by another run; name another file, or "
                                   "end that one first"));
    }
    std::error_code failed;
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

void ReceivedFile::append(std::span<const char> bytes) {
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
    return !failed;
}

}  // namespace hitos
