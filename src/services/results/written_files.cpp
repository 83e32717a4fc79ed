// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_files.hpp"

#include <algorithm>
#include <system_error>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "json_input.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// Whether the name stays in its folder, or in folders of that one.
bool is_inner(const fs::path& name) {
    if (!name.has_filename() || name.is_absolute()) return false;
    return std::none_of(name.begin(), name.end(),
                        [](const fs::path& part) { return part == "." || part == ".."; });
}

void add_files(const fs::path& folder, const fs::path& inner, std::vector<WrittenFile>& files) {
    for (const fs::directory_entry& entry :
         folder_entries(inner.empty() ? folder : folder / inner)) {
        const fs::path name = inner / entry.path().filename();
        if (entry.path().filename().string().starts_with(".hitos-")) continue;  // not finished
        if (entry.is_directory()) {
            add_files(folder, name, files);
        } else {
            files.push_back(written_file(folder, name.string()));
        }
    }
}

}  // namespace

WrittenFile written_file(const fs::path& folder, const std::string& name) {
    const fs::path path = folder / name;
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(path, error);
    if (error) throw FileError(path.string(), system_message(error.value()));
    return {name, bytes, Digest().add_file(path).text()};
}

std::vector<WrittenFile> written_files(const fs::path& folder) {
    std::vector<WrittenFile> files;
    add_files(folder, {}, files);
    std::ranges::sort(files, {}, &WrittenFile::name);
    return files;
}

bool is_unchanged(const WrittenFile& file, const fs::path& folder) {
    const fs::path path = folder / file.name;
    std::error_code error;
    const bool there = is_file(path);
    const std::uintmax_t size = there ? fs::file_size(path, error) : 0;
    if (error) {
        throw FileError(path.string(), message(HITOS_TEXT("Errors", "cannot be read: %1"),
                                               system_message(error.value())));
    }
    return there && size == file.bytes && Digest().add_file(path).text() == file.digest;
}

nlohmann::ordered_json json_of(const std::vector<WrittenFile>& files) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const WrittenFile& file : files) {
        json.push_back({{"name", file.name}, {"bytes", file.bytes}, {"xxh3_128", file.digest}});
    }
    return json;
}

std::string sealed(std::string text, std::string_view seal) {
    constexpr std::string_view kEnd = "\n}\n";
    const std::string digest = Digest().add(text).text();
    text.resize(text.size() - kEnd.size());
    return text.append(seal).append(digest).append("\"").append(kEnd);
}

bool is_sealed(std::string_view text, std::string_view seal) {
    const std::size_t at = text.rfind(seal);
    return at != std::string_view::npos &&
           sealed(std::string(text.substr(0, at)).append("\n}\n"), seal) == text;
}

std::vector<WrittenFile> files_named(const nlohmann::json& json, const fs::path& file,
                                     bool nested) {
    if (!json.contains("files")) return {};
    std::vector<WrittenFile> files;
    for (const nlohmann::json& one : json.at("files")) {
        files.push_back({one.at("name"), whole_number<std::uintmax_t>(one, "bytes", file.string()),
                         one.at("xxh3_128")});
        const fs::path name = files.back().name;
        if (is_inner(name) && (nested || !name.has_parent_path())) continue;
        throw FormatError(
            file.string(), 0,
            nested ? message(HITOS_TEXT("Errors",
                                        "names the file %1; expected a name within the folder"),
                             files.back().name)
                   : message(
                         HITOS_TEXT("Errors", "names the file %1; expected a name without folders"),
                         files.back().name));
    }
    return files;
}

}  // namespace hitos
