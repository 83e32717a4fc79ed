// SPDX-License-Identifier: GPL-3.0-or-later
// Which files of a folder are those of a run that another one may take the place of.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/services/results/results.hpp"
#include "results_summary.hpp"
#include "run_outputs.hpp"
#include "written_files.hpp"

namespace hitos {

void prepare_output_folder(const std::filesystem::path& folder) {
    if (is_there(folder / kSummaryFile)) {
        throw FileError(folder.string(),
                        HITOS_TEXT("Errors",
                                   "holds the results of a run, which would not be what they "
                                   "were; choose another folder"));
    }
    made_output_folder(folder);
    // Destroyed without commit, the probe leaves nothing behind.
    AtomicFile(folder / ".hitos-probe").write("");
}

namespace {

/// The files of the run whose results are in the folder: those that its summary names, or (of a
/// version that named none) all that a run may write. Without a summary none: whatever their names,
/// they are somebody's.
class FormerFiles {
  public:
    explicit FormerFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool operator()(const std::string& name) {
        if (name == kSummaryFile) return true;
        if (!known_) read();
        return by_name_ ? is_run_output(name) : known_->contains(name);
    }

  private:
    void read() {
        known_.emplace();
        std::error_code problem;
        const bool there = std::filesystem::is_regular_file(folder_ / kSummaryFile, problem);
        // One that cannot be looked at is there.
        if (!there && (!problem || problem == std::errc::no_such_file_or_directory)) return;
        try {
            const auto files = with_summary(folder_, [this](const nlohmann::json& json) {
                return files_named(json, folder_ / kSummaryFile);
            });
            for (const WrittenFile& file : files) known_->insert(file.name);
            by_name_ = files.empty();
        } catch (const Error&) {
            by_name_ = true;
        }
    }

    std::filesystem::path folder_;
    std::optional<std::set<std::string>> known_;
    bool by_name_ = false;
};

}  // namespace

bool is_results_file(const std::string& name) {
    return name == kSummaryFile || is_run_output(name);
}

std::optional<std::string> somebodys_file(const std::filesystem::path& folder,
                                          std::span<const std::string> also) {
    if (!is_there(folder)) return std::nullopt;
    FormerFiles former(folder);
    for (const auto& entry : folder_entries(folder)) {
        const std::string name = entry.path().filename().string();
        const auto writes = [&](const RunOutput& output) {
            const bool asked =
                output.word.empty() || std::ranges::find(also, output.word) != also.end();
            return asked && output.owns(name);
        };
        if (!former(name) && std::ranges::any_of(run_outputs(), writes)) return name;
    }
    return std::nullopt;
}

UnaskedFiles unasked_files(const std::filesystem::path& folder, std::span<const std::string> also,
                           std::span<const std::string> options) {
    UnaskedFiles unasked;
    if (!is_there(folder)) return unasked;
    FormerFiles former(folder);
    const auto note = [&unasked](const std::string& file, const std::string& by,
                                 std::span<const std::string> asked, std::set<std::string>& ways) {
        if (by.empty() || std::ranges::find(asked, by) != asked.end()) return;
        unasked.files.insert(file);
        ways.insert(by);
    };
    for (const auto& entry : folder_entries(folder)) {
        const std::string name = entry.path().filename().string();
        const auto output = std::ranges::find_if(
            run_outputs(), [&](const RunOutput& one) { return one.owns(name); });
        if (output == run_outputs().end() || !former(name)) continue;
        note(name, output->word, also, unasked.words);
        note(name, output->option_of(name), options, unasked.options);
    }
    return unasked;
}

bool holds_finished_run(const std::filesystem::path& folder) {
    try {
        return with_summary(
            folder, [](const nlohmann::json& json) { return json.value("finished", true); });
    } catch (const Error&) {
        return false;
    }
}

StagedFolder results_folder(const std::filesystem::path& folder) {
    // Asked first before anything changes places, and then not read again.
    return {folder,
            {[former = std::make_shared<FormerFiles>(folder)](const std::string& name) {
                 return (*former)(name);
             },
             is_results_file},
            kSummaryFile};
}

}  // namespace hitos
