// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of an SQLite file as they stand in it and in the log of changes (-wal) beside it
// [sqlite.org/fileformat2]. SQLite itself writes beside the file that it reads: it makes a -shm,
// and takes possession of a -wal where it may.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "hitos/base/message.hpp"
#include "regular_file.hpp"

struct sqlite3;
struct sqlite3_vfs;

namespace hitos {

/// What SQLite's numbers are made of: the greatest byte first.
std::uint64_t big_endian(std::string_view bytes);

class Db3Pages {
  public:
    /// Throws FileError where a file cannot be read, FormatError where it has not even a header.
    explicit Db3Pages(const std::filesystem::path& path);
    ~Db3Pages();
    Db3Pages(const Db3Pages&) = delete;
    Db3Pages& operator=(const Db3Pages&) = delete;

    std::uint32_t page_size() const { return page_size_; }
    /// Bytes at the end of each page that are not SQLite's.
    std::uint32_t reserved() const { return reserved_; }
    /// How many pages there ought to be.
    std::uint64_t pages() const { return pages_; }
    /// The last one that is there.
    std::uint64_t last_page() const { return last_page_; }
    /// False where the files end before the last of these bytes. Throws FileError.
    bool read(std::uint64_t offset, std::span<char> out) const;
    /// Whether the files have fewer pages than there ought to be.
    bool cut() const { return cut_; }
    /// What of the recording is not in the files, or not whole in them.
    const std::vector<Message>& problems() const { return problems_; }

    /// The database of these pages, to be closed while they live: nothing is written, no other
    /// file is looked at. As sqlite3_open() has it, null or in a state of error where it fails.
    sqlite3* open();

  private:
    void take_changes();
    bool is_there(std::uint64_t page) const;

    std::filesystem::path path_;
    RegularFile file_;
    std::optional<RegularFile> changes_;
    std::unordered_map<std::uint64_t, std::uint64_t> changed_;  ///< page: where it is in changes_
    std::uint64_t changed_pages_ = 0;  ///< how many the last finished transaction left
    std::uint32_t page_size_ = 0;
    std::uint32_t reserved_ = 0;
    std::uint64_t pages_ = 0;
    std::uint64_t last_page_ = 0;
    bool cut_ = false;
    std::vector<Message> problems_;
    std::unique_ptr<sqlite3_vfs> system_;
};

}  // namespace hitos
