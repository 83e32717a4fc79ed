// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/thread_clock.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "json_input.hpp"
#include "shared_readings.hpp"
#include "study_files.hpp"
#include "study_folder.hpp"
#include "study_inputs.hpp"
#include "study_run.hpp"

namespace hitos {
namespace {

using study::StudyFolder;

/// One run of one study, in the order of all.
struct Task {
    std::size_t study = 0;
    std::size_t run = 0;
};

/// How long a run takes, from when it can begin.
class Stopwatch {
  public:
    /// The run is at its end; what comes measures it.
    void stop() {
        end_ = std::chrono::steady_clock::now();
        cpu_end_ = thread_seconds();
        stopped_ = true;
    }
    /// Until it was stopped, else until now.
    void note(StudyRecord& record) {
        if (!stopped_) stop();
        record.seconds = std::chrono::duration<double>(end_ - start_).count();
        record.cpu_seconds = cpu_end_ - cpu_start_;
    }

  private:
    bool stopped_ = false;
    std::chrono::steady_clock::time_point end_ = {};
    double cpu_end_ = 0.0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double cpu_start_ = thread_seconds();
};

/// A log that cannot be opened, or that the reference is not of, ends the study at its start, not
/// run by run; where the log is what varies, each run finds out for itself.
void try_source(const Study& study, StudyOutcome& outcome) {
    const StudyPlan& plan = outcome.plan;
    if (study::varies_source(plan)) return;
    StudyJob job{0, plan.first_seed, study.configuration};
    job.configuration.run.seed = job.seed;
    const std::unique_ptr<TourReader> tour = study.source.open_tour(job);
    if (!study.reference_trajectory) return;
    outcome.doubts = fit_of_reference(*tour, *study.reference_trajectory).doubts();
}

/// Of one run's map, since all of them are of one place.
void doubt_map(const Study& study, StudyOutcome& outcome) {
    const auto good = std::ranges::find_if(outcome.records, [](const StudyRecord& record) {
        return record.ok && record.figures["landmarks"].value_or(0.0) > 0.0;
    });
    if (study.reference.empty() || good == outcome.records.end()) return;
    const auto run = static_cast<std::size_t>(good - outcome.records.begin());
    const LandmarkMap map = read_map(study::map_file(study.layout, outcome.plan, run));
    if (const auto doubt = doubt_of_map(map, study.reference)) outcome.doubts.push_back(*doubt);
}

/// Of most runs' paths: one alone may have gone wrong.
void doubt_path(StudyOutcome& outcome) {
    const auto doubted = [](const StudyRecord& record) {
        return record.reference_doubt.has_value();
    };
    const auto first = std::ranges::find_if(outcome.records, doubted);
    const auto good = std::ranges::count_if(outcome.records, &StudyRecord::ok);
    if (2 * std::ranges::count_if(outcome.records, doubted) > good)
        outcome.doubts.push_back(*first->reference_doubt);
}

/// Does all tasks on a number of threads and tells the observer.
class Crew {
  public:
    Crew(std::span<const Study> studies, std::span<const StudyFolder> folders,
         std::span<const InputFiles> inputs, std::span<StudyOutcome> outcomes,
         std::vector<Task> tasks, const StudyOptions& options)
        : studies_(studies),
          folders_(folders),
          inputs_(inputs),
          outcomes_(outcomes),
          tasks_(std::move(tasks)),
          options_(options),
          shared_(options.shared_bytes, options.stop),
          parts_(tasks_.size(), 0.0) {
        progress_.runs = tasks_.size();
        for (const StudyOutcome& outcome : outcomes) progress_.reused += outcome.reused;
        for (const StudyFolder& folder : folders) {
            if (folder.is_beside()) progress_.replaces.push_back(folder.place());
        }
        for (const Task& task : tasks_) expect(task);
    }

