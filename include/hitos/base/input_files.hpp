// Files that a command reads, kept from what it writes and from what others write meanwhile.
#pragma once

#include <sys/stat.h>

#include <filesystem>
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
    /// neither the one nor the other.
    void check() const;

  private:
    struct Input {
        std::filesystem::path file;
        struct stat state {};
        bool there = false;
    };
    std::vector<Input> inputs_;
};

}  // namespace hitos
