// SPDX-License-Identifier: GPL-3.0-or-later
// What a rename needs to outlast a loss of power.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

namespace hitos {

/// Flushes the names in the folder to the disk. A folder that may not be read is no error: the
/// files are in place.
inline void sync_folder(const std::filesystem::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace hitos
