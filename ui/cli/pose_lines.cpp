// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_lines.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/message.hpp"

namespace hitos::cli {
namespace {

constexpr std::size_t kMostHeld = std::size_t{16} << 20;

std::string reason(int error) {
    return std::generic_category().message(error);
}

}  // namespace

PoseLines::PoseLines(std::filesystem::path path) : path_(std::move(path)) {
    if (!open() && errno != ENXIO)
        throw FileError(path_.string(), verbatim("cannot be written: " + reason(errno)));
}

PoseLines::~PoseLines() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

/// False of a pipe that nobody reads yet (ENXIO).
bool PoseLines::open() {
    constexpr mode_t kMode = S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH;
    descriptor_ =
        ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_CLOEXEC, kMode);
    return descriptor_ >= 0;
}

void PoseLines::put(const std::string& line) {
    if (!problem_.empty()) return;
    held_ += line;
    if (descriptor_ < 0 && !open() && errno != ENXIO) problem_ = reason(errno);
    while (descriptor_ >= 0 && !held_.empty()) {
        const ssize_t put = ::write(descriptor_, held_.data(), held_.size());
        if (put >= 0) {
            held_.erase(0, static_cast<std::size_t>(put));
            continue;
        }
        if (errno == EINTR) continue;
        if (errno != EAGAIN) problem_ = reason(errno);
        break;
    }
    if (held_.size() > kMostHeld) problem_ = "its reader takes nothing";
}

}  // namespace hitos::cli
