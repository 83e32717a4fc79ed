// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <climits>
#include <ctime>
#include <exception>
#include <string>
#include <thread>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// Who this is, as the other one is told.
std::string this_process() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&now, &utc);
    return fmt::format("process {} on {}, since {:%Y-%m-%d %H:%M:%S} UTC", ::getpid(), host.data(),
                       utc);
}

std::string holder(int descriptor) {
    std::array<char, 512> text{};
    const ssize_t got = ::pread(descriptor, text.data(), text.size() - 1, 0);
    return got > 0 ? std::string(text.data(), static_cast<std::size_t>(got)) : "another process";
}

/// Whether the name still leads to the file that is open: its holder before may have removed it.
bool same_file(int descriptor, const fs::path& path) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

bool is_mount_point(const fs::path& folder) {
    struct stat here {};
    struct stat above {};
    return ::stat(folder.c_str(), &here) == 0 && ::stat((folder / "..").c_str(), &above) == 0 &&
           here.st_dev != above.st_dev;
}

}  // namespace

fs::path hidden_beside(const fs::path& folder, const char* word) {
    std::error_code error;
    fs::path real = fs::weakly_canonical(folder, error);
    if (error) real = fs::absolute(folder);
    if (!real.has_filename()) real = real.parent_path();  // "results/"
    const std::string ending = std::string(".hitos-") + word;
    const fs::path parent = real.parent_path();
    const bool short_enough = real.filename().native().size() + ending.size() + 1 <= NAME_MAX;
    if (real.has_filename() && short_enough && ::access(parent.c_str(), W_OK) == 0 &&
        !is_mount_point(real)) {
        return parent / ("." + real.filename().string() + ending);
    }
    // A file cannot have it in itself.
    if (!fs::is_directory(real, error)) {
        return parent / ("." + real.filename().string() + ending);
    }
    return real / ending;
}

bool FolderLock::hold(short kind) const {
    struct flock lock {};
    lock.l_type = kind;
    lock.l_whence = SEEK_SET;
    // Another error than that somebody has it: this file system knows no locks.
    return ::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

bool FolderLock::take(const fs::path& folder, short kind) {
    for (;;) {
        descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0) {
            throw FileError(folder.string(),
                            HITOS_TEXT("Errors",
                                       "cannot be kept for this process: %1: %2; choose a folder "
                                       "that you may write to"),
                            file_.string(), system_message(errno));
        }
        ::fchmod(descriptor_, 0666);  // whoever may write here may take it over
        const bool held = hold(kind);
        // Its holder before may have removed it between the two.
        if (held && !same_file(descriptor_, file_)) {
            ::close(descriptor_);
            continue;
        }
        return held;
    }
}

void FolderLock::refuse(const fs::path& folder) const {
    const std::string who = holder(descriptor_);
    ::close(descriptor_);
    throw FileError(
        folder.string(),
        HITOS_TEXT("Errors",
                   "is being written by %1; wait until it is done, or choose another folder"),
        who);
}

void FolderLock::sign() const {
    // For people only: the lock holds without it, as where the disk or the memory is full.
    try {
        const std::string who = this_process();
        if (::ftruncate(descriptor_, 0) != 0 ||
            ::pwrite(descriptor_, who.data(), who.size(), 0) < 0) {
            return;
        }
    } catch (const std::exception&) {
        return;
    }
}

FolderLock::FolderLock(const fs::path& folder) : file_(hidden_beside(folder, "lock")) {
    if (!take(folder, F_WRLCK)) refuse(folder);
    begin();
}

FolderLock::FolderLock(const fs::path& folder, Shared) : file_(hidden_beside(folder, "lock")) {
    constexpr int kTries = 400;
    constexpr std::chrono::milliseconds kPause(50);
    alone_ = take(folder, F_WRLCK);
    // Who came first has it alone for a moment, or is at the end of its work.
    for (int i = 0; !alone_; ++i) {
        ::close(descriptor_);
        if (take(folder, F_RDLCK)) break;
        if (i == kTries) refuse(folder);
        std::this_thread::sleep_for(kPause);
        ::close(descriptor_);
        alone_ = take(folder, F_WRLCK);
    }
    begin();
}

/// It is held; without memory to note it, it is given up again.
void FolderLock::begin() {
    sign();
    try {
        at_early_end_.emplace([this] { remove(); });
    } catch (...) {
        remove();
        ::close(descriptor_);
        throw;
    }
}

void FolderLock::share() {
    alone_ = false;
    hold(F_RDLCK);
}

/// The last one takes the file along, and nobody else's.
void FolderLock::remove() const {
    if (hold(F_WRLCK)) ::unlink(file_.c_str());
}

FolderLock::~FolderLock() {
    at_early_end_.reset();
    remove();
    ::close(descriptor_);
}

}  // namespace hitos
