// SPDX-License-Identifier: GPL-3.0-or-later
// Reads data/thesis: the tables of fixed parameters, and the experiments shown by maps and counts.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/text_limits.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/thesis_experiments.hpp"
#include "hitos/workbench/thesis_figures.hpp"
#include "toml_entry.hpp"

namespace hitos {
namespace {

/// One thing made of every entry [[name]] of a file.
template <class Thing>
std::vector<Thing> read_entries(const std::filesystem::path& path, std::string_view name,
                                Thing (*made)(TomlEntry&)) {
    const std::string file = path.string();
    const std::string text = input::read_text(path, input::kLargestSettings);
    std::vector<Thing> things;
    try {
        const toml::table document = toml::parse(input::checked_toml(text, file));
        const toml::array* entries = document[name].as_array();
        if (entries == nullptr || !entries->is_array_of_tables() || document.size() != 1) {
            throw FormatError(file, 0, HITOS_TEXT("Errors", "%1: expected %2"), name,
                              "a list of tables and nothing else");
        }
        for (const toml::node& node : *entries) {
            TomlEntry entry(file, *node.as_table());
            things.push_back(made(entry));
            entry.end();
        }
    } catch (const toml::parse_error& error) {
        throw FormatError(file, error.source().begin.line,
                          verbatim(std::string(error.description())));
    }
    return things;
}

ThesisTable table_of(TomlEntry& entry) {
    ThesisTable table{entry.text("parameter"),
                      entry.text("key"),
                      entry.text("unit"),
                      entry.text("number"),
                      entry.text("section"),
                      entry.words("settings"),
                      {}};
    const auto good = entry.rows<std::string, double, double>("good", "[[world, least, greatest]]");
    for (const auto& [world, least, greatest] : good)
        table.ranges.push_back({world, {least, greatest}});
    return table;
}

ThesisExperiment experiment_of(TomlEntry& entry) {
    ThesisExperiment experiment;
    experiment.figure = entry.text("figure");
    experiment.parameter = entry.text("parameter");
    const bool recorded = entry.has("log");
    experiment.place = recorded ? ThesisExperiment::Place::log : ThesisExperiment::Place::world;
    experiment.name = entry.text(recorded ? "log" : "world");
    if (entry.has("key")) {
        experiment.key = entry.text("key");
        experiment.table = recorded ? "" : entry.text("table");
        experiment.settings = entry.words("settings");
    } else {
        const ThesisTable& table = find_thesis_table(experiment.parameter);
        experiment.key = table.key;
        experiment.table = table.table;
        experiment.settings = table.settings;
    }
    experiment.show = entry.value_or("counts", false, "true or false")
                          ? ThesisExperiment::Show::counts
                          : ThesisExperiment::Show::maps;
    experiment.runs = entry.value_or("runs", 1, "a whole number");
    for (auto& [value, says] : entry.rows<std::string, std::string>("claims", "[[value, says]]")) {
        experiment.claims.push_back({value, says});
    }
    experiment.remark = entry.value_or("remark", std::string(), "a text in quotes");
    return experiment;
}

}  // namespace

std::vector<ThesisTable> read_thesis_tables(const std::filesystem::path& path) {
    return read_entries(path, "table", table_of);
}

std::vector<ThesisExperiment> read_thesis_experiments(const std::filesystem::path& path) {
    return read_entries(path, "experiment", experiment_of);
}

std::span<const ThesisTable> thesis_tables() {
    static const auto tables = read_thesis_tables(needed_file("data/thesis/tables.toml"));
    return tables;
}

std::span<const ThesisExperiment> thesis_experiments() {
    static const auto all = read_thesis_experiments(needed_file("data/thesis/experiments.toml"));
    return all;
}

std::string ThesisExperiment::stem() const {
    return thesis_stem(figure, name, parameter);
}

bool ThesisExperiment::is_named(std::string_view word) const {
    return names_thesis(word, figure, name, parameter);
}

Configuracion experiment_configuration(const ThesisExperiment& experiment) {
    Configuracion configuration;
    if (experiment.place == ThesisExperiment::Place::log) {
        configuration = preset_configuration("recorded-fastslam1");
    }
    for (const std::string& setting : experiment.settings) set_parameter(configuration, setting);
    return configuration;
}

}  // namespace hitos
