// SPDX-License-Identifier: GPL-3.0-or-later
// What a disk has after the current failed: of names and bytes whatever was flushed, and of the
// rest any part in any order.
#pragma once

#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace hitos::test {

/// A folder's files and names as a disk keeps them, from the journal of the library of faults
/// (tests/shim/journal.hpp). A change of names is on the disk for sure once a folder that it
/// touched has been flushed, a file's bytes once the file has; what is not may be there or not,
/// each change for itself (POSIX promises no order).
class Disk {
  public:
    /// All that is in `root` now is on the disk. `copy` keeps its bytes.
    Disk(std::filesystem::path root, std::filesystem::path copy);

    void follow(const std::vector<std::string>& journal);
    /// Makes `root` what it may be after the loss; `kept` is the journal's folder.
    void lose_power(const std::filesystem::path& kept, std::mt19937& random);

    std::size_t unflushed() const;

  private:
    using Entries = std::map<std::string, long>;
    struct Node {
        bool folder = false;
        bool flushed = true;  ///< its bytes
        bool old = false;     ///< `copy` has it
        std::filesystem::path first;
        std::string link;  ///< where a symbolic link leads
        Entries entries;
    };
    struct Change {
        std::string what;
        long from = 0, to = 0;  ///< folders
        std::string name, other;
        long node = 0, exchanged = 0;
        bool flushed = false;
    };

    long add_tree(const std::filesystem::path& path, const std::filesystem::path& copy);
    long folder_of(const std::filesystem::path& path) const;
    void note(Change change);
    bool apply(const Change& change);
    void flush_folder(long folder);
    void write_out(long folder, const std::filesystem::path& path,
                   const std::map<long, std::string>& bytes) const;
    std::string bytes_left(const Node& node, const std::string& now, std::mt19937& random,
                           const std::filesystem::path& copy) const;

    std::filesystem::path root_;
    std::filesystem::path copy_;
    std::map<long, Node> nodes_;  ///< files by inode, folders by numbers below 0
    std::map<long, Entries> start_;
    std::vector<Change> changes_;
    long top_ = 0;
    long folders_ = 0;
};

}  // namespace hitos::test
