// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli run: one log in; map, trajectory, pictures and summary out.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "damage.hpp"
#include "former_run.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/results/optional_outputs.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "hitos/services/run/step_hashes.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "live_run.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "report.hpp"
#include "run_words.hpp"
#include "serve_run.hpp"

namespace hitos::cli {
namespace {

struct RunOptions {
    ConfigurationOptions configuration;
    std::string log;
    SourceOptions source;
    std::string reference;
    std::string reference_trajectory;
    double tolerance_s = kSameStamp;
    CLI::Option* tolerance = nullptr;
    std::string distances;
    std::string figures;
    std::string hashes;
    bool times = false;
    bool uncertainty = false;
    bool strict = false;
    std::optional<std::size_t> grid_of;
    std::string write;
    std::string out;
    bool replace = false;
    bool json = false;
    LiveOptions live;
    std::string serve;
};

constexpr int kNotWhole = 2;  // the program's status

void check_particle(const std::optional<std::size_t>& particle,
                    const Configuracion& configuration) {
    const std::size_t count = hypothesis_count(configuration.filter);
    if (!particle || *particle < count) return;
    throw ConfigError(
        "--grid-of",
        verbatim(fmt::format("found particle {}; {} has {}, numbered from 0 to {}", *particle,
                             configuration.filter.algorithm, count, count - 1)));
}

/// The map to go on with is made anew of its tour: it is another one where its run had others.
void tell_other_parameters(const Configuracion& configuration) {
    if (configuration.source.map.empty()) return;
    std::vector<std::string> changed;
    for (const ConfigParameter* parameter :
         differences(configuration_to_go_on(configuration.source.map), configuration)) {
        const bool of_map = parameter->key != std::string_view(kGraphEditsKey) ||
                            !changes_of_map(configuration).empty();
        if (of_map && !parameter->key.starts_with("source.")) changed.emplace_back(parameter->key);
    }
    if (changed.empty()) return;
    fmt::print(stderr,
               "the map of {} is made with other parameters than in its run, and is another one: "
               "{}\n",
               on_one_line(configuration.source.map), fmt::join(changed, ", "));
}

/// Errors and warnings number them by the list, in which those of the map come last.
void tell_changes_of_map(const Configuracion& configuration) {
    if (configuration.source.map.empty()) return;
    const std::vector<GraphEdit> all = parse_graph_edits(configuration.registration.edits);
    const std::vector<GraphEdit> of_map =
        parse_graph_edits(configuration_to_go_on(configuration.source.map).registration.edits);
    std::size_t first = all.size();
    while (first > 0 && has_change(of_map, all[first - 1])) --first;
    if (first == all.size()) return;
    fmt::print(stderr, "changes by hand from no. {} on are those of the map of {}\n", first + 1,
               on_one_line(configuration.source.map));
}

/// A long run is not to end with what could be known before it.
void check_file(const std::filesystem::path& file) {
    if (std::filesystem::is_directory(file)) {
        throw FileError(file.string(), verbatim("is a folder; expected the name of a file"));
    }
    const std::filesystem::path folder = file.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder)) {
        throw FileError(file, verbatim("cannot be written: there is no folder " + folder.string() +
                                       "; create it first"));
    }
    if (!file.empty()) AtomicFile(file).write("");  // not committed, it leaves nothing behind
}

/// What is written is none of what is read, and what stands beside the results is none of them.
void check_outputs(const RunOptions& options, std::vector<std::filesystem::path> inputs) {
    using Path = std::filesystem::path;
    for (const std::string& file :
         {options.reference, options.reference_trajectory, options.distances}) {
        inputs.emplace_back(file);
    }
    const std::array<Path, 3> beside{options.figures, options.hashes, options.live.poses};
    check_apart(beside, inputs);
    std::error_code ignored;
    for (const Path& file : inputs) {
        if (!file.empty() && is_results_file(file.filename()) &&
            std::filesystem::equivalent(file.parent_path().empty() ? "." : file.parent_path(),
                                        options.out, ignored)) {
            check_apart({&file, 1}, inputs);  // throws
        }
    }
    const Path results =
        std::filesystem::weakly_canonical(Path(options.out) / "x", ignored).parent_path();
    for (const Path& file : beside) {
        if (is_results_file(file.filename()) &&
            std::filesystem::weakly_canonical(file, ignored).parent_path() == results) {
            throw FileError(file, verbatim("is the name of one of the results; choose another one "
                                           "for the table"));
        }
    }
}

/// Watches the log while it is run through: whether it is still the one that the run began with.
class LogWatch {
  public:
    explicit LogWatch(const std::vector<std::filesystem::path>& files) : inputs_(files) {}

