// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: many runs over values of parameters and seeds, in parallel, resumable, in shards
// [T 8.2.2.11, 10.3].
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/message.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/evaluation/suitability.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/study/study_result.hpp"
#include "hitos/services/study/study_shard.hpp"
#include "hitos/services/study/study_values.hpp"

namespace hitos {

/// One run that is to be done: its configuration has values and seed set.
struct StudyJob {
    std::size_t run = 0;
    std::uint64_t seed = 0;
    Configuracion configuration;
};

/// Gives runs their tours; called on several threads at once.
struct StudySource {
    /// A tour before anything that is a run's own. Runs of one setting whose [source] and seed are
    /// the same are given what was read from one of them. Null: the log that [source] names.
    std::function<std::unique_ptr<TourReader>(const SourceParams&, std::uint64_t seed)> open = {};
    /// Whether a run's seed decides that tour; where not, the seed is 0. Null: never.
    std::function<bool(const SourceParams&)> seeded = {};
    /// Makes its odometry the run's own and leaves its scans alone. Null: as it is.
    std::function<std::unique_ptr<TourReader>(std::unique_ptr<TourReader>, const StudyJob&)>
        change = {};

    /// The seed that the run's tour is opened with.
    std::uint64_t seed_of(const StudyJob& job) const;
    std::unique_ptr<TourReader> open_shared(const StudyJob& job) const;
    std::unique_ptr<TourReader> changed(std::unique_ptr<TourReader> tour,
                                        const StudyJob& job) const;
    /// The run's tour, with all that is its own.
    std::unique_ptr<TourReader> open_tour(const StudyJob& job) const {
        return changed(open_shared(job), job);
    }
};

/// What to do. A study is a value; several of them can be run at one go.
struct Study {
    Configuracion configuration;
    LandmarkMap reference;  ///< empty: none; runs are then measured by their paths and grids
    /// The true path, in any frame, of the log's clock. Where it is not given, the tour is asked.
    std::optional<Trajectory> reference_trajectory;
    std::vector<PoseRelation> relations;  ///< to be measured, of the log's clock
    /// Grids are drawn, and their blur measured, where pictures are asked for or there is no
    /// reference map: they cost about a fifth of a run of 100 particles.
    StudyPictures pictures = StudyPictures::none;
    std::vector<StudyParameter> parameters;  ///< none, one or two
    std::uint64_t first_seed = 1;
    int seeds = 5;
    StudySource source;
    /// The files of which the tour of a log is made, by whose content a run is known; null: the
    /// log.
    std::function<std::vector<std::filesystem::path>(const std::string& log)> inputs;
    std::string setting;  ///< must tell apart sources that differ beyond the log's content
    StudyLayout layout;
};

/// Whether a study can vary the parameter: it sets seeds and threads itself and draws no grid.
bool can_be_varied(const ConfigParameter& parameter);

/// Checks the study and lays out its runs. Throws ConfigError for what no run could do: bad base
/// configuration, too many parameters, no values, the same value twice, keys in two parameters,
/// keys without effect.
StudyPlan plan_study(const Study& study);
/// Likewise, where another program (build_identity()) does the runs.
StudyPlan plan_study(const Study& study, const std::string& program);

/// What the plan's run is. Throws ConfigError where a value is not possible.
StudyJob job_of(const Study& study, const StudyPlan& plan, std::size_t run);

/// How far run_studies has come.
struct StudyProgress {
    std::size_t runs = 0;      ///< to do, of all studies; those found done are not among them
    std::size_t finished = 0;  ///< of these, the failed among them
    std::size_t failed = 0;
    std::size_t reused = 0;  ///< found done
    /// Folders, or quality files, of other studies, of which these take the places once they are
    /// whole.
    std::vector<std::filesystem::path> replaces;
    double fraction = 0.0;           ///< of the runs to do, running ones counted by their part
    std::string running;             ///< label of a run under way
    std::size_t running_number = 0;  ///< its number, from 1
    std::string failure;             ///< a run that has just failed, with the reason; else empty
};
using StudyObserver = std::function<void(const StudyProgress&)>;

/// Told of every run that is done, those found done first; by one thread at a time.
using StudyListener =
    std::function<void(const StudyPlan&, std::size_t run, const StudyRecord& record)>;

/// How a study is done; nothing here changes its results.
struct StudyOptions {
    int threads = 0;  ///< runs at a time; 0: as many as the machine has
    StudyShard shard;
    bool tables = true;  ///< write tables and plots of whole studies at the end
    /// Told of every start and end of a run and now and then between, by one thread at a time.
    StudyObserver observer;
    StudyListener listener;
    /// Whether each study is kept for this process while it runs; shards share theirs. Not where
    /// the caller keeps the folder of all, and wants no tables: another study's runs then make way
    /// one by one.
    bool locks = true;
    std::stop_token stop;  ///< ends the study within a step; what is done stays done
    /// The most that is kept of tours and features that several runs have in common [bytes]; what
    /// is more, each run reads and extracts anew.
    std::size_t shared_bytes = std::size_t{256} << 20;
};

/// What came of a study.
struct StudyOutcome {
    StudyPlan plan;
    /// Run by run; where the shard is not the whole, those of other shards are not ok and have an
    /// empty problem.
    std::vector<StudyRecord> records;
    std::size_t computed = 0;
    std::size_t reused = 0;
    std::size_t failed = 0;
    std::vector<Advice> doubts;             ///< whether the references are those of this tour
    std::vector<Message> tour_doubts = {};  ///< what looks wrong in the tours themselves
    bool beside = false;                    ///< another study's results are still in place
    bool stopped = false;     ///< before every run was done: there are no tables and plots
    Message plot_problem;     ///< why there are no plots; empty where there are, and for shards
    Message picture_problem;  ///< likewise of the contact sheet
};

/// Thrown by what needs whole studies where they were stopped.
class StudyStopped : public Error {
  public:
    using Error::Error;
};
/// Throws StudyStopped, which says how many runs are done, where the studies were stopped.
void check_whole(std::span<const StudyOutcome> outcomes);
/// Throws Error with the first reason where the study is done and every run has failed.
void check_any(const StudyOutcome& outcome);

/// Runs what is not yet done of every study, spreading all runs over the threads, each run on one
/// thread. A run's map and record are written when it ends, whole or not at all, so a study that
/// was stopped in any way goes on where it was. Where the folder holds another study, its files
/// stay until this one's are complete, and all of them change places together. The results do not
/// depend on threads, shards, stops or order. Failed runs are recorded and tried anew the next
/// time. A whole study ends with its tables and plots; a shard leaves them to merge_study. Throws
/// what ends everything: see plan_study, FileError for the output, and what opening the log and
/// fit_of_reference() throw (where the logs are what varies, each run is told for itself).
std::vector<StudyOutcome> run_studies(std::span<const Study> studies, const StudyOptions& options);

/// Gathers the runs of the shards' folders (none: they are all in `layout` already) and writes
/// tables and plots, byte for byte as one process would have. Throws Error that names the missing
/// runs where there are some, FormatError where the folders hold different studies or damaged
/// files.
StudyOutcome merge_study(const StudyLayout& layout, std::span<const StudyLayout> shards = {});

}  // namespace hitos
