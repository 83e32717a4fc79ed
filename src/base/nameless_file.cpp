// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/nameless_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {

NamelessFile::NamelessFile(std::string shown, MessageText<2> problem)
    : shown_(std::move(shown)), problem_(problem) {
    const char* named = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe)
    folder_ = named != nullptr && *named != '\0' ? named : "/tmp";
    constexpr mode_t kOwn = 0600;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX has it no other way
    descriptor_ = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kOwn);
    if (descriptor_ >= 0) return;
    std::string name = folder_ / "hitos-XXXXXX";  // where the file system knows no other way
    descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    ::unlink(name.c_str());
}

NamelessFile::~NamelessFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void NamelessFile::write(std::span<const char> bytes) {
    constexpr std::uint64_t kLook = std::uint64_t{16} << 20;
    while (!bytes.empty()) {
        if (size_ % kLook == 0) leave_room();
        const auto block =
            bytes.first(std::min<std::uint64_t>(bytes.size(), kLook - size_ % kLook));
        const ssize_t put = ::write(descriptor_, block.data(), block.size());
        if (put < 0 && errno != EINTR) fail(errno);
        if (put <= 0) continue;
        size_ += static_cast<std::uint64_t>(put);
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
}

/// What unpacks without end must not fill the disk of all others.
void NamelessFile::leave_room() const {
    constexpr std::uint64_t kPart = 32;
    constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
    struct statvfs state {};
    if (::fstatvfs(descriptor_, &state) != 0) return;
    const std::uint64_t kept = std::min(state.f_blocks * state.f_frsize / kPart, kMost);
    if (state.f_bavail * state.f_frsize < kept) fail(ENOSPC);
}

int NamelessFile::release() {
    return std::exchange(descriptor_, -1);
}

void NamelessFile::fail(int error) const {
    throw FileError(shown_, message(problem_, folder_.string(), system_message(error)));
}

}  // namespace hitos
