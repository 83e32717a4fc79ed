// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/input_files.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

bool same_time(const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

bool same_writing(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
           same_time(a.st_mtim, b.st_mtim);
}

/// Empty where the content cannot be read.
std::string digest_of(const fs::path& file, const struct stat& state) {
    if (!S_ISREG(state.st_mode)) return {};
    try {
        return Digest().add_file(file).text();
    } catch (const FileError&) {
        return {};
    }
}

bool same_place(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    const fs::path left = fs::weakly_canonical(a, error);
    const fs::path right = fs::weakly_canonical(b, error);
    return !left.empty() && left == right;
}

}  // namespace

void check_apart(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        if (output->empty()) continue;
        const auto is_it = [&](const fs::path& other) {
            return !other.empty() && same_place(*output, other);
        };
        if (std::ranges::any_of(inputs, is_it)) {
            throw FileError(
                output->string(),
                HITOS_TEXT("Errors",
                           "is read by this very command; choose another name for what it writes"));
        }
        if (std::any_of(outputs.begin(), output, is_it)) {
            throw FileError(
                output->string(),
                HITOS_TEXT("Errors",
                           "is to be written twice; choose another name for one of the two"));
        }
    }
}

InputFiles::InputFiles(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        const auto input = std::make_shared<Input>();
        input->file = file;
        input->there = ::stat(file.c_str(), &input->state) == 0;
        if (input->there) input->digest = digest_of(file, input->state);
        inputs_.push_back(input);
    }
}

void InputFiles::check() const {
    for (const std::shared_ptr<Input>& input : inputs_) {
        const std::scoped_lock lock(input->mutex);
        struct stat now {};
        const bool there = ::stat(input->file.c_str(), &now) == 0;
        if (there == input->there && (!there || input->is_still(now))) continue;
        throw FileError(
            input->file.string(),
            HITOS_TEXT(
                "Errors",
                "has changed while it was being worked on; start again when the file is complete"));
    }
}

/// The time of change tells a writer who has set the time of writing back; but it changes with a
/// link, owner or mode too, and then the content is what it was.
bool InputFiles::Input::is_still(const struct stat& now) {
    if (!same_writing(now, state)) return false;
    if (same_time(now.st_ctim, state.st_ctim)) return true;
    if (digest.empty() || digest_of(file, now) != digest) return false;
    state = now;
    return true;
}

}  // namespace hitos
