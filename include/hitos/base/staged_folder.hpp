// SPDX-License-Identifier: GPL-3.0-or-later
// Files that belong together, put in place together.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "hitos/base/folder_lock.hpp"

namespace hitos {

/// Makes the folder and its parents where they are missing. Throws FileError.
std::filesystem::path made_output_folder(std::filesystem::path folder);

/// A folder's new content, written beside it. Until commit() the folder is what it was; after it,
/// it has the new files and none that an earlier content left, beside everything of other people's.
/// Destroyed without commit it leaves nothing behind, nor the folder if it has made it; what a
/// killed process left is cleared by the next one. A process that is ended early clears it too, but
/// for a commit under way. It holds the folder's lock for as long as it
/// lives.
class StagedFolder {
  public:
    /// Which files are of such a content. A new one takes the place of the former ones; whatever
    /// has another's name is somebody's, and stays.
    struct Owned {
        std::function<bool(const std::string& name)> former;  ///< in the folder as it is
        std::function<bool(const std::string& name)> any;     ///< of any such content, by name
    };

    /// Makes the folder (and its parents). `seal`: the file that says that the others are whole.
    /// Throws FileError where the folder cannot be made or written to, or is held by another
    /// process.
    StagedFolder(std::filesystem::path folder, Owned owned, std::string seal);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// The folder that it is all for.
    const std::filesystem::path& target() const { return target_; }
    /// Where to write. It has been made.
    const std::filesystem::path& path() const { return staging_; }

    /// Puts the files in place. The two folders change places in one step, so that no kill leaves a
    /// mixture. Where that cannot be (the folder is somebody's working directory or a mount point,
    /// it holds folders of other people, its parent may not be written to, or the file system
    /// cannot), the files change places one by one: the seal leaves first and comes last, and a
    /// failure takes all of it back. Throws FileError.
    void commit();

  private:
    bool is_former(const std::filesystem::directory_entry& entry) const;
    bool exchange_folders();
    void exchange_files();
    void clear();

    bool made_;  ///< by this one
    std::filesystem::path target_;
    Owned owned_;
    std::string seal_;
    FolderLock lock_;
    std::filesystem::path staging_;
    AtEarlyEnd at_early_end_;
};

}  // namespace hitos
