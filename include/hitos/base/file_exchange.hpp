// Files that change places together.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"

namespace hitos {

/// Whether anything has that name, a link that leads nowhere too; also where it cannot be asked.
bool is_there(const std::filesystem::path& path);

/// Whether a file is there. Throws FileError where it cannot be asked: what is taken for missing
/// may well be there.
bool is_file(const std::filesystem::path& path);

/// Does `work`. What it throws of a file in the hidden place, of which nobody knows, it throws of
/// the one that is shown.
template <class Work>
auto told_of(const std::string& shown, const std::string& hidden, const Work& work) {
    try {
        return work();
    } catch (const FileError& error) {
        throw error.replaced(hidden, shown);
    }
}

/// A folder of somebody's does not make way for a file: throws FileError where one is at the place.
void check_no_folder(const std::filesystem::path& place);

/// Files that wait in hidden folders change places with those that they are to follow, all or none:
/// destroyed without keep(), it takes everything back, the last one first. A file and its place are
/// of one file system.
class FileExchange {
  public:
    FileExchange() = default;
    ~FileExchange();
    FileExchange(const FileExchange&) = delete;
    FileExchange& operator=(const FileExchange&) = delete;

    /// What is at either place goes to the other one; their folders are made, and outlast a loss of
    /// power before anything goes there. Throws FileError of `place`.
    void add(const std::filesystem::path& waiting, const std::filesystem::path& place);
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

    std::set<std::filesystem::path> folders_;
    std::vector<Places> done_;
};

}  // namespace hitos
