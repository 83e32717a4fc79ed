// SPDX-License-Identifier: GPL-3.0-or-later
// The document and the table of the experiments shown by maps.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "hitos/workbench/reproduction_maps.hpp"
#include "reproduction_parts.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using Place = ThesisExperiment::Place;

constexpr std::string_view kIntroduction = R"(# Reproduction of the thesis's maps and counts

`hitos-cli reproduce` wrote this document: the experiments of chapter 10 that the thesis shows by grid
maps, by counts or in words, beside [those with tables of errors](reproduction.md).

```sh
hitos-cli reproduce --report docs/reproduction.md --logs FOLDER
```

* The thesis's recordings (USC SAL building, laboratory of the IUSIANI) are not published. The worlds
  `usc-sal` and `iusiani` stand in for them: places like them, driven with the noise of the other
  reproductions (laser sigma 3 mm, odometry with relative sigma 0.1). With `--logs` the same questions
  are put to recorded tours of the public data set Radish (`aces`, recorded by Patrick Beeson;
  `freiburg-101`, by Cyrill Stachniss), whose files `NAME.log.gz` and `NAME.gt.tum.gz` the folder has.
* Fixed parameters are those of the thesis's table. The robot's numbers are standard deviations per
  scan, as in the other reproduction. One run of each value, with seed 1, where the thesis shows a map;
  5 runs where it states errors.
* ATE: root mean square distance of the path to the true one after rigid alignment (recorded tours: to
  the path that a grid mapper found). Blur: the area that the grid map leaves undecided, which tells
  how crisp it is: lower is better, and it compares maps of one tour only (docs/studies.md).
* Maps: path red, from X to O; the last one is the odometry's.

)";

std::string mean(const std::optional<Spread>& spread, int decimals) {
    return spread ? fmt::format("{:.{}f}", spread->mean, decimals) : "";
}

/// "0.003" of "0.003/0.003".
std::string shown(std::string_view value) {
    const std::size_t slash = value.find('/');
    const bool same =
        slash != std::string_view::npos && value.substr(0, slash) == value.substr(slash + 1);
    return std::string(same ? value.substr(0, slash) : value);
}

std::string place_text(const ThesisExperiment& thesis) {
    return thesis.place == Place::world
               ? fmt::format("world `{}`, table {}", thesis.name, thesis.table)
               : fmt::format("recorded tour `{}`, preset `recorded-fastslam1`", thesis.name);
}

/// Those that are not varied.
std::string settings_text(const ThesisExperiment& thesis) {
    std::vector<std::string> settings;
    for (const std::string& setting : thesis.settings) {
        if (thesis.key.find(setting.substr(0, setting.find('='))) == std::string::npos) {
            settings.push_back(setting);
        }
    }
    return settings.empty() ? "" : fmt::format(" with `{}`", fmt::join(settings, "`, `"));
}

std::string experiment_text(const ReproducedExperiment& experiment, const std::string& sheets) {
    const ThesisExperiment& thesis = *experiment.thesis;
    const bool words = std::ranges::any_of(
        thesis.claims, [](const ThesisClaim& claim) { return !claim.says.empty(); });
    const bool reference = experiment.plan.has_reference();
    const bool grid = experiment.plan.grid;
    std::string text =
        fmt::format("### Figure {}, {}: `{}`\n\n{}{}; runs of each value: {}.\n\n| {} |",
                    thesis.figure, thesis.name, thesis.key, place_text(thesis),
                    settings_text(thesis), thesis.runs, thesis.parameter);
    text += words ? " the thesis says |" : "";
    text += reference ? " error (m) |" : "";
    text += " lines | corners | ATE (m) |";
    text += grid ? " blur (m²) |\n" : "\n";
    const int columns = 4 + (words ? 1 : 0) + (reference ? 1 : 0) + (grid ? 1 : 0);
    text += "|";
    for (int i = 0; i < columns; ++i) text += "---|";
    text += "\n";
    for (std::size_t i = 0; i < experiment.cells.size(); ++i) {
        const StudyCell& cell = experiment.cells[i];
        text += fmt::format("| {} |", shown(thesis.claims[i].value));
        if (words) text += fmt::format(" {} |", thesis.claims[i].says);
        if (reference) text += fmt::format(" {} |", mean(cell.figures["error_m"], 3));
        const int decimals = thesis.runs > 1 ? 1 : 0;
        text += fmt::format(" {} | {} | {} |", mean(cell.figures["lines"], decimals),
                            mean(cell.figures["corners"], decimals),
                            mean(cell.figures["trajectory_error_m"], 3));
        if (grid) text += fmt::format(" {} |", mean(cell.figures["blur_m2"], 1));
        text += "\n";
    }
    if (grid && thesis.show == ThesisExperiment::Show::maps) {
        text += "| odometry alone |";
        for (int i = 0; i < columns - 3; ++i) text += " |";
        text += fmt::format(" {} | {} |\n",
                            mean(experiment.cells.front().figures["odometry_error_m"], 3),
                            text_or(experiment.odometry_blur_m2, "{:.1f}", ""));
    }
    if (!thesis.remark.empty()) text += fmt::format("\n{}\n", thesis.remark);
    if (thesis.show == ThesisExperiment::Show::maps) {
        text += experiment.sheet_problem.empty()
                    ? fmt::format("\n![maps of figure {}]({}/{}.png)\n", thesis.figure, sheets,
                                  thesis.stem())
                    : fmt::format("\nThere is no sheet: {}.\n", experiment.sheet_problem);
    }
    return text + "\n";
}

/// Pairs stand together, since they all show the same.
bool is_pair(const ReproducedExperiment& experiment) {
    return experiment.thesis->claims.size() == 1 &&
           experiment.thesis->show == ThesisExperiment::Show::maps;
}

