// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/run_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>

#include "hitos/services/configuration/config_parameter.hpp"
#include "json_input.hpp"

namespace hitos {
namespace {

using nlohmann::ordered_json;

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

/// Those that a run has; counts first.
std::vector<const Measure*> figures_there_are(std::span<const ComparedRun> runs) {
    std::vector<const Measure*> figures;
    for (const Measure& measure : run_measures().entries()) {
        if (std::ranges::any_of(runs, [&](const ComparedRun& one) {
                return one.run.figures[measure].has_value();
            })) {
            figures.push_back(&measure);
        }
    }
    std::stable_partition(figures.begin(), figures.end(),
                          [](const Measure* figure) { return figure->is_count(); });
    return figures;
}

}  // namespace

RunComparison compare_runs(std::span<const std::filesystem::path> folders) {
    RunComparison comparison;
    for (const std::filesystem::path& folder : folders) {
        comparison.runs.push_back({{}, folder, read_results(folder)});
    }
    if (comparison.runs.empty()) return comparison;
    name_runs(comparison.runs);
    comparison.figures = figures_there_are(comparison.runs);
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
        table.head.push_back(with_unit(setting->key, setting->unit));
    }
    for (const Measure* figure : comparison.figures) {
        table.head.push_back(with_unit(
            figure->compared_label.empty() ? figure->label : figure->compared_label, figure->unit));
    }
    for (const ComparedRun& one : comparison.runs) {
        std::vector<std::string> row{one.run.finished ? one.name : one.name + " (stopped)"};
        const Configuracion& configuration = one.run.configuration;
        if (!comparison.same_log) {
            row.push_back(std::filesystem::path(configuration.source.file).filename().string());
        }
        for (const ConfigParameter* setting : comparison.settings) {
            row.push_back(setting->text(configuration));
        }
        for (const Measure* figure : comparison.figures) {
            const std::optional<double>& value = one.run.figures[*figure];
            row.push_back(value ? figure->rounded(*value, false) : kNoFigure);
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
        for (const Measure* figure : comparison.figures) {
            const std::optional<double>& value = one.run.figures[*figure];
            figures[figure->compared_word.empty() ? figure->word : figure->compared_word] =
                value ? ordered_json(*value) : ordered_json();
        }
        runs.push_back({{"folder", one.folder.string()},
                        {"log", one.run.configuration.source.file},
                        {"finished", one.run.finished},
                        {"settings", settings},
                        {"figures", figures}});
    }
    return json_text({{"runs", runs}});
}

}  // namespace hitos
