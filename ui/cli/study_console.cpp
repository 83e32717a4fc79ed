// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_console.hpp"

#include <fmt/core.h>

#include <cstdio>

#include "damage.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/workbench/study_noise.hpp"
#include "options.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

void tell_damage(const StudyOutcome& outcome) {
    if (const StudyRecord* record = most_damaged(outcome.records)) {
        fmt::print(stderr, "{}", damage_text(record->report));
    }
}

}  // namespace

StudyObserver StudyTeller::observer() {
    return [this](const StudyProgress& progress) {
        if (!begun_) {
            line_->say(fmt::format("{} to do, {} found done", plural(progress.runs, "run"),
                                   progress.reused));
            for (const std::filesystem::path& folder : progress.replaces) {
                line_->say(
                    fmt::format("note: {} is of another study; once this one is whole it "
                                "takes its place, and runs that it does not have are gone: "
                                "written elsewhere, it leaves both",
                                on_one_line(folder.string())));
            }
            begun_ = true;
        }
        if (progress.running_number == 0) return;  // none is under way yet
        if (!progress.failure.empty()) line_->say("run failed: " + progress.failure);
        finished_ = progress.finished;
        line_->show(progress.finished, progress.fraction,
                    fmt::format("run {} of {}: {}", progress.running_number, progress.runs,
                                progress.running));
    };
}

void StudyTeller::begin(const std::string& words) {
    finish();
    line_.emplace("runs");
    line_->say(words);
}

void StudyTeller::finish() {
    if (begun_) line_->finish(finished_);
    begun_ = false;
}

void add_summary_form(CLI::App& command, SummaryForm& form) {
    CLI::Option* option =
        command.add_flag("--csv", form.csv, "Print the summary as CSV instead of a table");
    add_report_option(command, form.json)->excludes(option);
}

void add_study_options(CLI::App& command, StudyRunOptions& options) {
    command.add_option("--runs", options.runs,
                       fmt::format("Runs of each value, with one seed after the other; of all "
                                   "values together up to {} (default: 5)",
                                   StudyPlan::kMostRuns));
    command.add_option(
        "--odometry-noise", options.noise,
        "Level of the noise, 0 or more, that every run gets on its odometry, drawn with the "
        "run's seed; the thesis uses 0.1 (default: 0, none)");
    command.add_option("--odometry-noise-kind", options.noise_kind,
                       noise_kind_choices() + " (default: relative-sigma)");
    command.add_option("--reference-trajectory", options.reference_trajectory,
                       "Reference trajectory in TUM format to measure the paths against (default "
                       "for a world: the true one)");
    command.add_flag("--pictures{first}", options.pictures,
                     "Save the grid map of each value's first run as a picture, and all of them on "
                     "contact-sheet.png; --pictures=all: of every run");
    add_summary_form(command, options.form);
}

void apply(const StudyRunOptions& options, const std::string& reference, Study& study) {
    study.seeds = options.runs;
    study.first_seed = options.first_seed;
    study.pictures = parse_study_pictures(options.pictures, "--pictures");
    References references = references_named(reference, options.reference_trajectory);
    if (references.map) study.reference = *std::move(references.map);
    study.reference_trajectory = std::move(references.trajectory);
    set_study_source(study, options.noise,
                     parse_noise_kind(options.noise_kind, "--odometry-noise-kind"));
}

int conduct(const Study& study, const StudyRunOptions& options, const StudyShard& shard) {
    StudyOptions how;
    how.threads = options.threads;
    how.shard = shard;
    StudyTeller teller;
    how.observer = teller.observer();
    const StopSource stop;
    how.stop = stop.token();
    const StudyOutcome outcome = std::move(run_studies({&study, 1}, how).front());
    if (!outcome.stopped) teller.finish();
    if (outcome.stopped) {
        teller.say(fmt::format("stopped: {} of {} done; the same command goes on with the rest",
                               outcome.computed + outcome.reused - outcome.failed,
                               plural(outcome.plan.runs(), "run")));
        if (outcome.beside) teller.say("the study that was in the folder before is still in place");
        return StopByRequest::status();
    }
    check_any(outcome);
    if (!shard.whole()) tell_damage(outcome);
    if (shard.whole()) {
        return report(outcome, study.layout, options.form);
    }
    Report said(options.form.json);
    said.say(
        "shard {} of {}: {} done, {} found done, {} failed; put the shards together "
        "with: hitos-cli study merge {}\n",
        shard.index, shard.count, plural(outcome.computed - outcome.failed, "run"), outcome.reused,
        outcome.failed, study.layout.folder.string());
    said.object() = {{"shard", shard.index},
                     {"shards", shard.count},
                     {"runs_done", outcome.computed - outcome.failed},
                     {"runs_found_done", outcome.reused},
                     {"runs_failed", outcome.failed},
                     {"folder", study.layout.folder.string()}};
    said.end();
    return outcome.failed == 0 ? 0 : kSomeFailed;
}

int report(const StudyOutcome& outcome, const StudyLayout& layout, SummaryForm form) {
    const std::vector<StudyCell> cells = summarize(outcome.plan, outcome.records);
    Report said(form.json);
    if (said.is_json()) {
        said.object() = parsed_object(summary_json(outcome.plan, cells));
        said.object()["quality_file"] = layout.quality_file().string();
        said.end();
    } else {
        said.say("{}", form.csv ? summary_csv(outcome.plan, cells)
                                : summary_markdown(outcome.plan, cells));
    }
    std::fflush(stdout);
    for (const Advice& doubt : outcome.doubts) said.warn(doubt.words());
    for (const Message& doubt : outcome.tour_doubts) said.warn(doubt.english());
    if (!outcome.plot_problem.empty()) {
        fmt::print(stderr, "no plots: {}; their scripts are beside {}\n",
                   outcome.plot_problem.english(), layout.file("landmarks.gp").string());
    }
    if (!outcome.picture_problem.empty()) {
        fmt::print(stderr, "no contact sheet: {}\n", outcome.picture_problem.english());
    } else if (outcome.plan.pictures != StudyPictures::none) {
        fmt::print(stderr, "grid maps: {}\n", layout.file("contact-sheet.png").string());
    }
    fmt::print(stderr, "quality of every run: {}; summary, maps and plots beside it\n",
               layout.quality_file().string());
    tell_damage(outcome);
    if (outcome.failed == 0) return 0;
    fmt::print(stderr, "{} of {} failed; the quality file says why\n", outcome.failed,
               plural(outcome.records.size(), "run"));
    return kSomeFailed;
}

}  // namespace hitos::cli