std::string pairs_text(const MapReproduction& reproduction, const std::string& sheets) {
    std::string rows;
    for (const ReproducedExperiment& experiment : reproduction.experiments) {
        if (!is_pair(experiment)) continue;
        const ThesisExperiment& thesis = *experiment.thesis;
        const StudyCell& cell = experiment.cells.front();
        rows += fmt::format(
            "| [{}]({}/{}.png) | {} | {} = {} | {} | {} | {} | {} | {} |\n", thesis.figure, sheets,
            thesis.stem(), thesis.name, thesis.parameter, thesis.claims.front().value,
            mean(cell.figures["error_m"], 3), mean(cell.figures["trajectory_error_m"], 3),
            mean(cell.figures["odometry_error_m"], 3), mean(cell.figures["blur_m2"], 1),
            text_or(experiment.odometry_blur_m2, "{:.1f}", ""));
    }
    if (rows.empty()) return "";
    return "## Pairs: the best particle's map and the odometry's\n\n"
           "The thesis shows that SLAM's map is true to the place and the odometry's is not. The "
           "number "
           "of\na figure leads to its sheet. Blur does not tell the two apart in small worlds: the "
           "particles'\npath trembles by a centimetre, which smears the walls a little, and the "
           "odometry's is smooth and\nwrong. The caption of figure 10.94 says 20 particles and its "
           "text "
           "150, which were taken.\n\n"
           "| figure | world | value | error (m) | ATE (m) | odometry's ATE (m) | blur (m²) | "
           "odometry's blur (m²) |\n|---|---|---|---|---|---|---|---|\n" +
           rows + "\n";
}

/// Figure 10.95: one value in several worlds.
bool is_steady(const ReproducedExperiment& experiment) {
    return experiment.thesis->claims.size() == 1 &&
           experiment.thesis->show == ThesisExperiment::Show::counts;
}

std::string steady_text(const MapReproduction& reproduction) {
    std::string rows;
    for (const ReproducedExperiment& experiment : reproduction.experiments) {
        if (!is_steady(experiment)) continue;
        const StudyCell& cell = experiment.cells.front();
        rows +=
            fmt::format("| {} | {} | {} | {} | {} | {} |\n", experiment.thesis->name,
                        experiment.thesis->claims.front().says, mean(cell.figures["error_m"], 3),
                        mean(cell.figures["lines"], 1), mean(cell.figures["corners"], 1),
                        mean(cell.figures["trajectory_error_m"], 3));
    }
    if (rows.empty()) return "";
    return "## Figure 10.95: the error that more particles no longer lessen\n\n"
           "100 particles, table 10.17, 5 runs. As in the thesis it is much the same in all worlds "
           "but\n`complex`. What a run costs against the number of particles is measured too: in\n"
           "`time-against-particles.timing.csv` beside the results, and in docs/evaluation.md.\n\n"
           "| world | the thesis says | error (m) | lines | corners | ATE (m) |\n"
           "|---|---|---|---|---|---|\n" +
           rows + "\n";
}

std::string sections(const MapReproduction& reproduction, const std::string& sheets, Place place,
                     std::string_view title) {
    std::string text;
    for (const ReproducedExperiment& experiment : reproduction.experiments) {
        if (experiment.thesis->place == place && !is_pair(experiment) && !is_steady(experiment)) {
            text += experiment_text(experiment, sheets);
        }
    }
    return text.empty() ? "" : fmt::format("## {}\n\n{}", title, text);
}

}  // namespace

std::string map_reproduction_csv(const MapReproduction& reproduction) {
    std::string text =
        "figure,place,parameter,value,seed,status,error_m,lines,corners,ate_m,odometry_ate_m,"
        "blur_m2,odometry_blur_m2\n";
    for (const ReproducedExperiment& experiment : reproduction.experiments) {
        const ThesisExperiment& thesis = *experiment.thesis;
        for (std::size_t run = 0; run < experiment.records.size(); ++run) {
            const StudyRecord& record = experiment.records[run];
            const auto figure = [&](const char* word, const char* otherwise) {
                return text_or(record.figures[word], "{}", otherwise);
            };
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", thesis.figure, thesis.name,
                thesis.parameter, shown(thesis.claims[experiment.plan.cell_of(run)].value),
                experiment.plan.seed_of(run), record.ok ? "ok" : "failed", figure("error_m", ""),
                figure("lines", "0"), figure("corners", "0"), figure("trajectory_error_m", ""),
                figure("odometry_error_m", ""), figure("blur_m2", ""),
                text_or(experiment.odometry_blur_m2, "{}", ""));
        }
    }
    return text;
}

std::string map_reproduction_markdown(const MapReproduction& reproduction,
                                      const std::string& sheets) {
    std::string text(kIntroduction);
    text += pairs_text(reproduction, sheets);
    text += steady_text(reproduction);
    text += sections(reproduction, sheets, Place::world, "Values of a parameter, simulated tours");
    text += sections(reproduction, sheets, Place::log, "The same questions to recorded tours");
    if (!reproduction.left_out.empty()) {
        text += "## Left out\n\n";
        for (const std::string& reason : reproduction.left_out)
            text += fmt::format("* {}.\n", reason);
        text += "\n";
    }
    text.pop_back();
    return text;
}

void write_map_report(const MapReproduction& reproduction, const fs::path& document,
                      const fs::path& sheets) {
    std::vector<std::string> stems;
    for (const ReproducedExperiment& experiment : reproduction.experiments) {
        stems.push_back(experiment.thesis->stem());
    }
    write_with_pictures(document, sheets, stems, [&](const std::string& folder) {
        return map_reproduction_markdown(reproduction, folder);
    });
}

}  // namespace hitos
