// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/file_exchange.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <set>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "sync_folder.hpp"

namespace hitos {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::symlink_status(path, ignored).type() != fs::file_type::not_found;
}

bool is_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() != fs::file_type::none) return fs::is_regular_file(status);
    throw FileError(path.string(), HITOS_TEXT("Errors", "cannot be read: %1"),
                    system_message(error.value()));
}

void check_no_folder(const fs::path& place) {
    std::error_code ignored;
    if (!fs::is_directory(place, ignored)) return;
    throw FileError(place.string(),
                    HITOS_TEXT("Errors", "cannot be written: it is a folder; choose a file name"));
}

FileExchange::FileExchange(fs::path from, fs::path to)
    : from_(std::move(from)), to_(std::move(to)) {}

FileExchange::~FileExchange() {
    std::for_each(done_.rbegin(), done_.rend(), [](const Places& places) { turn(places); });
}

void FileExchange::add(const std::string& name) {
    Places places{from_ / name, to_ / name, from_ / (name + ".former")};
    std::error_code ignored;
    for (const fs::path& place : {places.a, places.b})
        fs::create_directories(place.parent_path(), ignored);
    // What is noted is turned back: from here on nothing needs memory before it is turned.
    done_.push_back(std::move(places));
    if (turn(done_.back())) return;
    const int reason = errno;
    done_.pop_back();
    throw FileError((to_ / name).string(), HITOS_TEXT("Errors", "cannot be put in place: %1"),
                    system_message(reason));
}

void FileExchange::flush() const {
    std::set<fs::path> folders{from_, to_};
    for (const Places& places : done_) {
        folders.insert(places.a.parent_path());
        folders.insert(places.b.parent_path());
    }
    for (const fs::path& folder : folders) sync_folder(folder);
}

bool FileExchange::turn(const Places& places) {
    const auto& [a, b, third] = places;
    if (!is_there(a)) return ::rename(b.c_str(), a.c_str()) == 0;
    if (!is_there(b)) return ::rename(a.c_str(), b.c_str()) == 0;
    if (::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    if (::rename(b.c_str(), third.c_str()) != 0) return false;
    if (::rename(a.c_str(), b.c_str()) == 0) return ::rename(third.c_str(), a.c_str()) == 0;
    const int reason = errno;
    ::rename(third.c_str(), b.c_str());
    errno = reason;
    return false;
}

}  // namespace hitos
