// SPDX-License-Identifier: GPL-3.0-or-later
// Files that belong together, wherever they lie, put in place together.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hitos/base/folder_lock.hpp"

namespace hitos {

/// The new content of several files, each written in a hidden folder beside its place. Until
/// commit() the files are what they were; destroyed without it, nothing is left behind. Each place
/// is held for one writer as long as this lives; what a killed process left is cleared by the next
/// one.
class StagedFiles {
  public:
    /// Throws FileError where one cannot be written, or is being written by another process.
    explicit StagedFiles(const std::vector<std::filesystem::path>& files);

    /// Calls `write`, which writes the files where staged() says. What it throws of them is thrown
    /// of the files that they are for.
    void write(const std::function<void()>& write) const;
    /// Where to write what is to become the file, under its own name.
    std::filesystem::path staged(const std::filesystem::path& file) const;
    /// Puts all in place; where that fails, all are as they were. The former one of the last file
    /// leaves first and the new one comes last, so that even a kill leaves none beside others that
    /// do not belong to it. Throws FileError.
    void commit();

  private:
    struct File {
        explicit File(std::filesystem::path file);
        ~File();
        File(const File&) = delete;
        File& operator=(const File&) = delete;

        std::filesystem::path given;
        std::filesystem::path place;  ///< links followed
        FolderLock lock;
        std::filesystem::path staging;
        AtEarlyEnd at_early_end;

        std::filesystem::path staged() const { return staging / place.filename(); }
    };

    void flush_others() const;

    std::vector<std::unique_ptr<File>> files_;
};

}  // namespace hitos
