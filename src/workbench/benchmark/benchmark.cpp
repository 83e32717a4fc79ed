// SPDX-License-Identifier: GPL-3.0-or-later
// Does what a benchmark's plan says.
#include "hitos/workbench/benchmark.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <thread>
#include <tuple>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/workbench/configuration_choices.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/study_noise.hpp"

namespace hitos {
namespace {

/// "AMD EPYC 9R14, 2 processors, Linux 6.1.0 x86_64"
std::string machine_words() {
    std::string model;
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; model.empty() && std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            model = line.substr(colon + 2);
        }
    }
    utsname system{};
    uname(&system);
    return fmt::format(
        "{}{} processors, {} {} {}", model.empty() ? "" : model + ", ",
        std::thread::hardware_concurrency(), static_cast<const char*>(system.sysname),
        static_cast<const char*>(system.release), static_cast<const char*>(system.machine));
}

/// The name as part of a path: another one for every name.
std::string file_word(const std::string& name) {
    std::string word = name;
    for (char& c : word) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                           (c >= 'A' && c <= 'Z') || c == '.' || c == '-' || c == '+';
        if (!plain) c = '_';
    }
    if (word.starts_with('.')) word.front() = '_';  // neither hidden nor the folder above
    constexpr std::size_t kLongest = 80;
    constexpr std::size_t kTold = 6;
    if (word.size() > kLongest) word.resize(kLongest);
    return word == name ? word : word + "-" + Digest().add(name).text().substr(0, kTold);
}

}  // namespace

std::string digest_of_tour(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> files = log_files(path);
    std::error_code ignored;
    std::erase_if(files, [&](const std::filesystem::path& file) {
        return !std::filesystem::exists(file, ignored);  // what a recording may have
    });
    if (files.size() < 2) return Digest().add_file(files.empty() ? path : files.front()).text();
    Digest digest;
    for (const std::filesystem::path& file : files)
        digest.add(file.filename().string()).add_file(file);
    return digest.text();
}

namespace {

/// What the tour's file is, if it is what the plan means. Throws Error.
std::string checked_source(const BenchmarkTour& tour) {
    std::string source = source_named(tour.file);
    std::error_code ignored;
    if (!std::filesystem::exists(source, ignored) && !tour.address.empty()) {
        throw FileError(source, HITOS_TEXT("Errors", "is not there; it can be had from %1"),
                        tour.address);
    }
    if (tour.digest.empty()) return source;
    const std::string found = digest_of_tour(source);
    const auto upper = [](unsigned char letter) { return std::toupper(letter); };
    if (!std::ranges::equal(found, tour.digest, {}, upper, upper)) {
        throw FileError(source,
                        HITOS_TEXT("Errors",
                                   "is another file than the plan means: its digest is "
                                   "%1, expected %2"),
                        found, tour.digest);
    }
    return source;
}

Configuracion configuration_of(const BenchmarkTour& tour, const BenchmarkAlgorithm& algorithm,
                               const std::string& source) {
    Configuracion configuration =
        !algorithm.config.empty()         ? ArchivoConfiguracion::read(algorithm.config)
        : algorithm.preset == kAutoPreset ? suited_configuration(source)
                                          : preset_configuration(algorithm.preset);
    configuration.source.file = source;
    ValueChoices choices;
    choices.assignments = algorithm.settings;
    choices.assignments.insert(choices.assignments.end(), tour.settings.begin(),
                               tour.settings.end());
    choose_values(configuration, choices);
    return configuration;
}

constexpr const char* kNoRelation =
    "no pose is within 0.02 s of both times of any of the relations: are the clocks the same?";

/// The studies of a plan and the rows that they fill, in the plan's order.
class Work {
  public:
    Work(const BenchmarkPlan& plan, const BenchmarkOptions& options)
        : plan_(plan), options_(options) {
        for (const BenchmarkTour& tour : plan.tours) {
            for (const BenchmarkAlgorithm& algorithm : plan.algorithms) add(tour, algorithm);
            for (const BenchmarkPeer& peer : plan.peers)
                if (peer.tour == tour.name) add(tour, peer);
        }
    }

