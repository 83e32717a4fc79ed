// SPDX-License-Identifier: GPL-3.0-or-later
// The folder that ROS 2's recorder makes: metadata.yaml and one file after another.
#include <algorithm>
#include <charconv>
#include <set>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "recordings/recording.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = kRosbag2Metadata;

/// A comment begins behind a blank, or with the line.
std::string_view without_comment(std::string_view words) {
    if (words.starts_with('#')) return {};
    return input::trimmed(words.substr(0, words.find(" #")));
}

/// "[a.mcap, 'b.mcap']"
void take_list(std::string_view words, std::vector<std::string>& out) {
    words = input::trimmed(words);
    if (!words.starts_with('[')) return;
    words = words.substr(1, words.size() - 2);
    while (!input::trimmed(words).empty()) {
        const std::size_t comma = std::min(words.find(','), words.size());
        out.emplace_back(input::unquoted(input::trimmed(words.substr(0, comma))));
        words.remove_prefix(std::min(comma + 1, words.size()));
    }
}

/// What metadata.yaml says of the files; as rosbag2 writes it, one fact a line.
struct Metadata {
    std::vector<std::string> files;
    std::string compression;
};

Metadata read_metadata(const fs::path& path) {
    Metadata metadata;
    const std::string text = input::read_text(path, input::kLargestSettings);
    std::string_view rest = text;
    bool in_files = false;
    constexpr std::string_view kFiles = "relative_file_paths:";
    while (const std::optional<std::string_view> line = input::next_line(rest)) {
        const std::string_view words = without_comment(input::trimmed(*line));
        if (words.empty()) continue;
        if (in_files && words.starts_with("- ")) {
            metadata.files.emplace_back(input::unquoted(input::trimmed(words.substr(2))));
            continue;
        }
        in_files = words == kFiles;
        if (words.starts_with(kFiles) && words.ends_with(']')) {
            take_list(words.substr(kFiles.size()), metadata.files);
        }
        constexpr std::string_view kCompression = "compression_mode:";
        if (words.starts_with(kCompression)) {
            metadata.compression =
                input::unquoted(input::trimmed(words.substr(kCompression.size())));
        }
    }
    return metadata;
}

/// The name of what is in the file, which rosbag2 may have compressed as a whole.
fs::path unpacked_name(const fs::path& file) {
    return file.extension() == ".zstd" || file.extension() == ".zst"
               ? file.parent_path() / file.stem()
               : file;
}

/// NAME_10.mcap comes behind NAME_9.mcap: by the number at the end, then by name.
std::pair<std::uint64_t, std::string> order_of(const fs::path& file) {
    const std::string stem = unpacked_name(file).stem().string();
    const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
    std::uint64_t number = 0;
    std::from_chars(stem.data() + digits, stem.data() + stem.size(), number);
    return {number, stem};
}

std::vector<fs::path> files_found(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const char* ending : {".mcap", ".db3"}) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            const fs::path& file = entry->path();
            const fs::path plain = unpacked_name(file);
            // A recorder that is killed while it compresses a file leaves both.
            const bool half = plain != file && fs::exists(plain, error);
            if (plain.extension() == ending && !half) files.push_back(file);
        }
        if (error) {
            throw FileError(folder.string(),
                            HITOS_TEXT("Errors", "cannot be opened for reading: %1"),
                            system_message(error.value()));
        }
        if (!files.empty()) break;
    }
    std::ranges::sort(files, {}, order_of);
    return files;
}

fs::path file_in(const fs::path& folder, const std::string& name) {
    const fs::path relative(name);
    // The first versions of rosbag2 name the file with its folder.
    fs::path alone = folder / relative.filename();
    const bool outside = relative.is_absolute() || std::ranges::count(relative, "..") > 0;
    std::error_code error;
    if (!outside && fs::exists(folder / relative, error)) return folder / relative;
    if (!outside && fs::exists(alone, error)) return alone;
    // Unpacked by hand, or compressed since.
    for (const fs::path& other : {unpacked_name(alone), fs::path(alone.string() + ".zstd"),
                                  fs::path(alone.string() + ".zst")}) {
        if (!outside && fs::exists(other, error)) return other;
    }
    throw FormatError(
        (folder / kMetadata).string(), 0,
        HITOS_TEXT("Errors", "names the file \"%1\", which is not in its folder; put it there"),
        name);
}

