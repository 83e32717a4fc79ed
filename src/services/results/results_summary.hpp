// How summary.json is read: by what opens a folder of results and by what checks one.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
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
    if (!is_file(file)) {
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
