// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/reproduction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/folder_lock.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "reproduction_parts.hpp"
#include "reproduction_remarks.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// One seed of one figure: so all runs on the same tour stand together.
struct Part {
    std::size_t figure = 0;
    std::uint64_t seed = 1;
};

std::vector<Part> order_of(const std::vector<ThesisFigure>& figures, int runs) {
    std::vector<std::string> worlds;
    for (const ThesisFigure& figure : figures) {
        if (std::ranges::find(worlds, figure.world) == worlds.end()) worlds.push_back(figure.world);
    }
    std::vector<Part> parts;
    for (const std::string& world : worlds) {
        for (int seed = 1; seed <= runs; ++seed) {
            for (std::size_t f = 0; f < figures.size(); ++f) {
                if (figures[f].world == world) {
                    parts.push_back({f, static_cast<std::uint64_t>(seed)});
                }
            }
        }
    }
    return parts;
}

Study study_of(const ThesisFigure& figure, const World& world, const Reading& reading,
               const Part& part, const fs::path& out) {
    Study study;
    study.configuration = thesis_configuration(*figure.table);
    apply(reading, study.configuration);
    study.reference = reference_map(world);
    StudyParameter parameter{figure.table->parameter, {figure.table->key}, {}};
    for (const ThesisRow& row : figure.rows) parameter.values.push_back({row.value});
    study.parameters.push_back(std::move(parameter));
    study.first_seed = part.seed;
    study.seeds = 1;
    study.setting = world_setting(world, reading);
    study.source = driven_through(world);
    study.layout = {out / "runs" / figure.stem(), fmt::format("s{}-", part.seed), "quality.csv"};
    return study;
}

/// What a figure's runs gave, value by value.
struct Gathered {
    std::vector<double> errors;
    std::vector<double> landmarks;
};

void put_into(ReproducedFigure& figure, const std::vector<Gathered>& gathered) {
    for (std::size_t i = 0; i < figure.rows.size(); ++i) {
        ReproducedRow& row = figure.rows[i];
        row.error_m = spread_of(gathered[i].errors);
        row.landmarks = spread_of(gathered[i].landmarks);
        row.bare = row.finished - static_cast<int>(gathered[i].errors.size());
    }
    judge(figure);
}

ReproducedFigure empty_figure(const ThesisFigure& thesis, const World& world) {
    constexpr double kClose = 0.5;
    constexpr double kComplex = 1.5;
    ReproducedFigure figure;
    figure.thesis = thesis;
    figure.true_landmarks = static_cast<int>(reference_map(world).size());
    figure.tolerance = thesis.world == "complex" ? kComplex : kClose;
    for (const ThesisRow& row : thesis.rows) {
        ReproducedRow& reproduced = figure.rows.emplace_back();
        reproduced.thesis = row;
        reproduced.in_range = thesis.range.holds(std::stod(row.value));
    }
    return figure;
}

Reproduction gather(const std::vector<ThesisFigure>& figures,
                    const std::map<std::string, World>& worlds, const std::vector<Part>& parts,
                    const std::vector<StudyOutcome>& outcomes) {
    Reproduction result;
    std::vector<std::vector<Gathered>> gathered;
    for (const ThesisFigure& figure : figures) {
        result.figures.push_back(empty_figure(figure, worlds.at(figure.world)));
        gathered.emplace_back(figure.rows.size());
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
        ReproducedFigure& figure = result.figures[parts[p].figure];
        const StudyOutcome& outcome = outcomes[p];
        result.computed += outcome.computed;
        result.reused += outcome.reused;
        for (std::size_t run = 0; run < outcome.records.size(); ++run) {
            const StudyRecord& record = outcome.records[run];
            if (!record.ok) {
                ++figure.rows[run].failed;
                result.failures.push_back(fmt::format("{} {}: {}", figure.thesis.stem(),
                                                      outcome.plan.label(run),
                                                      record.problem.english()));
                continue;
            }
            ++figure.rows[run].finished;
            Gathered& row = gathered[parts[p].figure][run];
            if (const auto& error = record.figures["error_m"]) row.errors.push_back(*error);
            row.landmarks.push_back(record.figures["landmarks"].value_or(0.0));
        }
    }
    for (std::size_t f = 0; f < figures.size(); ++f) put_into(result.figures[f], gathered[f]);
    return result;
}

