// SPDX-License-Identifier: GPL-3.0-or-later
// Files that fail: HITOS_FAULT_FILE=NUMBER:ERRNO[:lasting|:cut], the operation of that number on
// what lies below HITOS_FAULT_BELOW. "lasting" is a disk that is full from then on: whatever needs
// space fails. "cut" is a write that does half of its work and then, as the disk is full, no more;
// "kill" ends the process before the operation.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "journal.hpp"
#include "report.hpp"

namespace hitos::faults {
namespace {

enum class Needs : std::uint8_t { nothing, space };

constexpr std::size_t kDescriptors = 4096;

Order order;
std::string_view below;
bool works_there = false;  ///< whether relative paths lie below it
std::atomic<long> operations = 0;
/// Of open files, whether they lie below the folder.
std::array<std::atomic<bool>, kDescriptors> watched{};

[[gnu::constructor]] void take_order() {
    renew_file_order();
}

[[gnu::destructor]] void tell_count() {
    if (order.given && order.number == 0) report("files", operations, "operations", "");
}

/// The function of that name that comes after this library's.
template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool is_watched(int descriptor) {
    return descriptor >= 0 && static_cast<std::size_t>(descriptor) < kDescriptors &&
           watched[static_cast<std::size_t>(descriptor)];
}

bool is_watched(const char* path) {
    const std::string_view text = path == nullptr ? "" : path;
    if (works_there && !text.empty() && text.front() != '/') return true;
    return text.starts_with(below) && (text.size() == below.size() || text[below.size()] == '/');
}

bool is_watched(int folder, const char* path) {
    return is_watched(path) || (path != nullptr && path[0] != '/' && is_watched(folder));
}

int watching(int descriptor, bool on) {
    if (descriptor >= 0 && static_cast<std::size_t>(descriptor) < kDescriptors) {
        watched[static_cast<std::size_t>(descriptor)] = on;
    }
    return descriptor;
}

/// Counts an operation on what is watched; whether it fails, with errno set.
bool fails(const char* what, std::string_view path, Needs needs = Needs::nothing) {
    if (!order.given || !in_main()) return false;
    const long number = ++operations;
    if (order.number == 0) {
        report(needs == Needs::space ? "space" : "other", number, what, path);
        return false;
    }
    const bool full = (order.lasting || order.cut) && number > order.number;
    if (number != order.number && !(full && needs == Needs::space)) return false;
    if (number == order.number) report("hit", number, what, path);
    if (order.kill) ::syscall(SYS_kill, ::getpid(), SIGKILL);
    errno = static_cast<int>(order.detail);
    return true;
}

bool fails(const char* what, int descriptor, Needs needs = Needs::nothing) {
    if (!is_watched(descriptor)) return false;
    std::array<char, 4096> room{};
    return fails(what, name_of(descriptor, room.data(), room.size()), needs);
}

bool fails_at(const char* what, const char* path, Needs needs = Needs::nothing) {
    return is_watched(path) && fails(what, std::string_view(path), needs);
}

bool fails_at(const char* what, int folder, const char* path, Needs needs = Needs::nothing) {
    return is_watched(folder, path) && fails(what, std::string_view(path), needs);
}

Needs needs_of(int flags) {
    constexpr unsigned kMakes =
        static_cast<unsigned>(O_CREAT) |
        (static_cast<unsigned>(O_TMPFILE) & ~static_cast<unsigned>(O_DIRECTORY));
    return (static_cast<unsigned>(flags) & kMakes) != 0U ? Needs::space : Needs::nothing;
}

/// Whether this write is the one that is to do half of its work.
bool is_cut(int descriptor) {
    return order.given && order.cut && in_main() && is_watched(descriptor) &&
           operations + 1 == order.number;
}

mode_t mode_in(int flags, std::va_list& rest) {
    return needs_of(flags) == Needs::space ? va_arg(rest, mode_t) : mode_t{0};
}

int opened(const char* name, int folder, const char* path, int flags, mode_t mode) {
    if (fails_at(name, folder, path, needs_of(flags))) return -1;
    static const auto real = next<int (*)(int, const char*, int, ...)>("openat");
    const bool is_there = is_watched(folder, path);
    Change change;
    const int result = watching(real(folder, path, flags, mode), is_there);
    const bool writes = (static_cast<unsigned>(flags) & O_ACCMODE) != O_RDONLY;
    if (result >= 0 && is_there && writes) change.tell("open", result);
    return result;
}

std::FILE* opened_stream(const char* name, const char* path, const char* mode) {
    const bool writes = std::string_view(mode).find_first_of("wa+") != std::string_view::npos;
    if (fails_at(name, path, writes ? Needs::space : Needs::nothing)) return nullptr;
    static const auto real = next<std::FILE* (*)(const char*, const char*)>("fopen");
    Change change;
    std::FILE* const file = real(path, mode);
    if (file == nullptr) return nullptr;
    watching(::fileno(file), is_watched(path));
    if (writes && is_watched(path)) change.tell("open", ::fileno(file));
    return file;
}

/// Notes what `change` gives unless it gives an error.
template <class Result>
Result noted(Change& change, const char* what, int descriptor, Result result) {
    if (result >= 0 && is_watched(descriptor)) change.tell(what, descriptor);
    return result;
}

/// Does a change of names by `real` and notes it; what loses its name is kept first.
int renamed(const char* what, int folder, const char* path, int to_folder, const char* to,
            const auto& real) {
    Change change;
    const bool is_there = is_watched(folder, path) || (to != nullptr && is_watched(to_folder, to));
    if (is_there) change.keep(to != nullptr ? to_folder : folder, to != nullptr ? to : path);
    const int result = real();
    if (result == 0 && is_there) change.tell(what, folder, path, to_folder, to);
    return result;
}

}  // namespace

void renew_file_order() {
    order = order_from("HITOS_FAULT_FILE");
    const char* folder = std::getenv("HITOS_FAULT_BELOW");  // NOLINT(concurrency-mt-unsafe)
    if (folder != nullptr) below = folder;
    order.given = order.given && !below.empty();
    operations = 0;
    std::array<char, 4096> here{};
    works_there = false;
    works_there = ::getcwd(here.data(), here.size()) != nullptr && is_watched(here.data());
    renew_journal();
}

}  // namespace hitos::faults