    void work() {
        // Of it nobody hears later, where all runs are found done.
        if (options_.observer && !progress_.replaces.empty()) options_.observer(progress_);
        int threads = options_.threads;
        if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
        const std::size_t count =
            std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), 1,
                                    std::max<std::size_t>(tasks_.size(), 1));
        {
            std::vector<std::jthread> crew;
            for (std::size_t i = 0; i < count; ++i) crew.emplace_back([this] { work_on(); });
        }
        if (broken_) std::rethrow_exception(broken_);
        if (changed_.empty()) return;
        throw FileError(changed_,
                        HITOS_TEXT("Errors",
                                   "has changed while it was being worked on; %1 of %2 runs were "
                                   "done before, of the file as it was, and the others are left "
                                   "out; start again when the file is complete"),
                        progress_.finished + progress_.reused - progress_.failed,
                        progress_.runs + progress_.reused);
    }

  private:
    void expect(const Task& task) {
        try {
            const Study& study = studies_[task.study];
            shared_.expect(study, job_of(study, outcomes_[task.study].plan, task.run));
        } catch (const ConfigError&) {
            return;  // the run will say so
        }
    }

    void work_on() {
        try {
            for (std::size_t place = next_++; place < tasks_.size(); place = next_++) {
                if (stopped_ || options_.stop.stop_requested()) return;
                do_task(place);
            }
        } catch (...) {
            // Only the observer, or the lack of memory, comes here: no run can tell of it.
            const std::scoped_lock lock(mutex_);
            if (!broken_) broken_ = std::current_exception();
            stopped_ = true;
        }
    }

    void do_task(std::size_t place) {
        const auto [s, run] = tasks_[place];
        const StudyPlan& plan = outcomes_[s].plan;
        tell(place, 0.0, nullptr);
        Stopwatch watch;
        StudyRecord record;
        // Nobody knows of the folder in which the work is really done.
        const auto told = [&](std::size_t at, const Error& error) {
            return error.message().replaced(folders_[at].work().folder.string(),
                                            studies_[at].layout.folder.string());
        };
        try {
            std::optional<StudyRecord> computed = compute(place, watch);
            if (!computed) return;
            record = *std::move(computed);
        } catch (const Error& error) {
            record.problem = told(s, error);
        } catch (const std::bad_alloc&) {
            record.problem = out_of_memory();
        } catch (const std::exception& error) {
            record.problem = message(HITOS_TEXT("Errors", "internal error: %1"), error.what());
        }
        if (!is_utf8(record.problem.english())) {
            record.problem = verbatim(in_utf8(record.problem.english()));
        }
        watch.note(record);
        try {
            inputs_[s].check();
        } catch (const FileError& error) {
            const std::scoped_lock lock(mutex_);
            changed_ = error.path();  // told when all have ended, for they are counted
            stopped_ = true;
            return;
        }
        try {
            study::write_record(folders_[s].work(), plan, run, record);
        } catch (const Error& error) {
            record.ok = false;
            record.figures = {};
            record.problem = told(s, error);
        }
        outcomes_[s].records[run] = record;
        tell(place, 1.0, &record);
    }

    /// Nothing where the study was stopped before the run's end.
    std::optional<StudyRecord> compute(std::size_t place, Stopwatch& watch) {
        const auto [s, number] = tasks_[place];
        const Study& study = studies_[s];
        const StudyPlan& plan = outcomes_[s].plan;
        const StudyJob job = job_of(study, plan, number);
        const study::SharedReadings::Use use(shared_, study, job);
        study::SharedReadings::Parts parts = use.parts();
        if (parts.shared) watch = {};  // reading for several runs is no run's own work
        const bool looks = study::looks_at_tour(plan, number);
        Algoritmo run(job.configuration, std::move(parts.reader),
                      // What is shared lies in memory already, and what is not found no room there.
                      {.step_grid = false,
                       .remember_bytes = 0,
                       .examine = looks,
                       .time_stages = true,
                       .extractor = std::move(parts.extractor)});
        constexpr std::uint64_t kTellEvery = 64;
        study::RunCalibration calibration(run.reader());
        while (run.step()) {
            calibration.note(run);
            if (options_.stop.stop_requested()) return std::nullopt;
            if (run.steps() % kTellEvery == 0) {
                tell(place, run.reader().progress().value_or(0.0), nullptr);
            }
        }
        watch.stop();
        auto record = study::measure_run(study, folders_[s].work(), plan, number, run, calibration,
                                         options_.stop);
        if (record && looks) record->tour_doubts = study::doubts_of_tour(run);
        return record;
    }

