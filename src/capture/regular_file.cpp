#include "regular_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "hitos/base/error.hpp"

namespace hitos {

RegularFile::RegularFile(const std::filesystem::path& path) : path_(path) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0) {
        const int error = errno;
        if (error == ENOENT || error == ENOTDIR) {
            throw FileError(path.string(),
                            message(HITOS_TEXT("Errors", "there is no such file; check the path")));
        }
        throw FileError(path.string(),
                        message(HITOS_TEXT("Errors", "cannot be opened for reading: %1"),
                                system_message(error)));
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
    size_ = static_cast<std::uint64_t>(status.st_size);
}

RegularFile::~RegularFile() {
    ::close(descriptor_);
}

std::size_t RegularFile::read(std::span<char> out) {
    for (;;) {
        const ssize_t got = ::read(descriptor_, out.data(), out.size());
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno == EINTR) continue;
        throw FileError(path_.string(),
                        message(HITOS_TEXT("Errors", "reading fails: %1"), system_message(errno)));
    }
}

void RegularFile::seek(std::uint64_t offset) {
    if (::lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0) {
        throw FileError(path_.string(),
                        message(HITOS_TEXT("Errors", "reading fails: %1"), system_message(errno)));
    }
}

}  // namespace hitos