using namespace hitos::faults;  // NOLINT(google-build-using-namespace)

// The C library's functions, each with a chance to fail first. Where the system's headers say that
// one throws nothing, so must this.
extern "C" {

int open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_in(flags, rest);
    va_end(rest);
    return opened("open", AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_in(flags, rest);
    va_end(rest);
    return opened("open", AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_in(flags, rest);
    va_end(rest);
    return opened("openat", folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_in(flags, rest);
    va_end(rest);
    return opened("openat", folder, path, flags, mode);
}

int creat(const char* path, mode_t mode) {
    return opened("creat", AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}

std::FILE* fopen(const char* path, const char* mode) {
    return opened_stream("fopen", path, mode);
}

std::FILE* fopen64(const char* path, const char* mode) {
    return opened_stream("fopen", path, mode);
}

int fclose(std::FILE* file) {
    static const auto real = next<int (*)(std::FILE*)>("fclose");
    const int descriptor = ::fileno(file);
    const bool failed = fails("fclose", descriptor);
    const int reason = errno;
    watching(descriptor, false);
    const int result = real(file);
    if (!failed) return result;
    errno = reason;
    return EOF;
}

ssize_t read(int descriptor, void* bytes, std::size_t count) {
    static const auto real = next<ssize_t (*)(int, void*, std::size_t)>("read");
    return fails("read", descriptor) ? -1 : real(descriptor, bytes, count);
}

ssize_t pread(int descriptor, void* bytes, std::size_t count, off_t place) {
    static const auto real = next<ssize_t (*)(int, void*, std::size_t, off_t)>("pread");
    return fails("pread", descriptor) ? -1 : real(descriptor, bytes, count, place);
}

ssize_t write(int descriptor, const void* bytes, std::size_t count) {
    static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
    const bool cut = is_cut(descriptor) && count > 1;
    if (fails("write", descriptor, Needs::space)) {
        return cut ? real(descriptor, bytes, count / 2) : -1;
    }
    Change change;
    return noted(change, "write", descriptor, real(descriptor, bytes, count));
}

ssize_t pwrite(int descriptor, const void* bytes, std::size_t count, off_t place) {
    static const auto real = next<ssize_t (*)(int, const void*, std::size_t, off_t)>("pwrite");
    if (fails("pwrite", descriptor, Needs::space)) return -1;
    Change change;
    return noted(change, "write", descriptor, real(descriptor, bytes, count, place));
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    static const auto real = next<ssize_t (*)(int, const iovec*, int)>("writev");
    if (fails("writev", descriptor, Needs::space)) return -1;
    Change change;
    return noted(change, "write", descriptor, real(descriptor, parts, count));
}

int close(int descriptor) {
    static const auto real = next<int (*)(int)>("close");
    const bool failed = fails("close", descriptor);
    const int reason = errno;
    watching(descriptor, false);
    const int result = real(descriptor);  // as Linux does: it is closed even where that fails
    if (!failed) return result;
    errno = reason;
    return -1;
}

int fsync(int descriptor) {
    static const auto real = next<int (*)(int)>("fsync");
    if (fails("fsync", descriptor, Needs::space)) return -1;
    Change change;
    return noted(change, "sync", descriptor, real(descriptor));
}

int fdatasync(int descriptor) {
    static const auto real = next<int (*)(int)>("fdatasync");
    if (fails("fdatasync", descriptor, Needs::space)) return -1;
    Change change;
    return noted(change, "sync", descriptor, real(descriptor));
}

int ftruncate(int descriptor, off_t length) noexcept {
    static const auto real = next<int (*)(int, off_t)>("ftruncate");
    if (fails("ftruncate", descriptor)) return -1;
    Change change;
    return noted(change, "write", descriptor, real(descriptor, length));
}

int fcntl(int descriptor, int command, ...) {
    static const auto real = next<int (*)(int, int, ...)>("fcntl");
    std::va_list rest;
    va_start(rest, command);
    void* const argument = va_arg(rest, void*);
    va_end(rest);
    if (fails("fcntl", descriptor)) return -1;
    const int result = real(descriptor, command, argument);
    if (command == F_DUPFD || command == F_DUPFD_CLOEXEC) watching(result, is_watched(descriptor));
    return result;
}

int fcntl64(int descriptor, int command, ...) {
    std::va_list rest;
    va_start(rest, command);
    void* const argument = va_arg(rest, void*);
    va_end(rest);
    return fcntl(descriptor, command, argument);
}

int rename(const char* from, const char* to) noexcept {
    static const auto real = next<int (*)(const char*, const char*)>("rename");
    if (fails_at("rename", from)) return -1;
    return renamed("rename", AT_FDCWD, from, AT_FDCWD, to, [&] { return real(from, to); });
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
    static const auto real =
        next<int (*)(int, const char*, int, const char*, unsigned)>("renameat2");
    if (fails_at("renameat2", from_folder, from)) return -1;
    const char* const what = (flags & RENAME_EXCHANGE) != 0 ? "exchange" : "rename";
    return renamed(what, from_folder, from, to_folder, to,
                   [&] { return real(from_folder, from, to_folder, to, flags); });
}

int link(const char* from, const char* to) noexcept {
    static const auto real = next<int (*)(const char*, const char*)>("link");
    if (fails_at("link", to, Needs::space)) return -1;
    return renamed("link", AT_FDCWD, from, AT_FDCWD, to, [&] { return real(from, to); });
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
    static const auto real = next<int (*)(int, const char*, int, const char*, int)>("linkat");
    if (fails_at("linkat", to_folder, to, Needs::space)) return -1;
    return renamed("link", from_folder, from, to_folder, to,
                   [&] { return real(from_folder, from, to_folder, to, flags); });
}

int symlink(const char* from, const char* to) noexcept {
    static const auto real = next<int (*)(const char*, const char*)>("symlink");
    if (fails_at("symlink", to, Needs::space)) return -1;
    return renamed("symlink", AT_FDCWD, to, 0, nullptr, [&] { return real(from, to); });
}

int mkdir(const char* path, mode_t mode) noexcept {
    static const auto real = next<int (*)(const char*, mode_t)>("mkdir");
    if (fails_at("mkdir", path, Needs::space)) return -1;
    return renamed("mkdir", AT_FDCWD, path, 0, nullptr, [&] { return real(path, mode); });
}

int unlink(const char* path) noexcept {
    static const auto real = next<int (*)(const char*)>("unlink");
    if (fails_at("unlink", path)) return -1;
    return renamed("remove", AT_FDCWD, path, 0, nullptr, [&] { return real(path); });
}

int unlinkat(int folder, const char* path, int flags) noexcept {
    static const auto real = next<int (*)(int, const char*, int)>("unlinkat");
    if (fails_at("unlinkat", folder, path)) return -1;
    return renamed("remove", folder, path, 0, nullptr, [&] { return real(folder, path, flags); });
}

int rmdir(const char* path) noexcept {
    static const auto real = next<int (*)(const char*)>("rmdir");
    if (fails_at("rmdir", path)) return -1;
    return renamed("remove", AT_FDCWD, path, 0, nullptr, [&] { return real(path); });
}

int remove(const char* path) noexcept {
    static const auto real = next<int (*)(const char*)>("remove");
    if (fails_at("remove", path)) return -1;
    return renamed("remove", AT_FDCWD, path, 0, nullptr, [&] { return real(path); });
}

DIR* opendir(const char* path) {
    static const auto real = next<DIR* (*)(const char*)>("opendir");
    if (fails_at("opendir", path)) return nullptr;
    DIR* const folder = real(path);
    if (folder != nullptr) watching(::dirfd(folder), is_watched(path));
    return folder;
}

DIR* fdopendir(int descriptor) {
    static const auto real = next<DIR* (*)(int)>("fdopendir");
    return fails("fdopendir", descriptor) ? nullptr : real(descriptor);
}

dirent* readdir(DIR* folder) {
    static const auto real = next<dirent* (*)(DIR*)>("readdir");
    return fails("readdir", ::dirfd(folder)) ? nullptr : real(folder);
}

int closedir(DIR* folder) {
    static const auto real = next<int (*)(DIR*)>("closedir");
    watching(::dirfd(folder), false);
    return real(folder);
}

int stat(const char* path, struct stat* status) noexcept {
    static const auto real = next<int (*)(const char*, struct stat*)>("stat");
    return fails_at("stat", path) ? -1 : real(path, status);
}

int lstat(const char* path, struct stat* status) noexcept {
    static const auto real = next<int (*)(const char*, struct stat*)>("lstat");
    return fails_at("lstat", path) ? -1 : real(path, status);
}

int fstat(int descriptor, struct stat* status) noexcept {
    static const auto real = next<int (*)(int, struct stat*)>("fstat");
    return fails("fstat", descriptor) ? -1 : real(descriptor, status);
}

int fstat64(int descriptor, struct stat64* status) noexcept {
    static const auto real = next<int (*)(int, struct stat64*)>("fstat64");
    return fails("fstat", descriptor) ? -1 : real(descriptor, status);
}

int access(const char* path, int mode) noexcept {
    static const auto real = next<int (*)(const char*, int)>("access");
    return fails_at("access", path) ? -1 : real(path, mode);
}

int chmod(const char* path, mode_t mode) noexcept {
    static const auto real = next<int (*)(const char*, mode_t)>("chmod");
    return fails_at("chmod", path) ? -1 : real(path, mode);
}

int fchmod(int descriptor, mode_t mode) noexcept {
    static const auto real = next<int (*)(int, mode_t)>("fchmod");
    return fails("fchmod", descriptor) ? -1 : real(descriptor, mode);
}
}
