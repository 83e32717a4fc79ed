// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/staged_files.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <list>
#include <set>
#include <system_error>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "sync_folder.hpp"

namespace hitos {

namespace fs = std::filesystem;

namespace {

/// The file that is replaced, as AtomicFile has it. Throws where it could not write there.
fs::path checked_place(const fs::path& file) {
    AtomicFile(file).write("");  // not committed, it leaves nothing behind
    std::error_code error;
    fs::path real = fs::weakly_canonical(file, error);
    return error ? fs::absolute(file) : real;
}

/// Whoever may read the former file may read the new one.
void take_mode(const fs::path& from, const fs::path& to) {
    struct stat old {};
    if (::stat(from.c_str(), &old) == 0) ::chmod(to.c_str(), old.st_mode & 07777U);
}

}  // namespace

StagedFiles::File::File(fs::path file)
    : given(std::move(file)),
      place(checked_place(given)),
      lock(place),
      staging(hidden_beside(place, "new")),
      at_early_end([this] { remove_under_way(staging); }) {
    std::error_code error;
    fs::remove_all(staging, error);  // whoever left it is no more: the lock was free
    if (!fs::create_directory(staging, error)) {
        throw FileError(
            given.string(),
            HITOS_TEXT("Errors", "cannot be written: %1; choose a folder that you may write to"),
            error ? system_message(error.value())
                  : message(HITOS_TEXT("Errors", "a file is in its place")));
    }
}

StagedFiles::File::~File() {
    at_early_end.forget();
    remove_whole(staging);
}

StagedFiles::StagedFiles(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) files_.push_back(std::make_unique<File>(file));
}

void StagedFiles::write(const std::function<void()>& write) const {
    try {
        write();
    } catch (const FileError& error) {
        // Nobody knows of the folders in which they really are.
        FileError told = error;
        for (const auto& file : files_) {
            told = told.replaced(file->staged().string(), file->given.string());
        }
        throw FileError(told);
    }
}

fs::path StagedFiles::staged(const fs::path& file) const {
    const auto found =
        std::ranges::find_if(files_, [&](const auto& one) { return one->given == file; });
    return (*found)->staged();
}

/// Else a loss of power may leave the last one, of now or of before, without what belongs to it. No
/// more than that: meanwhile there is no last one.
void StagedFiles::flush_others() const {
    sync_folder(files_.back()->place.parent_path());
    std::set<fs::path> folders;
    for (const auto& file : files_) {
        if (file == files_.back()) break;
        folders.insert({file->staging, file->place.parent_path()});
    }
    folders.erase(files_.back()->place.parent_path());
    for (const fs::path& folder : folders) sync_folder(folder);
}

void StagedFiles::commit() {
    if (files_.empty()) return;
    for (const auto& file : files_) file->at_early_end.forget();
    for (const auto& file : files_) {
        check_no_folder(file->place);
        take_mode(file->place, file->staged());
    }
    std::list<FileExchange> exchanges;
    const File& last = *files_.back();
    if (is_there(last.place)) {
        exchanges.emplace_back(last.staging / "former", last.place.parent_path())
            .add(last.place.filename().string());
    }
    for (const auto& file : files_) {
        if (file.get() == &last && files_.size() > 1) flush_others();
        exchanges.emplace_back(file->staging, file->place.parent_path())
            .add(file->place.filename().string());
    }
    for (const FileExchange& exchange : exchanges) exchange.flush();
    for (FileExchange& exchange : exchanges) exchange.keep();
}

}  // namespace hitos
