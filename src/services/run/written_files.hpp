// The lists by which folders of results and of studies say what they consist of.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/run/results.hpp"

namespace hitos {

/// The file of that name in the folder as it is now. Throws FileError where it cannot be read.
WrittenFile written_file(const std::filesystem::path& folder, const std::string& name);

/// All files in the folder and the folders in it, sorted by name.
std::vector<WrittenFile> written_files(const std::filesystem::path& folder);

/// Whether it is there as it was written.
bool is_unchanged(const WrittenFile& file, const std::filesystem::path& folder);

nlohmann::ordered_json json_of(const std::vector<WrittenFile>& files);

/// The text of a JSON object that states the digest of the rest of it, and whether nothing was
/// changed since; texts of versions that stated none pass.
std::string sealed(std::string text);
bool is_sealed(std::string_view text);

/// What json_of() has written as "files"; none where `json` has no such list. Throws FormatError of
/// `file` for a name that leads out of the folder, or into another one unless `nested`.
std::vector<WrittenFile> files_named(const nlohmann::json& json, const std::filesystem::path& file,
                                     bool nested = false);

}  // namespace hitos
