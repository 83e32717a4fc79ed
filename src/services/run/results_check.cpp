#include "hitos/services/run/results_check.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "json_input.hpp"
#include "results_summary.hpp"
#include "run_outputs.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

bool is_plain_name(const std::string& name) {
    return !name.empty() && name != "." && name != ".." && fs::path(name).filename() == name;
}

}  // namespace

std::vector<WrittenFile> files_named(const nlohmann::json& summary, const fs::path& file) {
    if (!summary.contains("files")) return {};
    std::vector<WrittenFile> files;
    for (const nlohmann::json& one : summary.at("files")) {
        files.push_back({one.at("name"), whole_number<std::uintmax_t>(one, "bytes", file.string()),
                         one.at("xxh3_128")});
        if (is_plain_name(files.back().name)) continue;
        throw FormatError(
            file.string(), 0,
            message(HITOS_TEXT("Errors", "names the file %1; expected a name without folders"),
                    files.back().name));
    }
    return files;
}

bool is_unchanged(const WrittenFile& file, const fs::path& folder) {
    std::error_code error;
    return fs::file_size(folder / file.name, error) == file.bytes && !error &&
           Digest().add_file(folder / file.name).text() == file.digest;
}

ResultsCheck check_results(const fs::path& folder) {
    const fs::path summary = folder / kSummaryFile;
    const std::vector<WrittenFile> files = with_summary(
        folder, [&](const nlohmann::json& json) { return files_named(json, summary); });
    if (files.empty()) {
        throw FormatError(
            summary.string(), 0,
            message(HITOS_TEXT("Errors",
                               "does not name the files of the run, as summaries of Hitos "
                               "0.1.0 did not; run it again to have them checked")));
    }
    ResultsCheck check;
    check.files = files.size();
    for (const WrittenFile& file : files) {
        std::error_code ignored;
        if (!fs::is_regular_file(folder / file.name, ignored)) {
            check.missing.push_back(file.name);
        } else if (!is_unchanged(file, folder)) {
            check.changed.push_back(file.name);
        }
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (is_run_output(name) && !std::ranges::count(files, name, &WrittenFile::name)) {
            check.left_over.push_back(name);
        }
    }
    std::ranges::sort(check.left_over);
    return check;
}

}  // namespace hitos
