// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_run.hpp"

#include <algorithm>
#include <utility>

#include "hitos/capture/tour_examination.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/services/run/step_figures.hpp"
#include "study_files.hpp"

namespace hitos {

std::uint64_t StudySource::seed_of(const StudyJob& job) const {
    return seeded && seeded(job.configuration.source) ? job.seed : 0;
}

std::unique_ptr<TourReader> StudySource::open_shared(const StudyJob& job) const {
    const SourceParams& source = job.configuration.source;
    return open ? open(source, seed_of(job)) : open_source(source);
}

std::unique_ptr<TourReader> StudySource::changed(std::unique_ptr<TourReader> tour,
                                                 const StudyJob& job) const {
    return change ? change(std::move(tour), job) : std::move(tour);
}

StudyJob job_of(const Study& study, const StudyPlan& plan, std::size_t run) {
    StudyJob job{run, plan.seed_of(run), study.configuration};
    const std::vector<std::string> keys = plan.keys();
    const std::vector<std::string> texts = plan.texts(plan.cell_of(run));
    for (std::size_t i = 0; i < keys.size(); ++i)
        find_parameter(keys[i]).set(job.configuration, texts[i]);
    job.configuration.run.seed = job.seed;
    job.configuration.run.threads = 1;  // the runs themselves are spread over the threads
    check(job.configuration);
    return job;
}

namespace study {
namespace {

constexpr int kLongestPicture = 2000;  // pixels a side: a kept picture is some 100 kB, not 1 GB

References references_of(const Study& study, const Algoritmo& run) {
    References references;
    if (!study.reference.empty()) references.map = study.reference;
    references.trajectory = study.reference_trajectory;
    references.relations = study.relations;
    if (!references.trajectory) {
        if (std::optional<Truth> truth = run.reader().truth())
            references.trajectory = std::move(truth->path);
    }
    return references;
}

}  // namespace

bool varies_source(const StudyPlan& plan) {
    return std::ranges::any_of(plan.keys(),
                               [](const std::string& key) { return key.starts_with("source."); });
}

bool looks_at_tour(const StudyPlan& plan, std::size_t number) {
    const auto seeds = static_cast<std::size_t>(plan.seeds);
    return number % (varies_source(plan) ? seeds : plan.runs()) == 0;
}

std::vector<Message> doubts_of_tour(const Algoritmo& run) {
    std::vector<TourFinding> found = run.reader().findings();
    if (run.examination() != nullptr) found = run.examination()->findings(std::move(found));
    std::vector<Message> doubts;
    doubts.reserve(found.size());
    for (const TourFinding& finding : found) doubts.push_back(sentence_of(finding));
    return doubts;
}

RunCalibration::RunCalibration(const TourReader& tour) {
    if (std::optional<Truth> truth = tour.truth()) truth_.emplace(std::move(truth->path));
}

void RunCalibration::note(const Algoritmo& run) {
    if (!truth_) return;
    const std::optional<double> nees = nees_of(hitos::figures_of(run, 0.0), *truth_);
    if (nees && std::isfinite(*nees)) calibration_.pose.add(*nees);
}

const Calibration* RunCalibration::counted(const Algoritmo& run, const LandmarkMap& map,
                                           const Trajectory& path, const LandmarkMap& reference) {
    if (!truth_) return nullptr;
    if (!reference.empty()) {
        count_landmarks(calibration_.landmarks, mixed_map(run.filter()), reference);
        count_distances(calibration_.distances, run.filter(), run.line_extents().of(map, path),
                        reference);
    }
    return &calibration_;
}

std::optional<StudyRecord> measure_run(const Study& study, const StudyLayout& layout,
                                       const StudyPlan& plan, std::size_t number,
                                       const Algoritmo& run, RunCalibration& calibration,
                                       const std::stop_token& stop) {
    StudyRecord record;
    const LandmarkMap map = run.filter().best_map();
    const std::filesystem::path map_path = map_file(layout, plan, number);
    write_map(map, map_path);
    record.map_digest = Digest().add_file(map_path).text();
    record.scans = run.steps();
    record.report = run.report();
    const Trajectory path = run.best_trajectory();
    ReferenceFit fit;
    if (study.reference_trajectory)
        fit = fit_of_path(in_one_frame(path, run.later_tours()), *study.reference_trajectory);
    record.reference_doubt = fit.misfit ? fit.misfit : fit.headings;
    const References references = references_of(study, run);
    const RunErrors errors = errors_of(run, map, path, references);
    if (errors.map_error) record.reference_found = errors.map_error->reference_found;
    std::optional<GridBuilder> builder;
    if (plan.grid) builder.emplace(run.configuration().grid, run.reader().reopen(), path);
    while (builder && builder->step()) {
        if (stop.stop_requested()) return std::nullopt;
    }
    const Grid* grid = builder ? &builder->grid() : nullptr;
    const RunEvidence evidence = run.evidence();
    std::vector<RunLoop> loops;
    if (evidence.registration != nullptr) {
        loops =
            run_loops(evidence.registration->loops(), evidence.registration->refused_loops(), path);
        if (references.trajectory && fit.judges_loops())
            judge_loops(loops, *references.trajectory, references.tolerance_s);
    }
    record.figures = figures_of({evidence, run.filter(), map, path, errors, grid,
                                 evidence.registration != nullptr ? &loops : nullptr,
                                 calibration.counted(run, map, path, study.reference)});
    record.stages = run.stages();
    record.state_bytes = run.state_bytes();
    if (grid != nullptr && plan.pictured(number) && !grid->empty()) {
        const MapImage image = shrunk(map_image(*grid), kLongestPicture);
        write_picture(image.picture, grid_file(layout, plan, number));
        write_trajectory(path, path_file(layout, plan, number));
        record.picture = {picture_digest(layout, plan, number), image.origin, image.m_per_pixel};
    }
    record.ok = true;
    return record;
}

}  // namespace study
}  // namespace hitos
