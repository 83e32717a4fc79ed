// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/staged_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <system_error>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "sync_folder.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// All entries of a folder: half a list would lose files. Throws FileError, of `shown`.
std::vector<fs::directory_entry> all_entries(const fs::path& folder, const fs::path& shown) {
    try {
        return folder_entries(folder);
    } catch (const FileError& error) {
        throw error.replaced(folder.string(), shown.string());
    }
}

/// What a writer has not finished, or could not remove.
bool is_unfinished(const std::string& name) {
    return name.starts_with(".hitos-");
}

/// Whether a process of this machine that one may look at works in the folder: it would find
/// itself in the old one.
bool somebody_is_in(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error) return true;
    std::error_code ignored;
    for (const fs::directory_entry& process : folder_entries("/proc", ignored)) {
        const fs::path place = fs::read_symlink(process.path() / "cwd", error);
        if (error) continue;
        const auto [end, rest] =
            std::mismatch(real.begin(), real.end(), place.begin(), place.end());
        if (end == real.end()) return true;
    }
    return false;
}

/// Another name for somebody's file, or a link that leads where theirs does.
bool linked(const fs::directory_entry& entry, const fs::path& to) {
    std::error_code error;
    if (entry.is_symlink(error)) {
        fs::copy_symlink(entry.path(), to, error);
    } else if (entry.is_regular_file(error)) {
        fs::create_hard_link(entry.path(), to, error);
    } else {
        return false;
    }
    return !error;
}

bool exchanged(const fs::path& a, const fs::path& b) {
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

/// A file that goes back to its place unless another one has taken it.
class PutAside {
  public:
    PutAside(fs::path file, fs::path aside) : file_(std::move(file)), aside_(std::move(aside)) {
        std::error_code none;
        fs::rename(file_, aside_, none);
    }
    ~PutAside() {
        std::error_code none;
        if (!is_there(file_)) fs::rename(aside_, file_, none);
    }
    PutAside(const PutAside&) = delete;
    PutAside& operator=(const PutAside&) = delete;

  private:
    fs::path file_;
    fs::path aside_;
};

}  // namespace

fs::path made_output_folder(fs::path folder) {
    std::error_code error;
    if (fs::is_symlink(folder, error) && !fs::exists(folder, error)) {
        throw FileError(folder.string(),
                        HITOS_TEXT("Errors",
                                   "is a link to %1, which is not there; make that folder, or give "
                                   "another with --out"),
                        fs::read_symlink(folder, error).string());
    }
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder, error)) {
        throw FileError(
            folder.string(),
            HITOS_TEXT("Errors", "cannot make this output folder: %1; give another with --out"),
            error ? system_message(error.value())
                  : message(HITOS_TEXT("Errors", "a file is in its place")));
    }
    return folder;
}

StagedFolder::StagedFolder(fs::path folder, Owned owned, std::string seal)
    : made_(!is_there(folder)),
      target_(made_output_folder(std::move(folder))),
      owned_(std::move(owned)),
      seal_(std::move(seal)),
      lock_(target_),
      staging_(hidden_beside(target_, "new")),
      at_early_end_([this] {
          remove_under_way(staging_);
          if (made_) ::rmdir(target_.c_str());
      }) {
    clear();  // whoever left it is no more: the lock was free
    std::error_code error;
    if (is_there(staging_)) {
        throw FileError(target_.string(),
                        HITOS_TEXT("Errors",
                                   "cannot be written: %1, which a process has left, cannot be "
                                   "removed; remove it by hand"),
                        staging_.string());
    }
    if (::access(target_.c_str(), W_OK) != 0) error = {errno, std::generic_category()};
    if (error || !fs::create_directory(staging_, error)) {
        throw FileError(
            target_.string(),
            HITOS_TEXT("Errors", "cannot be written: %1; choose a folder that you may write to"),
            error ? system_message(error.value())
                  : message(HITOS_TEXT("Errors", "a file is in its place")));
    }
}