    std::vector<BenchmarkRow> run(bool& stopped) {
        StudyOptions how;
        how.threads = options_.threads;
        how.shard = options_.shard;
        how.observer = options_.observer;
        how.stop = options_.stop;
        const std::vector<StudyOutcome> outcomes = run_studies(studies_, how);
        for (std::size_t i = 0; i < outcomes.size(); ++i) fill(rows_[places_[i]], i, outcomes[i]);
        stopped = std::ranges::any_of(outcomes, &StudyOutcome::stopped);
        return std::move(rows_);
    }

  private:
    BenchmarkRow& new_row(const BenchmarkTour& tour, const std::string& name) {
        rows_.emplace_back();
        rows_.back().tour = tour.name;
        rows_.back().algorithm = name;
        return rows_.back();
    }

    void add(const BenchmarkTour& tour, const BenchmarkAlgorithm& algorithm) {
        BenchmarkRow& row = new_row(tour, algorithm.name);
        try {
            Study study;
            study.configuration = configuration_of(tour, algorithm, checked_source(tour));
            study.first_seed = plan_.first_seed;
            study.seeds = plan_.runs;
            study.pictures = options_.pictures ? StudyPictures::first : StudyPictures::none;
            if (!tour.map.empty()) {
                study.reference = read_map(tour.map);
                row.reference_landmarks = static_cast<int>(study.reference.size());
            }
            if (!tour.trajectory.empty()) {
                study.reference_trajectory = read_trajectory(tour.trajectory);
            }
            if (!tour.relations.empty()) study.relations = read_relations(tour.relations);
            study.layout = study_in_folder(options_.out / "runs" / file_word(tour.name) /
                                           file_word(algorithm.name));
            set_study_source(study, tour.noise, tour.noise_kind);
            set_study_copies(study, tour.copies);
            row.setting = study.setting;
            try_study(study);
            studies_.push_back(std::move(study));
            places_.push_back(rows_.size() - 1);
        } catch (const Error& error) {
            row.failed = plan_.runs;
            row.problem = error.what();
        }
    }

    /// A tour that cannot be begun is a row, not the end of all.
    static void try_study(const Study& study) {
        const StudyPlan plan = plan_study(study);
        const std::unique_ptr<TourReader> tour = study.source.open_tour(job_of(study, plan, 0));
        if (study.reference_trajectory) fit_of_reference(*tour, *study.reference_trajectory);
    }

    void add(const BenchmarkTour& tour, const BenchmarkPeer& peer) {
        BenchmarkRow& row = new_row(tour, peer.name);
        row.peer = true;
        try {
            const Trajectory path = read_trajectory(peer.trajectory);
            if (tour.trajectory.empty()) {
                throw Error(marked(HITOS_TEXT(
                    "Errors", "the tour names no trajectory to measure a peer's against")));
            }
            const Trajectory reference = read_trajectory(tour.trajectory);
            for (const Advice& doubt : fit_of_reference(path, reference).doubts())
                remark(row, doubt.words());
            const auto take = [&](const char* word, double figure) {
                row.figures[word] = spread_of({&figure, 1});
            };
            const double error = trajectory_error(path, reference).value().rmse_m;
            take("trajectory_error_m", error);
            for (const auto& [word, turn, length_m] :
                 {std::tuple("rpe_1m_m", "rpe_1m_turn_deg", 1.0),
                  std::tuple("rpe_10m_m", "rpe_10m_turn_deg", 10.0)}) {
                const auto relative = relative_error(path, reference, {.length = length_m});
                if (!relative) continue;
                take(word, relative->translation_m.rmse);
                take(turn, relative->rotation_rad.rmse * 180.0 / kPi);
            }
            if (!tour.relations.empty()) {
                const RelationErrors relations =
                    relation_errors(measure_relations(path, read_relations(tour.relations)));
                if (relations.used > 0) {
                    take("relations_m", relations.translation_m.mean);
                    take("relations_turn_deg", relations.rotation_rad.mean * 180.0 / kPi);
                } else {
                    remark(row, std::string(kNoRelation));
                }
            }
            row.runs = 1;
            row.hash = Digest()
                           .add_file(peer.trajectory)
                           .add_file(tour.trajectory)
                           .add(fmt::format("{}", error))
                           .text();
        } catch (const Error& error) {
            row.failed = 1;
            row.problem = error.what();
        }
    }