class Rosbag2Folder final : public Recording {
  public:
    Rosbag2Folder(const fs::path& folder, RecordingUse use)
        : files_(rosbag2_files(folder)), use_(std::move(use)) {
        open_next();
    }

    std::optional<RecordedMessage> next() override {
        for (;;) {
            std::optional<RecordedMessage> found = current_->next();
            while (std::optional<RecordingProblem> problem = current_->take_problem()) {
                note(problem->number,
                     message("%1: %2", files_[opened_ - 1].filename().string(), problem->reason));
            }
            if (found) return found;
            if (!open_next_sound()) return std::nullopt;
        }
    }

    double progress() const override {
        return (static_cast<double>(current_file_) + current_->progress()) /
               static_cast<double>(files_.size());
    }

  private:
    /// Of the files behind the first, those that cannot be opened are told and passed over.
    bool open_next_sound() {
        while (opened_ < files_.size()) {
            try {
                open_next();
                return true;
            } catch (const FormatError& error) {
                note(use_.topics.count_damage(),
                     message("%1: %2", files_[opened_].filename().string(), error.problem()));
                ++opened_;
            }
        }
        return false;
    }

    void open_next() {
        const fs::path& file = files_[opened_];
        current_ = unpacked_name(file).extension() == ".db3" ? open_db3(file, use_)
                                                             : open_mcap(file, use_);
        current_file_ = opened_++;
    }

    std::vector<fs::path> files_;
    RecordingUse use_;
    std::unique_ptr<Recording> current_;
    std::size_t opened_ = 0;        ///< how many of the files were tried
    std::size_t current_file_ = 0;  ///< the place of current_
};

}  // namespace

std::vector<fs::path> rosbag2_files(const fs::path& path) {
    std::vector<fs::path> files;
    std::error_code error;
    const fs::path folder =
        path.filename() == kMetadata && !fs::is_directory(path, error) ? path.parent_path() : path;
    if (fs::exists(folder / kMetadata, error)) {
        const Metadata metadata = read_metadata(folder / kMetadata);
        std::string mode = metadata.compression;
        std::ranges::transform(mode, mode.begin(), [](unsigned char c) {
            return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        });
        if (!mode.empty() && mode != "none" && mode != "file") {
            throw FormatError((folder / kMetadata).string(), 0,
                              HITOS_TEXT("Errors",
                                         "says that the recording is compressed by %1, which Hitos "
                                         "does not read; convert it with \"ros2 bag convert\""),
                              metadata.compression);
        }
        std::set<std::string> named;  // a file belongs to the recording once
        for (const std::string& name : metadata.files) {
            fs::path file = file_in(folder, name);
            if (named.insert(file.string()).second) files.push_back(std::move(file));
        }
    }
    // A recorder that was killed leaves a metadata.yaml that says nothing, or none.
    if (files.empty()) files = files_found(folder);
    if (!files.empty()) return files;
    throw FileError(
        folder.string(),
        HITOS_TEXT(
            "Errors",
            "is a folder without a recording: found neither a metadata.yaml that names files nor "
            "files *.mcap or *.db3, plain or as *.zstd; choose a log file inside it"));
}

bool is_rosbag2_folder(const fs::path& folder) {
    std::error_code error;
    try {
        return fs::exists(folder / kMetadata, error) || !files_found(folder).empty();
    } catch (const FileError&) {
        return false;
    }
}

std::unique_ptr<Recording> open_rosbag2_folder(const fs::path& path, RecordingUse use) {
    return std::make_unique<Rosbag2Folder>(path, std::move(use));
}

}  // namespace hitos
