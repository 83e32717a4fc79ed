// Reads data/thesis: the tables of fixed parameters, and the experiments shown by maps and counts.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/text_limits.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/thesis_experiments.hpp"
#include "hitos/workbench/thesis_figures.hpp"

namespace hitos {
namespace {

/// One entry of a list of tables. What is missing, unknown or of another kind is told with its
/// line.
class DataEntry {
  public:
    DataEntry(const std::string& file, const toml::table& table) : file_(file), table_(table) {}

    bool has(std::string_view key) { return find(key) != nullptr; }

    std::string text(std::string_view key) {
        return value<std::string>(at(key), key, "a text in quotes");
    }
    template <class Value>
    Value value_or(std::string_view key, Value otherwise, const char* expected) {
        const toml::node* node = find(key);
        return node != nullptr ? value<Value>(*node, key, expected) : otherwise;
    }
    /// The words of a text, between spaces.
    std::vector<std::string> words(std::string_view key) {
        const std::string whole = text(key);
        const std::vector<std::string_view> fields = input::fields(whole);
        return {fields.begin(), fields.end()};
    }
    /// A list of lists, [[Values...], ...]; one at least.
    template <class... Values>
    std::vector<std::tuple<Values...>> rows(std::string_view key, const char* expected) {
        std::vector<std::tuple<Values...>> rows;
        const toml::node& whole = at(key);
        const toml::array* list = whole.as_array();
        if (list == nullptr || list->empty()) refuse(whole, key, expected);
        for (const toml::node& node : *list) {
            const toml::array* row = node.as_array();
            if (row == nullptr || row->size() != sizeof...(Values)) refuse(node, key, expected);
            [&]<std::size_t... I>(std::index_sequence<I...>) {
                rows.push_back({value<Values>((*row)[I], key, expected)...});
            }
            (std::index_sequence_for<Values...>());
        }
        return rows;
    }
    /// Refuses the keys that nobody asked for.
    void end() const {
        for (const auto& [key, node] : table_) {
            if (asked_.contains(std::string(key.str()))) continue;
            throw FormatError(file_, key.source().begin.line,
                              HITOS_TEXT("Errors", "no such key; expected one of %1"),
                              fmt::format("{}", fmt::join(asked_, ", ")));
        }
    }

  private:
    const toml::node* find(std::string_view key) {
        asked_.emplace(key);
        return table_.get(key);
    }
    const toml::node& at(std::string_view key) {
        const toml::node* node = find(key);
        if (node == nullptr) refuse(table_, key, "this key");
        return *node;
    }
    [[noreturn]] void refuse(const toml::node& node, std::string_view key,
                             const char* expected) const {
        throw FormatError(file_, node.source().begin.line, HITOS_TEXT("Errors", "%1: expected %2"),
                          key, expected);
    }
    template <class Value>
    Value value(const toml::node& node, std::string_view key, const char* expected) const {
        if (const auto value = node.value<Value>()) return *value;
        refuse(node, key, expected);
    }

    const std::string& file_;
    const toml::table& table_;
    std::set<std::string> asked_;
};

/// One thing made of every entry [[name]] of a file.
template <class Thing>
std::vector<Thing> read_entries(const std::filesystem::path& path, std::string_view name,
                                Thing (*made)(DataEntry&)) {
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
            DataEntry entry(file, *node.as_table());
            things.push_back(made(entry));
            entry.end();
        }
    } catch (const toml::parse_error& error) {
        throw FormatError(file, error.source().begin.line,
                          verbatim(std::string(error.description())));
    }
    return things;
}

ThesisTable table_of(DataEntry& entry) {
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

ThesisExperiment experiment_of(DataEntry& entry) {
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