    /// `part` of the task is done; with its record, all of it.
    void tell(std::size_t place, double part, const StudyRecord* record) {
        const std::scoped_lock lock(mutex_);
        const auto [s, run] = tasks_[place];
        sum_ += part - parts_[place];
        parts_[place] = part;
        progress_.failure.clear();
        if (record != nullptr) {
            ++progress_.finished;
            ++outcomes_[s].computed;
            if (!record->ok) {
                ++progress_.failed;
                ++outcomes_[s].failed;
                progress_.failure = outcomes_[s].plan.label(run) + ": " + record->problem.english();
            }
            if (options_.listener) options_.listener(outcomes_[s].plan, run, *record);
        }
        if (!options_.observer) return;
        progress_.running = outcomes_[s].plan.label(run);
        progress_.running_number = place + 1;
        progress_.fraction = progress_.finished == progress_.runs
                                 ? 1.0
                                 : std::clamp(sum_ / static_cast<double>(progress_.runs), 0.0, 1.0);
        options_.observer(progress_);
    }

    std::span<const Study> studies_;
    std::span<const StudyFolder> folders_;
    std::span<const InputFiles> inputs_;
    std::span<StudyOutcome> outcomes_;
    std::vector<Task> tasks_;
    const StudyOptions& options_;
    study::SharedReadings shared_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stopped_ = false;

    std::mutex mutex_;  // guards all below
    StudyProgress progress_;
    std::vector<double> parts_;
    double sum_ = 0.0;
    std::exception_ptr broken_;
    std::string changed_;  // the file that is no longer what it was
};

Message missing_runs(const StudyPlan& plan, const std::vector<std::size_t>& missing) {
    constexpr std::size_t kNamed = 3;
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < std::min(kNamed, missing.size()); ++i)
        labels.push_back(plan.label(missing[i]));
    return message(
        HITOS_TEXT("Errors",
                   "%1 of %2 runs are not there: %3%4; start the shards that lack them again"),
        missing.size(), plan.runs(), fmt::format("{}", fmt::join(labels, ", ")),
        missing.size() > kNamed ? ", …" : "");
}

/// Copies what the shard has finished of the plan's runs.
void gather(StudyFolder& folder, const StudyLayout& shard) {
    for (std::size_t run = 0; run < folder.plan().runs(); ++run) {
        const auto record = study::read_record(shard, folder.plan(), run);
        if (!record) continue;
        // A failure does not replace another shard's success.
        const auto known = study::read_record(folder.work(), folder.plan(), run);
        if (known && (known->ok || !record->ok)) continue;
        folder.reopen();
        study::copy_run(shard, folder.work(), folder.plan(), run, *record);
    }
}

/// Who may work on the study beside this process.
StudyFolder::Keep keep_of(const StudyOptions& options) {
    if (!options.locks) return StudyFolder::Keep::not_kept;
    return options.shard.whole() ? StudyFolder::Keep::alone : StudyFolder::Keep::shared;
}

void publish(StudyFolder& folder, StudyOutcome& outcome) {
    // A study without a single result does not take another one's place.
    const bool nothing = std::ranges::none_of(outcome.records, &StudyRecord::ok);
    if (folder.is_beside() && nothing) {
        folder.discard();
        return;
    }
    const StudyFolder::Problems problems = folder.publish(outcome.records, true);
    outcome.plot_problem = problems.plots;
    outcome.picture_problem = problems.pictures;
    outcome.beside = false;
}

}  // namespace

void check_whole(std::span<const StudyOutcome> outcomes) {
    std::size_t done = 0;
    std::size_t runs = 0;
    for (const StudyOutcome& outcome : outcomes) {
        done += outcome.computed + outcome.reused - outcome.failed;
        runs += outcome.plan.runs();
    }
    const bool stopped = std::ranges::any_of(outcomes, &StudyOutcome::stopped);
    if (!stopped) return;
    throw StudyStopped(
        message(HITOS_TEXT("Errors", "stopped: %1 of %2 runs are done"), done, runs));
}

