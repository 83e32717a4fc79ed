#include "hitos/base/input_files.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

bool same_time(const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

/// The time of change tells a writer who has set the time of writing back.
bool same_state(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
           same_time(a.st_mtim, b.st_mtim) && same_time(a.st_ctim, b.st_ctim);
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
            throw FileError(output->string(),
                            message(HITOS_TEXT("Errors",
                                               "is read by this very command; choose another name "
                                               "for what it writes")));
        }
        if (std::any_of(outputs.begin(), output, is_it)) {
            throw FileError(output->string(),
                            message(HITOS_TEXT("Errors",
                                               "is to be written twice; choose another name for "
                                               "one of the two")));
        }
    }
}

InputFiles::InputFiles(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        Input input{file, {}, false};
        input.there = ::stat(file.c_str(), &input.state) == 0;
        inputs_.push_back(std::move(input));
    }
}

void InputFiles::check() const {
    for (const Input& input : inputs_) {
        struct stat now {};
        const bool there = ::stat(input.file.c_str(), &now) == 0;
        if (there == input.there && (!there || same_state(now, input.state))) continue;
        throw FileError(input.file.string(),
                        message(HITOS_TEXT("Errors",
                                           "has changed while it was being worked on; start again "
                                           "when the file is complete")));
    }
}

}  // namespace hitos
