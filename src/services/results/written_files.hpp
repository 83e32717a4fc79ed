// SPDX-License-Identifier: GPL-3.0-or-later
// The lists by which folders of results and of studies say what they consist of.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/results/results.hpp"

namespace hitos {

/// The file of that name in the folder as it is now. Throws FileError where it cannot be read.
WrittenFile written_file(const std::filesystem::path& folder, const std::string& name);

/// All files in the folder and the folders in it, sorted by name.
std::vector<WrittenFile> written_files(const std::filesystem::path& folder);

/// Whether it is there as it was written. Throws FileError where it cannot be looked at.
bool is_unchanged(const WrittenFile& file, const std::filesystem::path& folder);

nlohmann::ordered_json json_of(const std::vector<WrittenFile>& files);

/// How the last member of a JSON object begins that states the digest of the rest of its text.
inline constexpr std::string_view kSummarySeal = ",\n  \"rest_xxh3_128\": \"";
inline constexpr std::string_view kStudySeal = ",\n \"checksum\": \"";
/// The object's text with that member, and whether it has it and nothing was changed since.
std::string sealed(std::string text, std::string_view seal);
bool is_sealed(std::string_view text, std::string_view seal);

/// What json_of() has written as "files"; none where `json` has no such list. Throws FormatError of
/// `file` for a name that leads out of the folder, or into another one unless `nested`.
std::vector<WrittenFile> files_named(const nlohmann::json& json, const std::filesystem::path& file,
                                     bool nested = false);

}  // namespace hitos
