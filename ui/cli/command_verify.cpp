// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli verify and recover: whether a folder is whole, and what can be made of what is there.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/services/results/results_check.hpp"
#include "hitos/services/study/study_check.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

constexpr int kSomeMissing = 2;

struct FolderOptions {
    std::string folder;
    bool json = false;
};

/// A study has a folder of its own, or lies beside its quality file, as BatchSLAM's.
StudyLayout study_at(const std::string& place) {
    return std::filesystem::is_regular_file(place) ? study_beside(place) : study_in_folder(place);
}

/// Files with what is wrong with them; `name` is that of their list with --json.
void tell(Report& report, const std::string& part, const char* name,
          const std::vector<std::string>& files, const char* what) {
    for (const std::string& file : files) report.say("{}: {}\n", on_one_line(file), what);
    report.object()[part][name] = files;
}

bool verify_run(const std::string& folder, Report& report) {
    const ResultsCheck check = check_results(folder);
    const std::string part = "run";
    tell(report, part, "missing", check.missing, "missing");
    tell(report, part, "changed", check.changed, "changed since it was written, or of another run");
    tell(report, part, "left_over", check.left_over, "left over: not of this run");
    nlohmann::ordered_json& object = report.object()[part];
    object["files"] = check.files;
    object["finished"] = check.finished;
    object["not_written"] = check.not_written;
    object["whole"] = check.whole();
    if (!check.whole()) return false;
    report.say("whole: {} as written\n", plural(check.files, "file"));
    for (const std::string& one : check.not_written) {
        report.say("it was asked for more, which was not written: {}\n", on_one_line(one));
    }
    if (!check.finished) report.say("of a run that was stopped before the end of its tour\n");
    return true;
}

bool verify_study(const StudyLayout& layout, Report& report) {
    const StudyCheck check = check_study(layout);
    const std::string part = "study";
    tell(report, part, "missing", check.missing, "the run is missing, changed or of another plan");
    tell(report, part, "changed", check.changed,
         "missing, changed since it was written, or not of these runs");
    tell(report, part, "left_over", check.left_over, "left over: not of this study");
    if (check.interrupted) {
        report.say(
            "its files were being put in place: another process is at it, or hitos-cli recover "
            "ends it\n");
    } else if (!check.finished) {
        report.say("not finished: the same command goes on with it\n");
    }
    if (check.another) {
        report.say(
            "another study in this folder is under way or was stopped; when it is complete it "
            "takes the place of this one\n");
    }
    nlohmann::ordered_json& object = report.object()[part];
    object["runs"] = check.runs;
    object["runs_failed"] = check.failed;
    object["finished"] = check.finished;
    object["interrupted"] = check.interrupted;
    object["another_under_way"] = check.another;
    object["whole"] = check.whole();
    if (!check.whole()) return false;
    report.say("whole: {}, {} failed, and the tables\n", plural(check.runs, "run"), check.failed);
    return true;
}

void verify(const FolderOptions& options) {
    const StudyLayout layout = study_at(options.folder);
    const bool study = is_study(layout);
    std::error_code ignored;
    Report report(options.json);
    bool whole = true;
    // Both may share a folder.
    if (!study ||
        std::filesystem::exists(std::filesystem::path(options.folder) / "summary.json", ignored)) {
        whole = verify_run(options.folder, report);
    }
    if (study) whole = verify_study(layout, report) && whole;
    report.end();
    if (!whole) throw CLI::RuntimeError(1);
}

void recover(const FolderOptions& options) {
    const StudyLayout layout = study_at(options.folder);
    if (!is_study(layout)) {
        throw FileError(options.folder,
                        verbatim("is no folder of a study: it has no study.json; expected "
                                 "the --out of hitos-cli study"));
    }
    const StudyOutcome outcome = recover_study(layout);
    for (const Message& problem : {outcome.plot_problem, outcome.picture_problem}) {
        if (!problem.empty()) fmt::print(stderr, "not drawn: {}\n", problem.english());
    }
    Report report(options.json);
    report.say("tables made anew of {} of {}\n", outcome.reused,
               plural(outcome.records.size(), "run"));
    if (outcome.failed != 0) {
        report.say(
            "the others stand in them as failed; the command of the study goes on with them\n");
    }
    report.object() = {{"runs", outcome.records.size()},
                       {"runs_found", outcome.reused},
                       {"runs_failed", outcome.failed}};
    report.end();
    if (outcome.failed != 0) throw CLI::RuntimeError(kSomeMissing);
}

}  // namespace

void add_verify(CLI::App& program) {
    auto options = std::make_shared<FolderOptions>();
    CLI::App* command = program.add_subcommand(
        "verify", "Check a folder of a run or a study: files missing, changed or left over");
    command->footer("Ends with status 0 where all is as it was written, else with 1.");
    command
        ->add_option(
            "folder", options->folder,
            "Folder that run, study or Save all results has written, or BatchSLAM's quality file")
        ->required();
    add_report_option(*command, options->json);
    command->callback([options] { verify(*options); });
}

void add_recover(CLI::App& program) {
    auto options = std::make_shared<FolderOptions>();
    CLI::App* command = program.add_subcommand(
        "recover", "Make the tables and plots of a study anew of the runs that are there");
    command
        ->add_option("folder", options->folder, "Folder of the study, or BatchSLAM's quality file")
        ->required();
    add_report_option(*command, options->json);
    command->callback([options] { recover(*options); });
}

}  // namespace hitos::cli