void check_any(const StudyOutcome& outcome) {
    if (outcome.stopped || outcome.failed == 0 ||
        outcome.failed != outcome.computed + outcome.reused) {
        return;
    }
    const auto first = std::ranges::find_if(
        outcome.records, [](const StudyRecord& record) { return !record.problem.empty(); });
    if (first == outcome.records.end()) return;
    throw Error(message(HITOS_TEXT("Errors", "every run failed; the first: %1"), first->problem));
}

std::vector<StudyOutcome> run_studies(std::span<const Study> studies, const StudyOptions& options) {
    std::vector<StudyOutcome> outcomes;
    std::vector<InputFiles> inputs;
    for (const Study& study : studies) {
        InputFiles files(study::all_input_files(study));
        outcomes.emplace_back().plan = plan_study(study);
        files.check();  // what the digest is of
        inputs.push_back(std::move(files));
        try_source(study, outcomes.back());
    }
    std::vector<StudyFolder> folders;
    folders.reserve(studies.size());
    for (std::size_t s = 0; s < studies.size(); ++s)
        folders.emplace_back(studies[s].layout, outcomes[s].plan, keep_of(options));
    std::vector<Task> tasks;
    std::size_t number = 0;
    for (std::size_t s = 0; s < studies.size(); ++s) {
        StudyOutcome& outcome = outcomes[s];
        folders[s].begin();
        outcome.beside = folders[s].is_beside();
        if (!options.shard.whole()) folders[s].share();
        outcome.records.resize(outcome.plan.runs());
        for (std::size_t run = 0; run < outcome.plan.runs(); ++run, ++number) {
            if (!options.shard.takes(number)) continue;
            const auto record = folders[s].done(run);
            if (record && record->ok) {
                outcome.records[run] = *record;
                ++outcome.reused;
                if (options.listener) options.listener(outcome.plan, run, *record);
            } else {
                tasks.push_back({s, run});
            }
        }
        if (!tasks.empty() && tasks.back().study == s) folders[s].reopen();
    }
    const std::size_t to_do = tasks.size();
    Crew(studies, folders, inputs, outcomes, std::move(tasks), options).work();
    std::size_t done = 0;
    for (const StudyOutcome& outcome : outcomes) done += outcome.computed;
    if (done < to_do) {
        for (StudyOutcome& outcome : outcomes) outcome.stopped = true;
        return outcomes;
    }
    if (options.tables && options.shard.whole()) {
        for (std::size_t s = 0; s < studies.size(); ++s) {
            publish(folders[s], outcomes[s]);
            doubt_map(studies[s], outcomes[s]);
            doubt_path(outcomes[s]);
            outcomes[s].tour_doubts = tour_doubts(outcomes[s].records);
        }
    }
    return outcomes;
}

StudyOutcome merge_study(const StudyLayout& layout, std::span<const StudyLayout> shards) {
    for (const StudyLayout& shard : shards) {
        if (!study::same(study::read_plan(shard), study::read_plan(shards.front()))) {
            throw FormatError(study::plan_file(shard).string(), 0,
                              HITOS_TEXT("Errors",
                                         "is of another study than %1: program, configuration, "
                                         "log, values or seeds differ"),
                              study::plan_file(shards.front()).string());
        }
    }
    StudyFolder folder = shards.empty() ? StudyFolder::of_last(layout)
                                        : StudyFolder(layout, study::read_plan(shards.front()),
                                                      StudyFolder::Keep::alone);
    folder.begin();
    StudyOutcome outcome;
    outcome.plan = folder.plan();
    for (const StudyLayout& shard : shards) gather(folder, shard);
    std::vector<std::size_t> missing;
    for (std::size_t run = 0; run < outcome.plan.runs(); ++run) {
        auto record = folder.done(run);
        if (!record) missing.push_back(run);
        if (record && !record->ok) ++outcome.failed;
        outcome.records.push_back(record.value_or(StudyRecord{}));
    }
    if (!missing.empty()) {
        for (const StudyLayout& shard : shards)
            for (const std::size_t run : missing) study::expect_no_record(shard, outcome.plan, run);
        throw Error(message("%1: %2", layout.folder.string(), missing_runs(outcome.plan, missing)));
    }
    outcome.reused = outcome.plan.runs() - outcome.failed;
    outcome.tour_doubts = tour_doubts(outcome.records);
    publish(folder, outcome);
    return outcome;
}

}  // namespace hitos