    /// Whether it has changed; `scans` were read by now. The first answer that it has stays.
    bool changed(std::uint64_t scans) {
        try {
            if (!problem_) {
                inputs_.check();
                unchanged_for_ = scans;
            }
        } catch (const FileError& error) {
            problem_ = error;
        }
        return changed();
    }
    bool changed() const { return problem_.has_value(); }
    /// Throws what that answer was, even where another look finds nothing.
    void check() const {
        if (problem_) throw FileError(*problem_);
    }
    const InputFiles& inputs() const { return inputs_; }
    std::string words(std::uint64_t scans) const {
        return fmt::format(
            "{}; the results are of the first {}, of which {} surely read before that",
            problem_->what(), plural(scans, "scan"), unchanged_for_);
    }

  private:
    InputFiles inputs_;
    std::optional<FileError> problem_;
    std::uint64_t unchanged_for_ = 0;
};

/// Whatever ends a run, its worker is not to wait for more.
struct EndOfFollowing {
    std::optional<LiveRun>& live;
    ~EndOfFollowing() {
        if (live) live->end();
    }
};

/// Those without which a run has fewer files; a world has its own reference, unless an earlier
/// run's map is gone on with.
std::vector<std::string> given_options(const RunOptions& options, const SourceParams& source) {
    const bool world = is_world_file(source.file) && source.map.empty();
    std::vector<std::string> given;
    const auto note = [&given](bool whether, const char* option) {
        if (whether) given.emplace_back(option);
    };
    note(!options.distances.empty(), "--distances");
    note(options.uncertainty, "--uncertainty");
    if (options.grid_of) given.push_back(fmt::format("--grid-of {}", *options.grid_of));
    note(world || !options.reference.empty(), "--reference");
    note(world || !options.reference_trajectory.empty(), "--reference-trajectory");
    return given;
}

[[noreturn]] void end_before_the_first_scan() {
    fmt::print(stderr, "stopped before the first scan; nothing is written\n");
    throw CLI::RuntimeError(StopByRequest::status());
}

