// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/reproduction_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/folder_lock.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/services/evaluation/grid_blur.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/services/study/study_pictures.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "reproduction_parts.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestTile = 700;  // pixels a side: more than a sheet shows
constexpr int kTileSide = 200;     // some sixty sheets belong to the document
constexpr const char* kTimeStem = "10.95-time";
constexpr const char* kTimeWorld = "bigloop2";
constexpr const char* kTimeParticles = "p=5,10,20,50,100,200,500";

/// The study drives through the world; its landmarks are the reference.
void set_world(Study& study, const std::string& name, const ReproductionOptions& options) {
    const Reading reading = whole_reading(options);
    apply(reading, study.configuration);
    World world = thesis_world(name, reading);
    // The two large worlds have no landmarks in the thesis to compare with.
    if (name != "usc-sal" && name != "iusiani") study.reference = reference_map(world);
    study.setting = world_setting(world, reading);
    study.source = driven_through(std::move(world));
}

fs::path log_file(const ReproductionOptions& options, const ThesisExperiment& experiment) {
    return options.logs / (experiment.name + ".log.gz");
}

Study study_of_claims(const ThesisExperiment& experiment, const ReproductionOptions& options) {
    Study study;
    study.configuration = experiment_configuration(experiment);
    std::string assignment = experiment.key + "=";
    for (const ThesisClaim& claim : experiment.claims) {
        if (&claim != &experiment.claims.front()) assignment += ',';
        assignment += claim.value;
    }
    study.parameters.push_back(parse_study_parameter(assignment));
    study.seeds = experiment.runs;
    const bool maps = experiment.show == ThesisExperiment::Show::maps;
    study.pictures = maps ? StudyPictures::first : StudyPictures::none;
    if (experiment.place == ThesisExperiment::Place::world) {
        set_world(study, experiment.name, options);
    } else {
        study.configuration.source.file = log_file(options, experiment).string();
        study.reference_trajectory =
            read_trajectory(options.logs / (experiment.name + ".gt.tum.gz"));
    }
    study.layout = study_in_folder(options.out / "runs" / experiment.stem());
    return study;
}

Study time_study(const ReproductionOptions& options) {
    Study study;
    study.configuration = experiment_configuration(*std::ranges::find_if(
        thesis_experiments(), [](const ThesisExperiment& e) { return e.is_named("10.95"); }));
    study.parameters.push_back(parse_study_parameter(kTimeParticles));
    study.seeds = 1;
    set_world(study, kTimeWorld, options);
    study.layout = study_in_folder(options.out / "runs" / kTimeStem);
    return study;
}

/// The odometry's map of a tour, which all experiments on it share.
struct OdometryMap {
    SheetTile tile;
    std::optional<double> blur_m2;
};

OdometryMap odometry_map(const Study& study) {
    StudyJob job{0, study.first_seed, study.configuration};
    GridBuilder builder(study.configuration.grid, study.source.open_tour(job));
    while (builder.step()) {
    }
    OdometryMap map;
    map.tile.map = shrunk(map_image(builder.grid()), kLongestTile);
    map.tile.paths = lines_of(builder.path());
    map.blur_m2 = grid_blur_m2(builder.grid());
    return map;
}

/// Draws the sheet of the first runs and, last, the odometry.
void draw_sheet(ReproducedExperiment& experiment, const Study& study, const OdometryMap& odometry,
                const fs::path& file) {
    ContactSheet sheet;
    sheet.title = fmt::format("Figure {}: {}", experiment.thesis->figure, experiment.thesis->name);
    if (experiment.thesis->claims.size() == 1) sheet.columns = 2;
    sheet.tile_side = kTileSide;
    for (std::size_t run = 0; run < experiment.records.size(); ++run) {
        if (!experiment.plan.pictured(run)) continue;
        SheetTile tile = study_tile(study.layout, experiment.plan, run, experiment.records[run]);
        tile.map = shrunk(std::move(tile.map), kLongestTile);
        sheet.tiles.push_back(std::move(tile));
    }
    SheetTile last = odometry.tile;
    const auto& ate = experiment.records.front().figures["odometry_error_m"];
    last.caption = {"odometry alone", ate ? fmt::format("ATE {:.3f} m", *ate) : ""};
    if (odometry.blur_m2) last.caption.back() += fmt::format(", blur {:.1f} m2", *odometry.blur_m2);
    sheet.tiles.push_back(std::move(last));
    try {
        write_contact_sheet(sheet, file);
    } catch (const Error& error) {
        experiment.sheet_problem = error.what();
    }
}

