// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "sync_folder.hpp"

namespace hitos {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;
constexpr int kNamesTried = 1000;

/// What a user can do about the error; empty where the reason says it all.
Message advice(int error, bool folder_exists) {
    switch (error) {
        case EACCES:
        case EPERM:
        case EROFS:
            return message(HITOS_TEXT("Errors", "; choose a folder that you may write to"));
        case ENOENT:
            return folder_exists ? message(HITOS_TEXT("Errors", "; choose another folder"))
                                 : message(HITOS_TEXT("Errors", "; create the folder first"));
        case ENOTDIR:
            return message(HITOS_TEXT("Errors", "; choose a path whose parent is a folder"));
        case ENOSPC:
        case EDQUOT:
            return message(HITOS_TEXT("Errors", "; free some space or choose another disk"));
        case ENAMETOOLONG:
            return message(HITOS_TEXT("Errors", "; choose a shorter name"));
        default:
            return {};
    }
}

/// Where remove_temporary_files() finds the names: a handler of signals may take no memory.
struct NotedFile {
    std::atomic<bool> taken = false;
    std::atomic<bool> there = false;
    std::array<char, PATH_MAX> path{};
};
constexpr std::size_t kMostNoted = 64;
std::array<NotedFile, kMostNoted> noted_files;

/// kMostNoted where there is no place for it: its name would stay after a signal, nothing else.
std::size_t note_file(const std::filesystem::path& path) {
    if (path.native().size() >= PATH_MAX) return kMostNoted;
    for (std::size_t i = 0; i < kMostNoted; ++i) {
        if (noted_files[i].taken.exchange(true)) continue;
        path.native().copy(noted_files[i].path.data(), PATH_MAX - 1);
        noted_files[i].path[path.native().size()] = '\0';
        noted_files[i].there = true;
        return i;
    }
    return kMostNoted;
}

void forget_file(std::size_t noted) {
    if (noted >= kMostNoted) return;
    noted_files[noted].there = false;
    noted_files[noted].taken = false;
}

/// A link stays a link: what it points to is replaced.
std::filesystem::path followed(std::filesystem::path path) {
    std::error_code error;
    if (!std::filesystem::is_symlink(path, error)) return path;
    std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
    return error ? path : real;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path temporary_sibling(const std::filesystem::path& file, int number) {
    return folder_of(file) /
           (".hitos-" + std::to_string(::getpid()) + "-" + std::to_string(number) + ".tmp");
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target, bool compress_gz)
    : target_(followed(std::move(target))) {
    std::error_code ignored;
    if (std::filesystem::is_directory(target_, ignored)) {
        throw FileError(
            target_.string(),
            HITOS_TEXT("Errors", "cannot be written: it is a folder; choose a file name"));
    }
    if (!target_.has_filename()) {
        throw FileError(target_.string(),
                        HITOS_TEXT("Errors", "cannot be written: it names no file"));
    }
    struct stat old {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    if (replaces && !S_ISREG(old.st_mode)) {
        // A rename would put a file where the system keeps a device, or where someone reads a pipe.
        throw FileError(
            target_.string(),
            HITOS_TEXT("Errors",
                       "cannot be written: it is a device or a pipe; choose a file name"));
    }
    open_beside();
    if (replaces) ::fchmod(descriptor_, old.st_mode & 07777U);
    if (compress_gz && target_.extension() == ".gz") {
        const int copy = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
        gzip_ = copy < 0 ? nullptr : ::gzdopen(copy, "wb6");
        if (gzip_ == nullptr) {
            const int error = errno;
            if (copy >= 0) ::close(copy);
            discard();
            errno = error;
            fail(message(HITOS_TEXT("Errors", "cannot be compressed")));
        }
    }
    buffer_.reserve(kBufferBytes);
}

void AtomicFile::open_beside() {
    // Its name is given by way of /proc.
    if (::access("/proc/self/fd", X_OK) == 0) {
        descriptor_ = ::open(folder_of(target_).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) return;
    }
    for (int i = 0; i < kNamesTried && descriptor_ < 0; ++i) {
        temporary_ = temporary_sibling(target_, i);
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) {
        temporary_.clear();
        fail(message(HITOS_TEXT("Errors", "cannot be written")));
    }
    noted_ = note_file(temporary_);
}

/// A file without a name cannot take another one's place: it gets one for that moment.
void AtomicFile::name_it() {
    const std::string nameless = "/proc/self/fd/" + std::to_string(descriptor_);
    bool named = false;
    for (int i = 0; i < kNamesTried && !named; ++i) {
        temporary_ = temporary_sibling(target_, i);
        noted_ = note_file(temporary_);
        named = ::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, temporary_.c_str(),
                         AT_SYMLINK_FOLLOW) == 0;
        if (named) break;
        forget_file(noted_);
        temporary_.clear();
        if (errno != EEXIST) break;
    }
    if (!named) fail(message(HITOS_TEXT("Errors", "cannot be put in place")));
}

AtomicFile::~AtomicFile() {
    discard();
}

void AtomicFile::discard() {
    if (gzip_ != nullptr) ::gzclose(static_cast<gzFile>(std::exchange(gzip_, nullptr)));
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
    if (temporary_.empty()) return;
    ::unlink(temporary_.c_str());
    forget_file(noted_);
    temporary_.clear();
}

void AtomicFile::write(std::string_view bytes) {
    buffer_.append(bytes);
    if (buffer_.size() >= kBufferBytes) flush();
}

void AtomicFile::flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        ssize_t done = 0;
        if (gzip_ != nullptr) {
            const std::size_t part = std::min(rest.size(), std::size_t{1} << 30);
            errno = 0;
            done = ::gzwrite(static_cast<gzFile>(gzip_), rest.data(), static_cast<unsigned>(part));
        } else {
            done = ::write(descriptor_, rest.data(), rest.size());
            if (done < 0 && errno == EINTR) continue;
        }
        if (done <= 0) fail(message(HITOS_TEXT("Errors", "writing fails")));
        rest.remove_prefix(static_cast<std::size_t>(done));
    }
    buffer_.clear();
}

void AtomicFile::commit() {
    flush();
    if (gzip_ != nullptr) {
        errno = 0;
        if (::gzclose(static_cast<gzFile>(std::exchange(gzip_, nullptr))) != Z_OK) {
            fail(message(HITOS_TEXT("Errors", "writing fails")));
        }
    }
    if (::fsync(descriptor_) != 0) fail(message(HITOS_TEXT("Errors", "writing fails")));
    if (temporary_.empty()) name_it();
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        fail(message(HITOS_TEXT("Errors", "writing fails")));
    }
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
        fail(message(HITOS_TEXT("Errors", "cannot be put in place")));
    }
    forget_file(noted_);
    temporary_.clear();
    sync_folder(folder_of(target_));
}

void AtomicFile::fail(const Message& doing) const {
    const int error = errno;
    std::error_code ignored;
    const bool folder_exists = std::filesystem::exists(target_.parent_path(), ignored);
    throw FileError(target_.string(), "%1: %2%3", doing, system_message(error == 0 ? EIO : error),
                    advice(error, folder_exists));
}

void remove_temporary_files() noexcept {
    for (const NotedFile& file : noted_files) {
        if (file.there) ::unlink(file.path.data());
    }
}

void write_file(const std::filesystem::path& target, std::string_view content) {
    AtomicFile file(target);
    file.write(content);
    file.commit();
}

}  // namespace hitos
