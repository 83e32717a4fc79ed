// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/db3_pages.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "recordings/unpack.hpp"

namespace hitos {
namespace {

constexpr std::size_t kHeader = 100;
constexpr std::size_t kChangesHeader = 32;
constexpr std::size_t kFrameHeader = 24;

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
    return static_cast<std::uint32_t>(big_endian(bytes.substr(place, 4)));
}

bool is_page_size(std::uint64_t size) {
    return std::has_single_bit(size) && size >= 512 && size <= 65536;
}

/// The running checksum of a log of changes.
class ChangesSum {
  public:
    explicit ChangesSum(bool big_endian_words) : big_(big_endian_words) {}
    void add(std::string_view bytes) {
        for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
            first_ += word(bytes.data() + at) + second_;
            second_ += word(bytes.data() + at + 4) + first_;
        }
    }
    bool is(std::string_view stated) const {
        return number_at(stated, 0) == first_ && number_at(stated, 4) == second_;
    }

  private:
    std::uint32_t word(const char* bytes) const {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes, sizeof value);
        return big_ == (std::endian::native == std::endian::big) ? value : __builtin_bswap32(value);
    }
    bool big_;
    std::uint32_t first_ = 0;
    std::uint32_t second_ = 0;
};

// What SQLite asks of a file, of one that cannot change.
struct OpenFile {
    sqlite3_file base;
    const Db3Pages* pages;
};

/// Nothing is written.
int fail_to_write() {
    return SQLITE_READONLY;
}

sqlite3_io_methods file_methods() {
    sqlite3_io_methods methods{};
    methods.iVersion = 1;
    methods.xClose = [](sqlite3_file*) { return SQLITE_OK; };
    methods.xRead = [](sqlite3_file* file, void* out, int count, sqlite3_int64 offset) {
        const Db3Pages& pages = *reinterpret_cast<OpenFile*>(file)->pages;
        const std::span bytes(static_cast<char*>(out), static_cast<std::size_t>(count));
        const auto begin = static_cast<std::uint64_t>(offset);
        try {
            if (pages.read(begin, bytes)) return SQLITE_OK;
        } catch (const std::bad_alloc&) {
            return SQLITE_NOMEM;
        } catch (const Error&) {
            return SQLITE_IOERR_READ;
        }
        const bool beyond = begin >= pages.pages() * pages.page_size();
        if (beyond) std::ranges::fill(bytes, '\0');
        return beyond ? SQLITE_IOERR_SHORT_READ : SQLITE_CORRUPT;
    };
    methods.xWrite = [](sqlite3_file*, const void*, int, sqlite3_int64) { return fail_to_write(); };
    methods.xTruncate = [](sqlite3_file*, sqlite3_int64) { return fail_to_write(); };
    methods.xSync = [](sqlite3_file*, int) { return SQLITE_OK; };
    methods.xFileSize = [](sqlite3_file* file, sqlite3_int64* size) {
        const Db3Pages& pages = *reinterpret_cast<OpenFile*>(file)->pages;
        *size = static_cast<sqlite3_int64>(pages.pages()) *
                static_cast<sqlite3_int64>(pages.page_size());
        return SQLITE_OK;
    };
    methods.xLock = [](sqlite3_file*, int) { return SQLITE_OK; };
    methods.xUnlock = [](sqlite3_file*, int) { return SQLITE_OK; };
    methods.xCheckReservedLock = [](sqlite3_file*, int* out) {
        *out = 0;
        return SQLITE_OK;
    };
    methods.xFileControl = [](sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; };
    methods.xSectorSize = [](sqlite3_file*) { return 4096; };
    methods.xDeviceCharacteristics = [](sqlite3_file*) { return SQLITE_IOCAP_IMMUTABLE; };
    return methods;
}

