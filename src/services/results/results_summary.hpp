// SPDX-License-Identifier: GPL-3.0-or-later
// How summary.json is read: by what opens a folder of results and by what checks one.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "json_input.hpp"
#include "written_files.hpp"

namespace hitos {

inline constexpr const char* kSummaryFile = "summary.json";

/// What `read` finds in the folder's summary. Throws FileError where there is none, FormatError
/// where it is none of Hitos.
template <class Read>
auto with_summary(const std::filesystem::path& folder, Read read) {
    const std::filesystem::path file = folder / kSummaryFile;
    std::error_code problem;
    const bool there = std::filesystem::is_regular_file(file, problem);
    if (problem && problem != std::errc::no_such_file_or_directory) {
        throw FileError(file.string(), HITOS_TEXT("Errors", "cannot be read: %1"),
                        system_message(problem.value()));
    }
    if (!there) {
        throw FileError(folder.string(),
                        HITOS_TEXT("Errors",
                                   "is no folder of results: it has no summary.json; choose one "
                                   "that Save all results or hitos-cli run --out has written"));
    }
    const std::string text = input::read_text(file, input::kLargestSettings);
    // Versions before stated no digest.
    if (text.find("\"rest_xxh3_128\"") != std::string::npos && !is_sealed(text, kSummarySeal)) {
        throw FormatError(file.string(), 0,
                          HITOS_TEXT("Errors",
                                     "was changed since the run wrote it: its text is not what its "
                                     "own digest is of; do the run again"));
    }
    try {
        return read(parsed<nlohmann::json>(text, file.string()));
    } catch (const nlohmann::json::exception& error) {
        throw FormatError(file.string(), 0, HITOS_TEXT("Errors", "is no summary of a run: %1"),
                          error.what());
    }
}

}  // namespace hitos
