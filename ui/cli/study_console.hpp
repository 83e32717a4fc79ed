// SPDX-License-Identifier: GPL-3.0-or-later
// What BatchSLAM and hitos-cli study have in common: options, progress and the closing words.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "hitos/services/study/study.hpp"
#include "progress_line.hpp"

namespace hitos::cli {

/// The exit status where a run of several failed.
inline constexpr int kSomeFailed = 2;

/// The runs of studies as they are done, on stderr.
class StudyTeller {
  public:
    /// As long as this lives.
    StudyObserver observer();
    /// A line of its own, and a new count of runs below it.
    void begin(const std::string& words);
    void finish();
    void say(const std::string& words) { line_->say(words); }

  private:
    std::optional<ProgressLine> line_{std::in_place, "run"};
    bool begun_ = false;
    std::size_t finished_ = 0;
};

/// The form of a study's summary on standard output: a table, or one of these.
struct SummaryForm {
    bool csv = false;
    bool json = false;
};
void add_summary_form(CLI::App& command, SummaryForm& form);

/// How the runs of a study are done.
struct StudyRunOptions {
    int runs = 5;
    std::uint64_t first_seed = 1;
    int threads = 0;
    double noise = 0.0;
    std::string noise_kind = "relative-sigma";
    std::string reference_trajectory;
    std::string pictures = "none";
    SummaryForm form;
};

/// --runs, --odometry-noise, --odometry-noise-kind, --reference-trajectory, --pictures, --csv
/// and --json.
void add_study_options(CLI::App& command, StudyRunOptions& options);

/// Puts runs, seeds, noise, references (the map's file, or empty) and pictures into the study.
void apply(const StudyRunOptions& options, const std::string& reference, Study& study);

/// Runs the study with progress and failures on stderr and the summary on stdout. Gives the exit
/// status: 0, or 2 where a run failed. Throws where none succeeded.
int conduct(const Study& study, const StudyRunOptions& options, const StudyShard& shard);

/// The summary of a whole study on stdout, and what is wrong with it on stderr; gives the exit
/// status.
int report(const StudyOutcome& outcome, const StudyLayout& layout, SummaryForm form);

}  // namespace hitos::cli
