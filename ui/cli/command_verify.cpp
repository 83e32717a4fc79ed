// hitos-cli verify and recover: whether a folder is whole, and what can be made of what is there.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/run/results_check.hpp"
#include "hitos/services/study/study_check.hpp"

namespace hitos::cli {
namespace {

constexpr int kSomeMissing = 2;

/// A study has a folder of its own, or lies beside its quality file, as BatchSLAM's.
StudyLayout study_at(const std::string& place) {
    return std::filesystem::is_regular_file(place) ? study_beside(place) : study_in_folder(place);
}

void tell(const std::vector<std::string>& files, const char* what) {
    for (const std::string& file : files) fmt::print("{}: {}\n", file, what);
}

void verify_run(const std::string& folder) {
    const ResultsCheck check = check_results(folder);
    tell(check.missing, "missing");
    tell(check.changed, "changed since it was written, or of another run");
    tell(check.left_over, "left over: not of this run");
    if (!check.whole()) throw CLI::RuntimeError(1);
    fmt::print("whole: {} files as they were written\n", check.files);
    if (!check.finished) fmt::print("of a run that was stopped before the end of its tour\n");
}

void verify_study(const StudyLayout& layout) {
    const StudyCheck check = check_study(layout);
    tell(check.missing, "the run is missing, changed or of another plan");
    tell(check.changed, "missing, changed since it was written, or not of these runs");
    tell(check.left_over, "left over: not of this study");
    if (check.interrupted) {
        fmt::print(
            "its files were being put in place: another process is at it, or hitos-cli recover "
            "ends it\n");
    } else if (!check.finished) {
        fmt::print("not finished: the same command goes on with it\n");
    }
    if (check.another) {
        fmt::print(
            "another study in this folder is under way or was stopped; when it is complete it "
            "takes the place of this one\n");
    }
    if (!check.whole()) throw CLI::RuntimeError(1);
    fmt::print("whole: {} runs, {} of them failed, and their tables\n", check.runs, check.failed);
}

void verify(const std::string& folder) {
    const StudyLayout layout = study_at(folder);
    const bool study = is_study(layout);
    std::error_code ignored;
    // Both may share a folder.
    if (!study ||
        std::filesystem::exists(std::filesystem::path(folder) / "summary.json", ignored)) {
        verify_run(folder);
    }
    if (study) verify_study(layout);
}

void recover(const std::string& folder) {
    const StudyLayout layout = study_at(folder);
    if (!is_study(layout)) {
        throw FileError(folder, verbatim("is no folder of a study: it has no study.json; expected "
                                         "the --out of hitos-cli study"));
    }
    const StudyOutcome outcome = recover_study(layout);
    for (const Message& problem : {outcome.plot_problem, outcome.picture_problem}) {
        if (!problem.empty()) fmt::print(stderr, "not drawn: {}\n", problem.english());
    }
    fmt::print("tables made anew of {} of {} runs\n", outcome.reused, outcome.records.size());
    if (outcome.failed == 0) return;
    fmt::print("the others stand in them as failed; the command of the study goes on with them\n");
    throw CLI::RuntimeError(kSomeMissing);
}

}  // namespace

void add_verify(CLI::App& program) {
    auto folder = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand(
        "verify", "Check a folder of a run or a study: files missing, changed or left over");
    command->footer("Ends with status 0 where all is as it was written, else with 1.");
    command
        ->add_option(
            "folder", *folder,
            "Folder that run, study or Save all results has written, or BatchSLAM's quality file")
        ->required();
    command->callback([folder] { verify(*folder); });
}

void add_recover(CLI::App& program) {
    auto folder = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand(
        "recover", "Make the tables and plots of a study anew of the runs that are there");
    command->add_option("folder", *folder, "Folder of the study, or BatchSLAM's quality file")
        ->required();
    command->callback([folder] { recover(*folder); });
}

}  // namespace hitos::cli