    static void remark(BenchmarkRow& row, const std::string& words) {
        if (!row.remark.empty()) row.remark += ' ';
        row.remark += words;
    }

    void fill(BenchmarkRow& row, std::size_t place, const StudyOutcome& outcome) const {
        const StudyCell cell = summarize(outcome.plan, outcome.records).front();
        row.runs = cell.finished;
        row.figures = cell.figures;
        Digest hash;
        for (const StudyRecord& record : outcome.records) {
            if (!record.ok) {
                if (!record.problem.empty()) ++row.failed;
                if (row.problem.empty()) row.problem = record.problem.english();
                continue;
            }
            hash.add(record.map_digest);
            for (const Measure* measure : taken_measures()) {
                // The grid is not always drawn.
                if (measure->about == Measure::About::grid) continue;
                const auto& figure = record.figures[*measure];
                hash.add(figure ? fmt::format("{} {}", measure->word, *figure) : "");
            }
            row.cpu_seconds += record.cpu_seconds / cell.finished;
            row.scans += static_cast<double>(record.scans) / cell.finished;
            row.state_bytes = std::max(row.state_bytes, static_cast<double>(record.state_bytes));
            if (!record.stages) continue;
            if (!row.stages) row.stages.emplace();
            for (std::size_t i = 0; i < kRunStages.size(); ++i)
                row.stages->at(i) += record.stages->at(i) / cell.finished;
        }
        if (row.runs == plan_.runs) row.hash = hash.text();
        for (const Advice& doubt : outcome.doubts) remark(row, doubt.words());
        for (const Message& doubt : outcome.tour_doubts) remark(row, doubt.english() + ".");
        if (const StudyRecord* damaged = most_damaged(outcome.records)) {
            remark(
                row,
                fmt::format(
                    "The log is damaged: lines skipped: {}, stamps that did not "
                    "advance: {}{}.",
                    damaged->report.skipped, damaged->report.stamps_backwards,
                    damaged->report.examples.empty()
                        ? ""
                        : "; the first: " +
                              damaged->report.placed(damaged->report.examples.front()).english()));
        }
        if (!studies_[place].relations.empty() && row.runs > 0 && !row.figures["relations_m"])
            remark(row, std::string(kNoRelation));
        const std::filesystem::path sheet = studies_[place].layout.file("contact-sheet.png");
        std::error_code ignored;
        if (outcome.records.front().picture && std::filesystem::exists(sheet, ignored)) {
            row.map = sheet.lexically_relative(options_.out);
        }
    }

    const BenchmarkPlan& plan_;
    const BenchmarkOptions& options_;
    std::vector<BenchmarkRow> rows_;
    std::vector<Study> studies_;
    std::vector<std::size_t> places_;  // of each study's row
};

}  // namespace

BenchmarkTable run_benchmark(const BenchmarkPlan& plan, const BenchmarkOptions& options) {
    made_output_folder(options.out);
    BenchmarkTable table;
    table.title = plan.title;
    table.program = build_identity();
    table.version = version();
    table.machine = machine_words();
    table.runs = plan.runs;
    table.first_seed = plan.first_seed;
    table.rows = Work(plan, options).run(table.stopped);
    return table;
}

}  // namespace hitos
