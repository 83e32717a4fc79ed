// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/folder_entries.hpp"

#include <dirent.h>

#include <cerrno>
#include <exception>
#include <memory>
#include <string_view>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

struct FolderCloser {
    void operator()(DIR* folder) const { ::closedir(folder); }
};

}  // namespace

std::vector<fs::directory_entry> folder_entries(const fs::path& folder, std::error_code& error) {
    std::vector<fs::directory_entry> found;
    std::error_code unknown;
    const std::unique_ptr<DIR, FolderCloser> open(::opendir(folder.c_str()));
    while (open != nullptr) {
        errno = 0;
        const dirent* entry = ::readdir(open.get());  // NOLINT(concurrency-mt-unsafe): own stream
        if (entry == nullptr) break;
        const std::string_view name = static_cast<const char*>(entry->d_name);
        if (name == "." || name == "..") continue;
        std::error_code problem;
        found.emplace_back(folder / name, problem);
        if (!problem) continue;
        found.pop_back();  // it has no path then
        const bool gone = problem == std::errc::no_such_file_or_directory;
        if (!gone) unknown = problem;
    }
    error = {errno, std::generic_category()};
    if (!error) error = unknown;
    return found;
}

std::vector<fs::directory_entry> folder_entries(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::directory_entry> found = folder_entries(folder, error);
    if (!error) return found;
    throw FileError(folder.string(), HITOS_TEXT("Errors", "cannot read: %1"),
                    system_message(error.value()));
}

void remove_whole(const fs::path& path) noexcept {
    constexpr int kTries = 4;
    for (int i = 0; i < kTries; ++i) {
        try {
            std::error_code ignored;
            fs::remove_all(path, ignored);
            if (!fs::exists(path, ignored)) return;
        } catch (const std::exception&) {
            continue;
        }
    }
}

void remove_leftovers(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : folder_entries(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const bool unfinished = name.ends_with(".tmp") || name.ends_with("-plots");
        if (!name.starts_with(".hitos-") || !unfinished) continue;
        remove_whole(entry.path());
    }
}

}  // namespace hitos
