// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of results, by their summary.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/results/results_check.hpp"
#include "hitos/workbench/thesis_figures.hpp"
#include "laws.hpp"
#include "targets.hpp"

namespace hitos::fuzz {
namespace {

/// The files of a run that a window reads beside the summary.
const ScratchFolder& folder_of_a_run() {
    static const ScratchFolder scratch;
    static const bool filled = [] {
        constexpr std::string_view kPath = "0 0 0 0 0 0 0 1\n0.2 0.1 0 0 0 0 0 1\n";
        scratch.put("config.cfg", "[filter]\nparticles = 10\n");
        scratch.put("map.txt", "rho: 1 theta: 90\nx: 1 y: 1\n");
        scratch.put("segments.txt", "-1 1 1 1 1\n");
        scratch.put("trajectory.tum", kPath);
        scratch.put("odometry.tum", kPath);
        return true;
    }();
    static_cast<void>(filled);
    return scratch;
}

}  // namespace

bool check_summary(std::string_view input) {
    const ScratchFolder& folder = folder_of_a_run();
    folder.put("summary.json", input);
    const auto run = unless_refused([&] { return read_results(folder.path()); });
    if (run) {
        require(std::isfinite(run->seconds), "the time of a run is finite");
        for (const Measure& measure : run_measures().entries()) {
            require(is_finite_if_any(run->figures[measure]), "the figures of a run are finite");
        }
        require(run->path.size() == 2 && run->odometry.size() == 2, "a run has its paths");
    }
    const auto check = unless_refused([&] { return check_results(folder.path()); });
    if (check) {
        require(check->files > 0, "a summary that is checked names files");
        require(check->missing.size() + check->changed.size() <= check->files,
                "only files that are named are missed");
        for (const auto* names : {&check->missing, &check->changed, &check->left_over}) {
            require(std::ranges::none_of(*names,
                                         [](const std::string& name) {
                                             return name.find('/') != std::string::npos;
                                         }),
                    "files lie in the folder");
        }
    }
    return run || check;
}

bool check_figures(std::string_view input) {
    const auto figures = unless_refused([&] { return read_thesis_figures(file_of(input)); });
    if (!figures) return false;
    for (const ThesisFigure& figure : *figures) {
        require(figure.table != nullptr && !figure.rows.empty(), "a figure has a table and rows");
        require(std::ranges::all_of(figure.rows,
                                    [](const ThesisRow& row) {
                                        return is_finite_if_any(row.error_m) &&
                                               std::isfinite(row.error_variance) &&
                                               std::isfinite(row.landmarks);
                                    }),
                "the figures of the thesis are finite");
    }
    return true;
}

}  // namespace hitos::fuzz
