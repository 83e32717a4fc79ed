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
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::symlink_status(path, ignored).type() != fs::file_type::not_found;
}

bool moved(const fs::path& from, const fs::path& to) {
    std::error_code ignored;
    fs::create_directories(to.parent_path(), ignored);
    return ::rename(from.c_str(), to.c_str()) == 0;
}

}  // namespace

FileExchange::FileExchange(fs::path from, fs::path to)
    : from_(std::move(from)), to_(std::move(to)) {}

FileExchange::~FileExchange() {
    std::for_each(done_.rbegin(), done_.rend(), [this](const auto& name) { turn(name); });
}

void FileExchange::add(const std::string& name) {
    if (!turn(name)) {
        throw FileError(
            (to_ / name).string(),
            message(HITOS_TEXT("Errors", "cannot be put in place: %1"), system_message(errno)));
    }
    done_.push_back(name);
}

void FileExchange::flush() const {
    std::set<fs::path> folders{from_, to_};
    for (const std::string& name : done_) {
        folders.insert((from_ / name).parent_path());
        folders.insert((to_ / name).parent_path());
    }
    for (const fs::path& folder : folders) sync_folder(folder);
}

bool FileExchange::turn(const std::string& name) const {
    const fs::path a = from_ / name;
    const fs::path b = to_ / name;
    if (!is_there(a)) return moved(b, a);
    if (!is_there(b)) return moved(a, b);
    if (::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    // File systems that know no exchange: by a third name.
    const fs::path c = from_ / (name + ".former");
    if (::rename(b.c_str(), c.c_str()) != 0) return false;
    if (::rename(a.c_str(), b.c_str()) == 0) return ::rename(c.c_str(), a.c_str()) == 0;
    const int reason = errno;
    ::rename(c.c_str(), b.c_str());
    errno = reason;
    return false;
}

}  // namespace hitos