void note_failures(const ReproducedExperiment& experiment, MapReproduction& result) {
    for (std::size_t run = 0; run < experiment.records.size(); ++run) {
        if (experiment.records[run].ok) continue;
        result.failures.push_back(fmt::format("{} {}: {}", experiment.thesis->stem(),
                                              experiment.plan.label(run),
                                              experiment.records[run].problem.english()));
    }
}

/// The experiments that are asked for and can be run.
std::vector<const ThesisExperiment*> select(const ReproductionOptions& options,
                                            MapReproduction& result) {
    std::vector<const ThesisExperiment*> chosen;
    for (const ThesisExperiment& experiment : thesis_experiments()) {
        const bool named =
            options.only.empty() || std::ranges::any_of(options.only, [&](const auto& word) {
                return experiment.is_named(word);
            });
        if (!named) continue;
        if (experiment.place == ThesisExperiment::Place::log) {
            std::error_code ignored;
            const fs::path log = log_file(options, experiment);
            const fs::path truth = options.logs / (experiment.name + ".gt.tum.gz");
            if (options.logs.empty() || !fs::is_regular_file(log, ignored) ||
                !fs::is_regular_file(truth, ignored)) {
                result.left_out.push_back(
                    fmt::format("{}: {}", experiment.stem(),
                                options.logs.empty()
                                    ? "no folder of recorded tours was given"
                                    : fmt::format("there is no {} with {}", log.filename().string(),
                                                  truth.filename().string())));
                continue;
            }
        }
        chosen.push_back(&experiment);
    }
    return chosen;
}

void gather_times(const StudyOutcome& outcome, const fs::path& out, MapReproduction& result) {
    std::string text = "particles,cpu_seconds,scans,seconds_per_scan\n";
    for (std::size_t run = 0; run < outcome.records.size(); ++run) {
        const StudyRecord& record = outcome.records[run];
        if (!record.ok) continue;
        const ParticleTime time{std::stoi(outcome.plan.texts(run).front()), record.cpu_seconds,
                                record.scans};
        result.times.push_back(time);
        text += fmt::format(
            "{},{:.3f},{},{:.6f}\n", time.particles, time.cpu_seconds, time.scans,
            time.cpu_seconds / static_cast<double>(std::max<std::uint64_t>(time.scans, 1)));
    }
    write_file(out / "time-against-particles.timing.csv", text);
}

}  // namespace

bool names_experiment(const std::string& word) {
    return std::ranges::any_of(thesis_experiments(), [&](const ThesisExperiment& experiment) {
        return experiment.is_named(word);
    });
}

MapReproduction reproduce_maps(const ReproductionOptions& options) {
    MapReproduction result;
    const std::vector<const ThesisExperiment*> chosen = select(options, result);
    if (chosen.empty()) return result;
    std::vector<Study> studies;
    studies.reserve(chosen.size() + 1);
    for (const ThesisExperiment* experiment : chosen) {
        studies.push_back(study_of_claims(*experiment, options));
    }
    const bool timed = std::ranges::any_of(
        chosen, [](const ThesisExperiment* experiment) { return experiment->is_named("10.95"); });
    if (timed) studies.push_back(time_study(options));
    made_output_folder(options.out);
    const FolderLock lock(options.out);
    std::vector<StudyOutcome> outcomes = run_as_one(studies, options, "maps");
    for (const StudyOutcome& outcome : outcomes) {
        result.computed += outcome.computed;
        result.reused += outcome.reused;
    }
    const fs::path sheets = made_output_folder(options.out / "maps");
    std::map<std::string, OdometryMap> odometry;
    result.experiments.reserve(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        ReproducedExperiment experiment{
            chosen[i], std::move(outcomes[i].plan), std::move(outcomes[i].records), {}, {}, {}};
        experiment.cells = summarize(experiment.plan, experiment.records);
        note_failures(experiment, result);
        if (chosen[i]->show == ThesisExperiment::Show::maps) {
            if (!odometry.contains(chosen[i]->name)) {
                odometry[chosen[i]->name] = odometry_map(studies[i]);
            }
            const OdometryMap& known = odometry.at(chosen[i]->name);
            experiment.odometry_blur_m2 = known.blur_m2;
            draw_sheet(experiment, studies[i], known, sheets / (chosen[i]->stem() + ".png"));
        }
        result.experiments.push_back(std::move(experiment));
    }
    if (timed) gather_times(outcomes.back(), options.out, result);
    write_file(options.out / "reproduction-maps.csv", map_reproduction_csv(result));
    write_file(options.out / "reproduction-maps.md", map_reproduction_markdown(result, "maps"));
    return result;
}

}  // namespace hitos
