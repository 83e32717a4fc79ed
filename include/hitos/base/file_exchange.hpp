// SPDX-License-Identifier: GPL-3.0-or-later
// Files of two folders that change places together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hitos {

/// Whether anything has that name, a link that leads nowhere too; also where it cannot be asked.
bool is_there(const std::filesystem::path& path);

/// Whether a file is there. Throws FileError where it cannot be asked: what is taken for missing
/// may well be there.
bool is_file(const std::filesystem::path& path);

/// A folder of somebody's does not make way for a file: throws FileError where one is at the place.
void check_no_folder(const std::filesystem::path& place);

/// Files that change their places between two folders, all or none: destroyed without keep(), it
/// takes everything back. The folders are of one file system.
class FileExchange {
  public:
    FileExchange(std::filesystem::path from, std::filesystem::path to);
    ~FileExchange();
    FileExchange(const FileExchange&) = delete;
    FileExchange& operator=(const FileExchange&) = delete;

    /// What is at either place goes to the other one. `name` is relative; the folders on its way
    /// are made. Throws FileError of the place in the second folder.
    void add(const std::string& name);
    /// Flushes the folders on either side, so that what is done outlasts a loss of power.
    void flush() const;
    /// Leaves everything where it is now.
    void keep() { done_.clear(); }

  private:
    /// Made before anything is moved: taking it back must not need memory.
    struct Places {
        std::filesystem::path a;
        std::filesystem::path b;
        std::filesystem::path third;  ///< for file systems that know no exchange
    };

    static bool turn(const Places& places);

    std::filesystem::path from_;
    std::filesystem::path to_;
    std::vector<Places> done_;
};

}  // namespace hitos
