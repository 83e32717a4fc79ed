// SPDX-License-Identifier: GPL-3.0-or-later
// Files that a command reads, kept from what it writes and from what others write meanwhile.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace hitos {

/// Throws FileError where one of the outputs is one of the inputs, by whatever name, or where two
/// outputs are one file. Empty paths are none.
void check_apart(std::span<const std::filesystem::path> outputs,
                 std::span<const std::filesystem::path> inputs);

/// Files as they are when a work begins.
class InputFiles {
  public:
    explicit InputFiles(const std::vector<std::filesystem::path>& files);

    /// Throws FileError where one is another file now, or was written to: what was read of it is
    /// neither the one nor the other. Thread-safe.
    void check() const;

  private:
    struct Input {
        bool is_still(const struct stat& now);

        std::filesystem::path file;
        std::mutex mutex;  // guards the state
        struct stat state {};
        std::string digest;
        bool there = false;
    };
    std::vector<std::shared_ptr<Input>> inputs_;
};

}  // namespace hitos