void run(const RunOptions& options, std::optional<LiveRun>& live) {
    // Before there is anything to be cleared. Of a tour that is followed the first request is its
    // end, and what follows on that takes its time.
    const StopByRequest request(options.live.follow ? StopByRequest::Patience::endless
                                                    : StopByRequest::Patience::two_seconds);
    std::optional<ServeRun> serve;  // first: its port may be another's
    if (!options.serve.empty()) serve.emplace(options.serve, options.log);
    ReadOptions opening;
    if (options.live.follow) {
        if (options.configuration.file == "-" || options.configuration.file == "/dev/stdin") {
            throw ConfigError("--config", verbatim("found \"-\"; with --follow a configuration "
                                                   "comes from a file"));
        }
        const StagedFolder probe(results_folder(options.out));  // before anything is waited for
        SourceParams wanted = load(options.configuration, {}).source;
        options.source.choose(wanted);
        live.emplace(options.live, options.log, options.out, options.replace);
        if (live->file().empty() || !live->wait_for_opening(wanted)) end_before_the_first_scan();
        opening = wanted.read;
    }
    const std::string source = live ? live->file() : source_named(input_named(options.log, "log"));
    expect_used(options.configuration.values, options.source.topics, {source});
    const std::string_view suited = suited_preset(options.configuration, source);
    Configuracion configuration = load(options.configuration, suited);
    fmt::print(stderr, "{}", suited_words(suited, source));
    configuration.source.file = source;
    options.source.choose(configuration.source);
    if (live) {
        configuration.source.read.opening_bytes = opening.opening_bytes;
        configuration.source.read.growth = opening.growth;
    }
    tell_other_parameters(configuration);
    tell_changes_of_map(configuration);
    if (const Message doubt = doubt_of_going_on(configuration.source, configuration.run.seed);
        !doubt.empty()) {
        fmt::print(stderr, "warning: {}\n", on_one_line(doubt.english()));
    }
    check_particle(options.grid_of, configuration);
    const std::vector<std::string> also = chosen_outputs(options.write, "--write");
    References references = references_named(options.reference, options.reference_trajectory);
    references.tolerance_s = options.tolerance_s;
    // A world has its true path.
    if (options.tolerance->count() > 0 && !references.trajectory && !is_world_file(source)) {
        throw ConfigError("--tolerance", verbatim("is of the stamps of a reference trajectory, and "
                                                  "there is none; give --reference-trajectory"));
    }
    if (!options.distances.empty())
        references.distances = read_distances(input_named(options.distances, "--distances"));
    const std::vector<std::filesystem::path> tour = tour_files(configuration.source);
    check_outputs(options, tour);
    if (live) live->open_poses();
    std::unique_ptr<StagedFolder> folder(new StagedFolder(results_folder(options.out)));
    if (!options.replace)
        refuse_another_run(options.out, configuration, also,
                           given_options(options, configuration.source));
    check_file(options.figures);  // which may be in that folder
    check_file(options.hashes);

    std::vector<std::filesystem::path> watched = tour;
    if (live) std::erase(watched, std::filesystem::path(source));  // it changes all the time
    LogWatch log(watched);
    std::unique_ptr<TourReader> reader = open_tour(configuration);
    // Of a tour that is still to come nothing can be said.
    if (references.trajectory && !live)
        fit_of_reference(*reader, *references.trajectory, references.tolerance_s);
    add_truth(references, reader->truth());
    AlgoritmoOptions run_options;
    run_options.uncertainty = options.uncertainty;
    run_options.grid_of = options.grid_of;
    run_options.figures = !options.figures.empty();
    run_options.time_stages = options.times;
    run_options.doubts_ahead = true;
    std::optional<OdometryGridAhead> odometry_grid;
    if (configuration.run.threads != 1 && std::thread::hardware_concurrency() > 1) {
        odometry_grid.emplace(configuration.grid);
        run_options.taken = [&odometry_grid](const Scan& scan, const Pose& pose) {
            odometry_grid->add(scan, pose);
        };
    }
    StepHashes hashes;
    if (live || !options.hashes.empty()) {
        run_options.stepped = [&](const Algoritmo& run) {
            if (live) live->note(run);
            if (!options.hashes.empty()) hashes.note(run);
        };
    }
    RunWorker worker(configuration, std::move(reader), run_options);
    const EndOfFollowing end{live};  // else the worker would wait for more
    ProgressLine line("scan");
    bool stopped = false;
    worker.run();
    Progress progress = worker.progress();
    while (progress.state == Progress::State::running) {
        if (live) live->look(worker, line);
        if (serve) serve->look(worker, live ? live->behind_s() : std::nullopt);
        if (!stopped && ((StopByRequest::wanted() && !live) || log.changed(progress.steps))) {
            worker.pause();
            stopped = true;
        }
        worker.wait_for(std::chrono::milliseconds(20));
        progress = worker.progress();
        line.show(
            progress.steps, progress.fraction,
            plural(progress.lines + progress.corners, "landmark") + (live ? live->behind() : ""));
    }
    if (live) live->tell_news(line);
    if (progress.state == Progress::State::failed) throw Error(progress.error);
    if (serve) serve->look_at_end(worker);
    // Of the last scans of all nobody would know.
    const bool finished = progress.state == Progress::State::finished;
    if ((finished || progress.steps == 0) && log.changed(progress.steps)) log.check();
    if (stopped && progress.steps == 0) end_before_the_first_scan();
    stopped = !finished;
    const double seconds = line.seconds();
    const std::string landmarks = plural(progress.lines + progress.corners, "landmark");
    if (stopped) {
        line.say(fmt::format("stopped: {} done  {}", plural(progress.steps, "scan"), landmarks));
    } else {
        line.finish(progress.steps, landmarks);
    }
    if (stopped && !live && tell_kept(options.out)) {
        log.check();
        throw CLI::RuntimeError(StopByRequest::status());
    }

    ProgressLine files("file");
    const WritingObserver told = [&](const WritingProgress& now) {
        // It is read once more for the grids.
        if (!log.changed()) log.inputs().check();
        files.show(now.number - 1,
                   static_cast<double>(now.number - 1) / static_cast<double>(now.count), now.file);
    };
    const auto write = [&] {
        return worker
            .with_run([&](const Algoritmo& run) {
                return write_results(run, references, seconds, *folder, told,
                                     odometry_grid ? &*odometry_grid : nullptr, also, [&] {
                                         return log.changed() || (StopByRequest::wanted() && !live);
                                     });
            })
            .get();
    };
    RunSummary summary;
    try {
        summary = write();
    } catch (const FileError&) {
        if (log.changed() || !log.changed(progress.steps)) throw;
        // All scans are of the log as it was; what reads it again is left out.
        folder.reset();
        // NOLINTNEXTLINE(modernize-make-unique): it cannot be moved
        folder.reset(new StagedFolder(results_folder(options.out)));
        summary = write();
    }
    files.finish(summary.files.size());
    Report report(options.json);
    tell_summary(summary, options.out, report);
    if (summary.times) tell_times(*summary.times, summary.scans, report);
    if (live) {
        live->replace_former();
        live->tell(report);
    }
    if (report.is_json()) {
        report.object()["folder"] = options.out;
        if (!suited.empty()) report.object()["suited_preset"] = suited;
        report.object().update(parsed_object(to_json(summary, seconds)));
    }
    bool whole = summary.not_written.empty();
    const auto beside = [&](const std::string& file, const auto& write_it) {
        try {
            if (!file.empty()) write_it();
        } catch (const Error& error) {
            report.warn(fmt::format("not written: {}", error.what()));
            report.object()["not_written"].push_back({{"file", file}, {"reason", error.what()}});
            whole = false;
        }
    };
    beside(options.figures, [&] {
        write_figures(worker.figures_since(0),
                      references.trajectory ? &*references.trajectory : nullptr, options.figures,
                      references.tolerance_s);
    });
    beside(options.hashes, [&] { write_file(options.hashes, hashes.csv()); });
    if (live && live->poses_problem()) {
        report.warn("not written: " + *live->poses_problem());
        report.object()["not_written"].push_back(
            {{"file", options.live.poses}, {"reason", *live->poses_problem()}});
        whole = false;
    }
    report.end();
    if (log.changed()) throw Error(verbatim(log.words(progress.steps)));
    if (live && live->problem()) throw FileError(*live->problem());
    if (stopped || (!whole && !live && StopByRequest::wanted()))
        throw CLI::RuntimeError(StopByRequest::status());
    if (options.strict && !whole) throw CLI::RuntimeError(kNotWhole);
}

