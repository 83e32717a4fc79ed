#include "hitos/services/results/run_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>

#include "hitos/services/configuration/config_parameter.hpp"
#include "results_summary.hpp"

namespace hitos {
namespace {

using nlohmann::ordered_json;

constexpr std::array kFigures{
    ComparedFigure{"scans", "scans", "/scans", 0},
    ComparedFigure{"lines", "lines", "/landmarks/lines", 0},
    ComparedFigure{"corners", "corners", "/landmarks/corners", 0},
    ComparedFigure{"map_error_m", "map error (m)", "/map_error/mean_m", 3},
    ComparedFigure{"map_error_aligned_m", "aligned map error (m)", "/map_error_aligned/mean_m", 3},
    ComparedFigure{"ate_rmse_m", "ATE (m)", "/trajectory_error/ate_rmse_m", 3},
    ComparedFigure{"online_ate_rmse_m", "ATE while driving (m)", "/online_error/ate_rmse_m", 3},
    ComparedFigure{"odometry_ate_rmse_m", "odometry's ATE (m)", "/odometry_error/ate_rmse_m", 3},
    ComparedFigure{"cells_per_point", "cells per point", "/quality/cells_per_point", 4},
    ComparedFigure{"loops_closed", "loops", "/quality/loops_closed", 0},
    ComparedFigure{"run_seconds", "time (s)", "/run_seconds", 2}};

/// Of each of kFigures.
std::vector<std::optional<double>> figures_of(const std::filesystem::path& folder) {
    return with_summary(folder, [](const nlohmann::json& summary) {
        std::vector<std::optional<double>> values;
        values.reserve(kFigures.size());
        for (const ComparedFigure& figure : kFigures) {
            const nlohmann::json::json_pointer place(figure.pointer);
            values.push_back(summary.contains(place)
                                 ? std::optional(summary.at(place).get<double>())
                                 : std::nullopt);
        }
        return values;
    });
}

/// The last part of each folder's path where those tell them apart, else the paths.
void name_runs(std::vector<ComparedRun>& runs) {
    std::set<std::string> names;
    for (ComparedRun& run : runs) {
        const std::filesystem::path whole = run.folder.lexically_normal();
        run.name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
        names.insert(run.name);
    }
    if (names.size() == runs.size()) return;
    for (ComparedRun& run : runs) run.name = run.folder.string();
}

/// Leaves out the figures that no run has.
void keep_figures_there_are(RunComparison& comparison) {
    std::vector<std::vector<std::optional<double>>> kept(comparison.runs.size());
    for (std::size_t figure = 0; figure < kFigures.size(); ++figure) {
        const bool there = std::ranges::any_of(comparison.runs, [&](const ComparedRun& run) {
            return run.figures[figure].has_value();
        });
        if (!there) continue;
        comparison.figures.push_back(kFigures.at(figure));
        for (std::size_t run = 0; run < kept.size(); ++run) {
            kept[run].push_back(comparison.runs[run].figures[figure]);
        }
    }
    for (std::size_t run = 0; run < kept.size(); ++run) {
        comparison.runs[run].figures = std::move(kept[run]);
    }
}

}  // namespace

RunComparison compare_runs(std::span<const std::filesystem::path> folders) {
    RunComparison comparison;
    for (const std::filesystem::path& folder : folders) {
        comparison.runs.push_back({{}, folder, read_results(folder), figures_of(folder)});
    }
    if (comparison.runs.empty()) return comparison;
    name_runs(comparison.runs);
    keep_figures_there_are(comparison);
    const Configuracion& first = comparison.runs.front().run.configuration;
    std::set<const ConfigParameter*> different;
    for (const ComparedRun& one : comparison.runs) {
        const Configuracion& configuration = one.run.configuration;
        if (configuration.source.file != first.source.file) comparison.same_log = false;
        for (const ConfigParameter* found : differences(first, configuration))
            different.insert(found);
    }
    for (const ConfigParameter& parameter : parameters()) {
        if (different.contains(&parameter)) comparison.settings.push_back(&parameter);
    }
    return comparison;
}

TextTable comparison_table(const RunComparison& comparison) {
    TextTable table;
    table.head.emplace_back("run");
    if (!comparison.same_log) table.head.emplace_back("log");
    for (const ConfigParameter* setting : comparison.settings) {
        table.head.push_back(setting->unit.empty()
                                 ? std::string(setting->key)
                                 : fmt::format("{} ({})", setting->key, setting->unit));
    }
    for (const ComparedFigure& figure : comparison.figures) table.head.emplace_back(figure.head);
    for (const ComparedRun& one : comparison.runs) {
        std::vector<std::string> row{one.run.finished ? one.name : one.name + " (stopped)"};
        const Configuracion& configuration = one.run.configuration;
        if (!comparison.same_log) {
            row.push_back(std::filesystem::path(configuration.source.file).filename().string());
        }
        for (const ConfigParameter* setting : comparison.settings) {
            row.push_back(setting->text(configuration));
        }
        for (std::size_t i = 0; i < comparison.figures.size(); ++i) {
            row.push_back(one.figures[i] ? fmt::format("{:.{}f}", *one.figures[i],
                                                       comparison.figures[i].decimals)
                                         : kNoFigure);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string comparison_json(const RunComparison& comparison) {
    ordered_json runs = ordered_json::array();
    for (const ComparedRun& one : comparison.runs) {
        ordered_json settings = ordered_json::object();
        for (const ConfigParameter* setting : comparison.settings) {
            settings[std::string(setting->key)] = setting->text(one.run.configuration);
        }
        ordered_json figures = ordered_json::object();
        for (std::size_t i = 0; i < comparison.figures.size(); ++i) {
            const std::optional<double>& value = one.figures[i];
            figures[comparison.figures[i].name] = value ? ordered_json(*value) : ordered_json();
        }
        runs.push_back({{"folder", one.folder.string()},
                        {"log", one.run.configuration.source.file},
                        {"finished", one.run.finished},
                        {"settings", settings},
                        {"figures", figures}});
    }
    // Names of files may be no UTF-8: replace what is not instead of failing.
    return ordered_json{{"runs", runs}}.dump(2, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace hitos
