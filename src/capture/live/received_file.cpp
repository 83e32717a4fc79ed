// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/received_file.hpp"

#include <fcntl.h>
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

/// Beside the file, and free: what a run that was killed has left there is not lost either.
std::filesystem::path name_of_former(const std::filesystem::path& file) {
    std::filesystem::path name = file;
    name += ".before";
    std::error_code unknown;
    for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(name, unknown)); ++i) {
        name = file;
        name += ".before-";
        name += std::to_string(i);
    }
    return name;
}

}  // namespace

ReceivedFile::ReceivedFile(std::filesystem::path file, bool replace) : file_(std::move(file)) {
    const auto open = [&] {
        descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                             S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
        return descriptor_ >= 0;
    };
    if (open()) return;
    if (errno != EEXIST) throw FileError(file_.string(), kCannotBeMade, system_message(errno));
    if (!replace) {
        throw FileError(file_.string(),
                        HITOS_TEXT("Errors",
                                   "is there already, and may be what another run received; say "
                                   "--replace to receive in its place, or another name with "
                                   "--received"));
    }
    before_ = name_of_former(file_);
    std::error_code failed;
    std::filesystem::rename(file_, before_, failed);
    if (failed) throw FileError(file_.string(), kCannotBeMade, failed.message());
    if (open()) return;
    const int reason = errno;
    std::filesystem::rename(before_, file_, failed);
    throw FileError(file_.string(), kCannotBeMade, system_message(reason));
}

ReceivedFile::~ReceivedFile() {
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

void ReceivedFile::keep() {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(kept_, true) || before_.empty()) return;
    std::error_code ignored;
    std::filesystem::remove(before_, ignored);
}

bool ReceivedFile::give_back() {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(kept_, true)) return false;
    std::error_code failed;
    if (before_.empty()) {
        std::filesystem::remove(file_, failed);
        return false;
    }
    std::filesystem::rename(before_, file_, failed);
    return !failed;
}

}  // namespace hitos