void run(const RunOptions& options) {
    std::optional<LiveRun> live;
    try {
        run(options, live);
    } catch (...) {
        if (live) live->tell_early_end();
        throw;
    }
}

/// "svg (map.svg: a figure), …": all that --write knows.
std::string write_choices() {
    std::string text;
    for (const OptionalOutput& output : optional_outputs()) {
        fmt::format_to(std::back_inserter(text), "{}{} ({}: {})", text.empty() ? "" : "; ",
                       output.word, fmt::join(output.files, ", "), output.purpose);
    }
    return text;
}

}  // namespace

void add_run(CLI::App& program) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* command =
        program.add_subcommand("run", "Build a landmark map from a log or a simulated tour");
    command
        ->add_option(
            "log", options->log,
            "Log file, plain or .gz, ROS recording (bag, MCAP, .db3, folder), or a world file "
            "(.toml) to simulate, or the name of a world that comes with Hitos; - for standard "
            "input")
        ->required();
    add_source_options(*command, options->source);
    add_configuration_options(*command, options->configuration);
    command->add_option("--reference", options->reference,
                        "Reference map (docs/formats.md) to measure the map against");
    command->add_option("--reference-trajectory", options->reference_trajectory,
                        "Reference trajectory in TUM format to measure the path against and to "
                        "draw beside it (default for a world: the true one)");
    options->tolerance = add_tolerance_option(*command, options->tolerance_s);
    command->add_option("--distances", options->distances,
                        "Named distances between parallel walls (docs/formats.md) to measure in "
                        "the map: printed, and in distances.csv");
    command->add_flag("--uncertainty", options->uncertainty,
                      "Record the standard deviations of every landmark scan by scan: "
                      "uncertainty.csv and .png");
    command->add_option("--grid-of", options->grid_of,
                        "Draw the grid along this particle's own path too, as "
                        "grid_particle_NUMBER.png and .jpg: a number from 0 on");
    command
        ->add_option("--figures", options->figures,
                     "Write the figures of every scan (Neff, weights, landmarks, features, "
                     "events, position error, time) into this CSV file (docs/formats.md)")
        ->check(&complaint_of_output);
    command
        ->add_option("--hashes", options->hashes,
                     "Write hashes of the whole state after every scan into this CSV file "
                     "(docs/determinism.md); hitos-cli compare names the first scan in which two "
                     "such files differ")
        ->check(&complaint_of_output);
    command->add_flag("--times", options->times,
                      "Say where the processor time went: reading, features, registration and its "
                      "parts, filter, files; in summary.json too, under times");
    command->add_option("--write", options->write,
                        "Write further files (docs/formats.md), by their names or these words with "
                        "commas between, or all: " +
                            write_choices());
    command->add_flag("--strict", options->strict,
                      "End with status 2 where a file that a run can do without was not written");
    command
        ->add_option("--out", options->out,
                     "Folder for the results, made if missing; one that holds those of a run of "
                     "another source or with other parameters, or more files of this one, is "
                     "refused")
        ->required()
        ->check(&complaint_of_output);
    command->add_flag("--replace", options->replace,
                      "Put this run in the place of another one, or of more files of this one, "
                      "that the folder holds");
    add_live_options(*command, options->live);
    add_serve_option(*command, options->serve);
    add_report_option(*command, options->json);
    command->callback([options] { run(*options); });
}

}  // namespace hitos::cli
