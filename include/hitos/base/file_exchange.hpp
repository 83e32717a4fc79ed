// Files of two folders that change places together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hitos {

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
    bool turn(const std::string& name) const;

    std::filesystem::path from_;
    std::filesystem::path to_;
    std::vector<std::string> done_;
};

}  // namespace hitos
