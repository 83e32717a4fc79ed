// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "report.hpp"

namespace hitos::faults {
namespace {

using Path = std::array<char, 4096>;

std::mutex one_at_a_time;
std::atomic<long> changes = 0;
const char* kept_in = nullptr;

long inode_of(int folder, const char* path, int flags) {
    struct stat status {};
    const long failed = ::syscall(SYS_newfstatat, folder, path, &status, flags);
    return failed != 0 ? 0 : static_cast<long>(status.st_ino);
}

/// The path from the root, its folder's links followed, its own not.
void whole(int folder, const char* path, Path& room) {
    const char* const slash = std::strrchr(path, '/');
    Path parent{'.'};
    if (slash != nullptr) {
        const auto length = static_cast<std::size_t>(slash == path ? 1 : slash - path);
        std::memcpy(parent.data(), path, std::min(length, parent.size() - 1));
    }
    const char* const name = slash != nullptr ? slash + 1 : path;
    const long opened = ::syscall(SYS_openat, folder, parent.data(), O_PATH | O_CLOEXEC, 0);
    Path found{};
    name_of(static_cast<int>(opened), found.data(), found.size() - 1);
    ::syscall(SYS_close, opened);
    std::snprintf(room.data(), room.size(), "%.2040s/%.2040s", found.data(), name);
}

void note(const char* what, long inode, const char* path, const char* other) {
    Path detail{};
    std::snprintf(detail.data(), detail.size(), "%ld\t%.2000s\t%.2000s", inode, path, other);
    report("did", ++changes, what, detail.data());
}

}  // namespace

void renew_journal() {
    kept_in = std::getenv("HITOS_FAULT_JOURNAL");  // NOLINT(concurrency-mt-unsafe)
    changes = 0;
}

bool keeps_journal() {
    return kept_in != nullptr && in_main();
}

Change::Change() {
    if (keeps_journal()) turn_ = std::unique_lock(one_at_a_time);
}

void Change::keep(int folder, const char* path) {
    if (!turn_) return;
    const int kept = errno;
    const long inode = inode_of(folder, path, AT_SYMLINK_NOFOLLOW);
    Path name{};
    std::snprintf(name.data(), name.size(), "%s/%ld", kept_in, inode);
    // A folder has no second name, and one that is there already is this file's.
    if (inode != 0) ::syscall(SYS_linkat, folder, path, AT_FDCWD, name.data(), 0);
    errno = kept;
}

void Change::tell(const char* what, int folder, const char* path, int other_folder,
                  const char* other) {
    if (!turn_) return;
    const int kept = errno;
    Path first{};
    Path second{};
    whole(folder, path, first);
    if (other != nullptr) whole(other_folder, other, second);
    const long inode =
        inode_of(AT_FDCWD, other != nullptr ? second.data() : first.data(), AT_SYMLINK_NOFOLLOW);
    note(what, inode, first.data(), second.data());
    errno = kept;
}

void Change::tell(const char* what, int descriptor) {
    if (!turn_) return;
    const int kept = errno;
    Path name{};
    name_of(descriptor, name.data(), name.size() - 1);
    note(what, inode_of(descriptor, "", AT_EMPTY_PATH), name.data(), "");
    errno = kept;
}

}  // namespace hitos::faults