void check(const ReproductionOptions& options) {
    constexpr int kMostRuns = 10000;
    if (options.runs < 1 || options.runs > kMostRuns) {
        throw ConfigError("--runs",
                          HITOS_TEXT("Errors", "found %1 of each value, expected 1 to %2"),
                          options.runs, kMostRuns);
    }
}

}  // namespace

std::vector<ThesisFigure> select_figures(const std::vector<ThesisFigure>& figures,
                                         const std::vector<std::string>& only) {
    if (only.empty()) return figures;
    for (const std::string& word : only) {
        if (std::ranges::none_of(figures,
                                 [&](const auto& figure) { return figure.is_named(word); })) {
            std::vector<std::string> known;
            known.reserve(figures.size());
            for (const ThesisFigure& figure : figures) known.push_back(figure.stem());
            throw ConfigError(
                "--only",
                HITOS_TEXT("Errors",
                           "found '%1', expected a figure's number, a world or a parameter of %2"),
                word, fmt::format("{}", fmt::join(known, ", ")));
        }
    }
    std::vector<ThesisFigure> selected;
    std::ranges::copy_if(figures, std::back_inserter(selected), [&](const ThesisFigure& figure) {
        return std::ranges::any_of(only, [&](const auto& word) { return figure.is_named(word); });
    });
    return selected;
}

namespace {

/// The runs and what came of them, with the table.
Reproduction run_figures(const ReproductionOptions& options) {
    Reading reading = whole_reading(options);
    const std::vector<ThesisFigure> figures =
        select_figures(read_thesis_figures(needed_file("data/results.csv")), options.only);
    std::map<std::string, World> worlds;
    for (const ThesisFigure& figure : figures) {
        if (!worlds.contains(figure.world)) {
            worlds[figure.world] = thesis_world(figure.world, reading);
        }
    }
    const std::vector<Part> parts = order_of(figures, options.runs);
    std::vector<Study> studies;
    for (const Part& part : parts) {
        const ThesisFigure& figure = figures[part.figure];
        studies.push_back(study_of(figure, worlds.at(figure.world), reading, part, options.out));
    }
    made_output_folder(options.out);
    const FolderLock lock(options.out);
    const std::vector<StudyOutcome> outcomes = run_as_one(studies, options, "plots");
    Reproduction result = gather(figures, worlds, parts, outcomes);
    result.runs = options.runs;
    result.reading = std::move(reading);
    write_file(options.out / "reproduction.csv", reproduction_csv(result));
    return result;
}

}  // namespace

Reproduction reproduce(const ReproductionOptions& options) {
    check(options);
    Reproduction result = run_figures(options);
    result.plot_problem = draw_reproduction(result, options.out / "plots");
    write_file(options.out / "reproduction.md", reproduction_markdown(result, "plots"));
    return result;
}

std::vector<Reproduction> try_readings(const ReproductionOptions& options,
                                       const Reproduction& result,
                                       const std::function<void(const Reading&)>& begin) {
    check(options);
    std::vector<Reproduction> tried;
    const auto run = [&](const Reading& reading, int runs) {
        begin(reading);
        ReproductionOptions own = options;
        own.reading = reading;
        own.out = options.out / "readings" / reading.name;
        own.runs = runs;
        tried.push_back(run_figures(own));
    };
    for (const Reading& reading : readings()) {
        if (reading.name != options.reading.name) run(reading, options.runs);
    }
    constexpr int kMoreRuns = 4;  // halves what chance does to a mean
    for (const Reading& reading : close_readings(tried)) run(reading, kMoreRuns * options.runs);
    write_file(options.out / "reproduction.md", reproduction_markdown(result, "plots", tried));
    return tried;
}

}  // namespace hitos
