// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_check.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/text_input.hpp"
#include "results/written_files.hpp"
#include "study_files.hpp"
#include "study_folder.hpp"

namespace hitos {
namespace {

/// Run by run; those that are not there are not ok and say so.
std::vector<StudyRecord> records_of(const StudyLayout& layout, const StudyPlan& plan,
                                    std::vector<std::string>& missing) {
    std::vector<StudyRecord> records;
    records.reserve(plan.runs());
    for (std::size_t run = 0; run < plan.runs(); ++run) {
        auto record = study::read_record(layout, plan, run);
        if (!record) {
            missing.push_back(plan.label(run));
            record.emplace().problem = message(HITOS_TEXT("Errors", "the run is not there"));
        }
        records.push_back(*std::move(record));
    }
    return records;
}

bool holds_text(const std::filesystem::path& file, const std::string& text) {
    return is_file(file) && input::read_text(file) == text;
}

/// Tables that are not those of the records, and other files that are not as they were listed.
std::vector<std::string> changed_files(const StudyLayout& layout, const StudyPlan& plan,
                                       std::span<const StudyRecord> records,
                                       const study::PlanState& state) {
    std::set<std::string> changed;
    for (const auto& [file, text] : study::tables(layout, plan, records)) {
        if (!holds_text(file, text)) changed.insert(file.filename().string());
    }
    for (const WrittenFile& file : state.files) {
        // A run whose map or picture is changed is missing.
        if (study::is_of_run(layout, file.name) || is_unchanged(file, layout.folder)) continue;
        changed.insert(file.name);
    }
    return {changed.begin(), changed.end()};
}

/// The names in a folder of the study, as study.json would list them.
std::vector<std::string> names_in(const StudyLayout& layout, const char* folder) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : folder_entries(layout.file(folder), none)) {
        names.push_back(layout.prefix + folder + "/" + entry.path().filename().string());
    }
    return names;
}

/// Files where only a study's are, or with the names of its tables, that are none of this one.
std::vector<std::string> left_over_files(const StudyLayout& layout, const StudyPlan& plan,
                                         const study::PlanState& state) {
    std::set<std::string> own;
    for (const WrittenFile& file : state.files) own.insert(file.name);
    own.insert(layout.prefix + "timing.csv");  // which is not listed
    for (std::size_t run = 0; run < plan.runs(); ++run) {
        std::vector<std::filesystem::path> files = study::run_files(layout, plan, run);
        files.push_back(study::record_file(layout, plan, run));
        for (const auto& file : files) own.insert(file.lexically_relative(layout.folder).string());
    }
    std::vector<std::string> found;
    for (const char* folder : {"maps", "runs", "pictures"}) {
        std::ranges::copy(names_in(layout, folder), std::back_inserter(found));
    }
    // Before a study is finished nothing says which tables it has.
    for (const auto& entry : folder_entries(layout.folder)) {
        const std::string name = entry.path().filename().string();
        if (state.finished && study::is_table(layout, name)) found.push_back(name);
    }
    std::erase_if(found, [&](const std::string& name) { return own.contains(name); });
    std::ranges::sort(found);
    return found;
}

}  // namespace

bool is_study(const StudyLayout& layout) {
    return is_file(study::plan_file(layout));
}

StudyCheck check_study(const StudyLayout& layout) {
    const StudyPlan plan = study::read_plan(layout);
    const study::PlanState state = study::read_plan_state(layout);
    StudyCheck check;
    check.runs = plan.runs();
    check.finished = state.finished;
    check.interrupted = study::is_interrupted(layout);
    check.another = is_study(study::next_study(layout));
    const std::vector<StudyRecord> records = records_of(layout, plan, check.missing);
    for (const StudyRecord& record : records) check.failed += record.ok ? 0 : 1;
    check.failed -= check.missing.size();
    check.changed = changed_files(layout, plan, records, state);
    check.left_over = left_over_files(layout, plan, state);
    return check;
}

StudyOutcome recover_study(const StudyLayout& layout) {
    study::StudyFolder folder = study::StudyFolder::in_place(layout);
    StudyOutcome outcome;
    outcome.plan = folder.plan();
    std::vector<std::string> missing;
    outcome.records = records_of(layout, outcome.plan, missing);
    for (const StudyRecord& record : outcome.records)
        ++(record.ok ? outcome.reused : outcome.failed);
    if (missing.size() == outcome.plan.runs()) {
        throw FileError(layout.folder.string(),
                        HITOS_TEXT("Errors",
                                   "has no run of its study that can be read; nothing was changed: "
                                   "look whether maps and runs are there"));
    }
    const study::StudyFolder::Problems problems = folder.publish(outcome.records, missing.empty());
    outcome.plot_problem = problems.plots;
    outcome.picture_problem = problems.pictures;
    return outcome;
}

}  // namespace hitos
