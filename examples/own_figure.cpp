// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of one's own: the length of the best path. Its entry is all there is to it; summary,
// comparison, record, tables, plot and LaTeX of a study then have it.
//
// usage: own_figure LOG FOLDER
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/results/run_comparison.hpp"
#include "hitos/services/study/study.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace {

std::optional<double> way_m(const hitos::MeasuredRun& run) {
    double way = 0.0;
    for (std::size_t i = 1; i < run.path.size(); ++i) {
        const hitos::Pose step = hitos::between(run.path[i - 1].pose, run.path[i].pose);
        way += std::hypot(step.x, step.y);
    }
    return way;
}

void work(const char* log, const std::filesystem::path& folder) {
    hitos::run_measures().add({"way_m", "way", hitos::Measure::About::path, "m", 1, "/way_m",
                               &way_m, "length of the best path", "way of the robot"});
    hitos::Configuracion configuration;
    configuration.source.file = log;
    hitos::Algoritmo run(configuration, hitos::open_tour(configuration));
    while (run.step()) {
    }
    hitos::write_results(run, {}, 1.0, folder / "run");
    const std::array runs{folder / "run"};
    std::fputs(markdown(comparison_table(hitos::compare_runs(runs))).c_str(), stdout);

    hitos::Study study;
    study.configuration = configuration;
    study.parameters.push_back(hitos::parse_study_parameter("p=5,10"));
    study.seeds = 2;
    study.layout = hitos::study_in_folder(folder / "study");
    const hitos::StudyOutcome outcome = hitos::run_studies({&study, 1}, {}).front();
    const auto cells = summarize(outcome.plan, outcome.records);
    std::fputs(summary_markdown(outcome.plan, cells).c_str(), stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: own_figure LOG FOLDER\n");
        return 1;
    }
    try {
        work(argv[1], argv[2]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