int open_file(sqlite3_vfs* system, const char* /*name*/, sqlite3_file* file, int flags,
              int* out_flags) {
    static const sqlite3_io_methods methods = file_methods();
    file->pMethods = nullptr;
    if ((flags & SQLITE_OPEN_MAIN_DB) == 0) return SQLITE_CANTOPEN;
    auto* opened = reinterpret_cast<OpenFile*>(file);
    opened->pages = static_cast<const Db3Pages*>(system->pAppData);
    opened->base.pMethods = &methods;
    if (out_flags != nullptr) *out_flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_MAIN_DB;
    return SQLITE_OK;
}

}  // namespace

std::uint64_t big_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
}

Db3Pages::Db3Pages(const std::filesystem::path& path) : path_(path), file_(open_unpacked(path)) {
    take_changes();
    std::array<char, kHeader> bytes{};
    const std::string_view header(bytes.data(), bytes.size());
    const bool whole = page_size_ != 0 && changed_.contains(1)
                           ? read(0, bytes)
                           : file_.read_at(0, bytes) == bytes.size();
    // One byte has no room for 65536: it is written as 1.
    const std::uint64_t stated =
        big_endian(header.substr(16, 2)) == 1 ? 65536 : big_endian(header.substr(16, 2));
    if (!whole || !header.starts_with("SQLite format 3") || !is_page_size(stated)) {
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors", "cannot be read as a recording: %1"),
                          message(HITOS_TEXT("Errors", "its header is damaged")));
    }
    if (page_size_ != stated) changed_.clear();  // they are of another file
    page_size_ = static_cast<std::uint32_t>(stated);
    // SQLite refuses pages of less than 480 bytes.
    reserved_ = std::min<std::uint32_t>(static_cast<unsigned char>(header[20]), page_size_ - 480);
    const std::uint64_t found = (file_.size() + page_size_ - 1) / page_size_;
    // An old SQLite does not say how many there are; others vouch for it by a second number.
    const bool says = header.substr(24, 4) == header.substr(92, 4);
    pages_ = changed_.empty() ? 0 : changed_pages_;
    if (pages_ == 0) pages_ = says ? number_at(header, 28) : found;
    if (pages_ == 0) pages_ = found;
    const std::uint64_t whole_pages = file_.size() / page_size_;
    last_page_ = std::min(pages_, whole_pages);
    std::uint64_t missing = pages_ - last_page_;
    for (const auto& [page, place] : changed_) {
        if (page <= whole_pages || page > pages_) continue;
        --missing;
        last_page_ = std::max(last_page_, page);
    }
    cut_ = missing > 0;
    if (cut_) {
        problems_.insert(
            problems_.begin(),
            message(HITOS_TEXT("Errors",
                               "the recording is cut off at byte %1: %2 of the %3 pages that it "
                               "says it has are missing; what the others hold was read"),
                    file_.size(), missing, pages_));
    }
    std::error_code error;
    const std::string journal = path.string() + "-journal";
    if (const std::uint64_t size = std::filesystem::file_size(journal, error); !error && size > 0) {
        problems_.push_back(message(HITOS_TEXT("Errors",
                                               "a recorder was broken off while it wrote, as %1 "
                                               "tells; what it wrote last may be in part"),
                                    std::filesystem::path(journal).filename().string()));
    }
}

