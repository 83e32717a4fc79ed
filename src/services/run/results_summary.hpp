// How summary.json is read: by what opens a folder of results and by what checks one.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/run/results.hpp"
#include "json_input.hpp"

namespace hitos {

inline constexpr const char* kSummaryFile = "summary.json";

/// What `read` finds in the folder's summary. Throws FileError where there is none, FormatError
/// where it is none of Hitos.
template <class Read>
auto with_summary(const std::filesystem::path& folder, Read read) {
    const std::filesystem::path file = folder / kSummaryFile;
    std::error_code ignored;  // what cannot be asked for is none
    if (!std::filesystem::is_regular_file(file, ignored)) {
        throw FileError(
            folder.string(),
            message(HITOS_TEXT("Errors",
                               "is no folder of results: it has no summary.json; choose one that "
                               "Save all results or hitos-cli run --out has written")));
    }
    try {
        return read(
            parsed<nlohmann::json>(input::read_text(file, input::kLargestSettings), file.string()));
    } catch (const nlohmann::json::exception& error) {
        throw FormatError(
            file.string(), 0,
            message(HITOS_TEXT("Errors", "is no summary of a run: %1"), error.what()));
    }
}

/// The files that the summary names; none where it is older than their list.
std::vector<WrittenFile> files_named(const nlohmann::json& summary,
                                     const std::filesystem::path& file);

/// Whether it is there as it was written.
bool is_unchanged(const WrittenFile& file, const std::filesystem::path& folder);

}  // namespace hitos