StagedFolder::~StagedFolder() {
    at_early_end_.forget();
    try {
        clear();
    } catch (const std::exception&) {
        return;  // no memory is left for it: the next one clears
    }
    // One that was made for nothing goes; one with anything in it stays.
    if (made_) ::rmdir(target_.c_str());
}

void StagedFolder::clear() {
    std::error_code ignored;
    if (!fs::is_directory(staging_, ignored)) return;
    // After an exchange these are the former files, and what somebody put beside them meanwhile.
    std::error_code incomplete;
    for (const fs::directory_entry& entry : folder_entries(staging_, incomplete)) {
        const std::string name = entry.path().filename().string();
        const bool own = !entry.is_directory(ignored) && owned_.any(name);
        if (own || is_unfinished(name) || is_there(target_ / name)) continue;
        fs::rename(entry.path(), target_ / name, ignored);
    }
    if (incomplete) return;  // somebody's file may be among what is not known
    remove_whole(staging_);
}

bool StagedFolder::exchange_folders() {
    // In it, where nothing can be beside it, as at a mount point.
    std::error_code unknown;
    if (staging_.parent_path() == fs::weakly_canonical(target_, unknown) || unknown) return false;
    if (somebody_is_in(target_)) return false;
    std::vector<fs::path> links;
    const auto give_up = [&links] {
        std::error_code ignored;
        for (const fs::path& link : links) fs::remove(link, ignored);
        return false;
    };
    for (const fs::directory_entry& entry : all_entries(target_, target_)) {
        const fs::path here = staging_ / entry.path().filename();
        if (is_former(entry) || is_unfinished(here.filename().string()) || is_there(here)) continue;
        if (!linked(entry, here)) return give_up();
        links.push_back(here);
    }
    struct stat old {};
    if (::stat(target_.c_str(), &old) != 0) return give_up();
    ::chmod(staging_.c_str(), old.st_mode & 07777U);
    sync_folder(staging_);
    std::error_code error;
    const fs::path real = fs::canonical(target_, error);  // a link stays a link
    if (error || !exchanged(staging_, real)) return give_up();
    sync_folder(real.parent_path());
    return true;
}

void StagedFolder::exchange_files() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : all_entries(staging_, target_)) {
        const std::string name = entry.path().filename().string();
        if (!is_unfinished(name)) names.push_back(name);
    }
    std::vector<std::string> former;
    for (const fs::directory_entry& entry : all_entries(target_, target_)) {
        const std::string name = entry.path().filename().string();
        if (name != seal_ && is_former(entry) && !is_there(staging_ / name)) {
            former.push_back(name);
        }
    }
    // The former seal may be gone for a moment, the new one is never early. Taken back last.
    const PutAside former_seal(target_ / seal_, staging_ / (".hitos-" + seal_));
    FileExchange exchange(staging_, target_);
    for (const std::string& name : former) exchange.add(name);
    for (const std::string& name : names) {
        if (name != seal_) exchange.add(name);
    }
    sync_folder(target_);
    exchange.add(seal_);
    exchange.keep();
    sync_folder(target_);
}

bool StagedFolder::is_former(const fs::directory_entry& entry) const {
    std::error_code ignored;
    return !entry.is_directory(ignored) && owned_.former(entry.path().filename().string());
}

void StagedFolder::commit() {
    const auto whole = at_early_end_.hold();  // with the former files gone
    for (const fs::directory_entry& entry : all_entries(staging_, target_)) {
        if (is_unfinished(entry.path().filename().string())) {
            std::error_code ignored;  // it then comes along, and goes with the next results
            fs::remove_all(entry.path(), ignored);
            continue;
        }
        check_no_folder(target_ / entry.path().filename());
    }
    if (!exchange_folders()) exchange_files();
    clear();
}

}  // namespace hitos
