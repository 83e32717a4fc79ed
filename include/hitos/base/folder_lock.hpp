// SPDX-License-Identifier: GPL-3.0-or-later
// One writer at a time for a folder.
#pragma once

#include <filesystem>
#include <optional>

#include "hitos/base/early_end.hpp"

namespace hitos {

/// A hidden name beside the folder (`.NAME.hitos-WORD`), or in it where nothing may be made beside
/// it. Links on the way are followed, so that every spelling of a folder has the same one.
std::filesystem::path hidden_beside(const std::filesystem::path& folder, const char* word);

/// Keeps a folder (or a file) for one writer, whatever process or host the others are on. What is
/// held is a lock of the system on a hidden file beside the folder: it ends with its holder,
/// however that ends, so nobody has to guess from a process number whether it is stale. The file
/// says who holds it, for people, and goes with the last holder. Where the file system knows no
/// locks, nothing is held.
class FolderLock {
  public:
    /// Throws FileError where the folder is held, saying by whom, or the file cannot be made. Does
    /// not make the folder, but needs its parent.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// For holders that share the work: together with whoever shares it already, else alone. Waits
    /// 20 s for one who has it alone.
    struct Shared {};
    FolderLock(const std::filesystem::path& folder, Shared);
    /// Whether nobody else holds it, until share().
    bool alone() const { return alone_; }
    /// Lets others in who share it too.
    void share();

  private:
    bool hold(short kind) const;
    /// Whether it is held, as `kind` says, or cannot be held here at all.
    bool take(const std::filesystem::path& folder, short kind);
    void sign() const;
    void begin();
    [[noreturn]] void refuse(const std::filesystem::path& folder) const;

    void remove() const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    bool alone_ = true;
    std::optional<AtEarlyEnd> at_early_end_;
};

}  // namespace hitos
