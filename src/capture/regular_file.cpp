// SPDX-License-Identifier: GPL-3.0-or-later
#include "regular_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {

RegularFile::RegularFile(const std::filesystem::path& path, FileExtent extent)
    : path_(path), extent_(std::move(extent)) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0) {
        const int error = errno;
        if (error == ENOENT || error == ENOTDIR) {
            throw FileError(path.string(),
                            HITOS_TEXT("Errors", "there is no such file; check the path"));
        }
        throw FileError(path.string(), HITOS_TEXT("Errors", "cannot be opened for reading: %1"),
                        system_message(error));
    }
    struct stat status {};
    const bool known = ::fstat(descriptor_, &status) == 0;
    if (!known || !S_ISREG(status.st_mode)) {
        const bool folder = known && S_ISDIR(status.st_mode);
        ::close(descriptor_);
        throw FileError(
            path.string(),
            folder
                ? message(HITOS_TEXT("Errors", "is a folder; choose a log file inside it"))
                : message(HITOS_TEXT("Errors", "is no regular file; copy the log to one first")));
    }
    size_ = std::min(extent_.limit, static_cast<std::uint64_t>(status.st_size));
}

RegularFile::RegularFile(int descriptor, std::uint64_t size, std::filesystem::path path)
    : path_(std::move(path)), descriptor_(descriptor), size_(size) {}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : path_(std::move(other.path_)),
      extent_(std::move(other.extent_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      position_(other.position_) {}

RegularFile::~RegularFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t RegularFile::read(std::span<char> out) {
    if (extent_.growth && !extent_.growth->wait_beyond(position_)) return 0;
    if (extent_.growth || extent_.limit != FileExtent{}.limit) {
        const std::uint64_t end = size();
        out = out.first(std::min<std::uint64_t>(out.size(), end - std::min(end, position_)));
    }
    for (;;) {
        const ssize_t got = ::read(descriptor_, out.data(), out.size());
        if (got >= 0) {
            position_ += static_cast<std::uint64_t>(got);
            return static_cast<std::size_t>(got);
        }
        if (errno == EINTR) continue;
        throw FileError(path_.string(), HITOS_TEXT("Errors", "reading fails: %1"),
                        system_message(errno));
    }
}

std::size_t RegularFile::read_at(std::uint64_t offset, std::span<char> out) const {
    std::size_t done = 0;
    while (done < out.size()) {
        const ssize_t got = ::pread(descriptor_, out.data() + done, out.size() - done,
                                    static_cast<off_t>(offset + done));
        if (got == 0) break;
        if (got > 0) {
            done += static_cast<std::size_t>(got);
        } else if (errno != EINTR) {
            throw FileError(path_.string(), HITOS_TEXT("Errors", "reading fails: %1"),
                            system_message(errno));
        }
    }
    return done;
}

void RegularFile::seek(std::uint64_t offset) {
    position_ = offset;
    if (::lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0) {
        throw FileError(path_.string(), HITOS_TEXT("Errors", "reading fails: %1"),
                        system_message(errno));
    }
}

}  // namespace hitos