/// Of the log of changes all finished transactions count; what an earlier one left behind them does
/// not.
void Db3Pages::take_changes() {
    const std::filesystem::path log = path_.string() + "-wal";
    std::error_code error;
    const std::uint64_t there = std::filesystem::file_size(log, error);
    if (error || there == 0) return;
    changes_.emplace(log);
    const std::uint64_t size = changes_->size();
    const auto left_out = [&](std::uint64_t from) {
        problems_.push_back(
            message(HITOS_TEXT("Errors",
                               "%1 holds changes from byte %2 to byte %3 that were never finished, "
                               "or are cut off or damaged; they are left out"),
                    log.filename().string(), from, size));
    };
    std::string head(kChangesHeader, '\0');
    changes_->read_at(0, head);
    const std::uint32_t magic = number_at(head, 0);
    const std::uint64_t page_size = number_at(head, 8);
    ChangesSum sum((magic & 1U) != 0);
    sum.add(std::string_view(head).substr(0, 24));
    if ((magic & ~1U) != 0x377f0682U || !is_page_size(page_size) ||
        !sum.is(std::string_view(head).substr(24))) {
        left_out(0);
        return;
    }
    page_size_ = static_cast<std::uint32_t>(page_size);
    const std::string_view salt = std::string_view(head).substr(16, 8);
    std::string frame(kFrameHeader + page_size, '\0');
    std::vector<std::pair<std::uint64_t, std::uint64_t>> open;  // of the unfinished transaction
    std::uint64_t finished = kChangesHeader;
    std::uint64_t at = kChangesHeader;
    while (changes_->read_at(at, frame) == frame.size()) {
        const std::string_view all(frame);
        sum.add(all.substr(0, 8));
        sum.add(all.substr(kFrameHeader));
        if (all.substr(8, 8) != salt || !sum.is(all.substr(16, 8))) break;
        open.emplace_back(number_at(all, 0), at + kFrameHeader);
        at += frame.size();
        const std::uint32_t pages = number_at(all, 4);
        if (pages == 0) continue;
        for (const auto& [page, place] : open) changed_.insert_or_assign(page, place);
        open.clear();
        changed_pages_ = pages;
        finished = at;
    }
    if (finished >= size) return;
    // The log is begun anew from its front, each time with a first salt that is one more.
    std::string behind(kFrameHeader, '\0');
    const bool whole = changes_->read_at(at, behind) == behind.size();
    const std::uint32_t older = number_at(head, 16) - number_at(behind, 8);
    const bool stale = whole && number_at(behind, 8) != 0 && older > 0 && older < 1U << 20U;
    if (at > finished || !stale) left_out(finished);
}

bool Db3Pages::is_there(std::uint64_t page) const {
    return changed_.contains(page) || page * page_size_ <= file_.size();
}

bool Db3Pages::read(std::uint64_t offset, std::span<char> out) const {
    while (!out.empty()) {
        const std::uint64_t page = offset / page_size_ + 1;
        const std::uint64_t within = offset % page_size_;
        if (!is_there(page) || page > std::max(pages_, std::uint64_t{1})) return false;
        const auto part = out.first(std::min<std::uint64_t>(out.size(), page_size_ - within));
        const auto changed = changed_.find(page);
        const std::size_t got = changed == changed_.end()
                                    ? file_.read_at(offset, part)
                                    : changes_->read_at(changed->second + within, part);
        if (got < part.size()) return false;
        offset += part.size();
        out = out.subspan(part.size());
    }
    return true;
}

sqlite3* Db3Pages::open() {
    system_ = std::make_unique<sqlite3_vfs>(*sqlite3_vfs_find(nullptr));  // its clock and the like
    system_->szOsFile = sizeof(OpenFile);
    system_->pAppData = this;
    system_->xOpen = open_file;
    system_->xDelete = [](sqlite3_vfs*, const char*, int) { return fail_to_write(); };
    system_->xAccess = [](sqlite3_vfs*, const char*, int, int* out) {
        *out = 0;
        return SQLITE_OK;
    };
    system_->xFullPathname = [](sqlite3_vfs*, const char* name, int size, char* out) {
        sqlite3_snprintf(size, out, "%s", name);
        return SQLITE_OK;
    };
    // It is asked for by its name when a database is opened, and never again.
    const std::string name = fmt::format("hitos-{}", fmt::ptr(this));
    system_->zName = name.c_str();
    sqlite3_vfs_register(system_.get(), 0);
    sqlite3* database = nullptr;
    sqlite3_open_v2("recording", &database, SQLITE_OPEN_READONLY, name.c_str());
    sqlite3_vfs_unregister(system_.get());
    return database;
}

Db3Pages::~Db3Pages() = default;

}  // namespace hitos
