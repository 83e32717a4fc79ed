// SPDX-License-Identifier: GPL-3.0-or-later
#include "values.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <utility>

#include "hitos/base/parameter.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/study/study.hpp"
#include "hitos/services/study/study_values.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/simulation/worlds/world_key.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/readings.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos::manual {
namespace {

using Paths = Values::Paths;

Values words_alone(std::vector<Word> words) {
    return {std::move(words), Paths::none, Keys::none};
}

/// A word for each entry of a table: what `text` and `meaning` give of it.
template <class Table, class Text, class Meaning>
Values words_of(const Table& table, Text text, Meaning meaning) {
    std::vector<Word> words;
    words.reserve(table.size());
    for (const auto& entry : table) {
        words.push_back(
            {std::string(std::invoke(text, entry)), std::string(std::invoke(meaning, entry))});
    }
    return words_alone(std::move(words));
}

Values read_formats() {
    Values values = words_of(log_formats().entries(), &LogFormat::word, &LogFormat::purpose);
    values.words.insert(values.words.begin(),
                        {std::string(kAutoFormat), "found from the log's beginning"});
    return values;
}

Values written_formats() {
    std::vector<LogFormat> written;
    for (const LogFormat& format : log_formats().entries()) {
        if (format.make_writer != nullptr) written.push_back(format);
    }
    return words_of(written, &LogFormat::word, &LogFormat::purpose);
}

Values preset_values() {
    Values values = words_of(presets(), &Preset::word, &Preset::purpose);
    values.words.insert(values.words.begin(),
                        {std::string(kAutoPreset), "the one that suits the source"});
    return values;
}

Values noise_kinds() {
    return words_of(kOdometryNoiseKinds, &OdometryNoiseFacts::word, &OdometryNoiseFacts::meaning);
}

Values reading_values() {
    return words_of(readings(), &Reading::name, &Reading::sentence);
}

Values thesis_names() {
    return words_of(thesis_parameters(), &ThesisParameter::name, &ThesisParameter::meaning);
}

std::vector<Word> world_words() {
    std::vector<Word> words;
    for (const std::string& name : shipped_worlds()) words.push_back({name, "world"});
    return words;
}

Values sources() {
    return {world_words(), Paths::files, Keys::none};
}

Values figures() {
    Values values = thesis_names();
    for (Word& world : world_words()) values.words.push_back(std::move(world));
    return values;
}

Values keys_and_tables() {
    Values values;
    std::string table;
    for (const ConfigParameter& parameter : parameters()) {
        if (table != parameter.table()) {
            table = parameter.table();
            values.words.push_back({table, "all of [" + table + "]"});
        }
        values.words.push_back({std::string(parameter.key), std::string(parameter.description)});
    }
    return values;
}

Values anything() {
    return {};
}

Values all_topics() {
    return words_alone({{"all", "every laser; those that see from one place become one"}});
}

Values odometry_topics() {
    return words_alone({{"tf", "the transforms"}});
}

Values drawing_units() {
    return words_of(kDrawingUnits, &DrawingUnit::word, &DrawingUnit::name);
}

Values picture_values() {
    return words_alone({{"first", "of each value's first run"}, {"all", "of every run"}});
}

template <Keys Kind>
Values assignments() {
    return {{}, Paths::none, Kind};
}

/// What the argument of that name takes, wherever it stands or in one command alone. The first that
/// fits counts.
struct Rule {
    std::string_view command;  ///< "simulate"; empty: in all
    std::string_view argument;
    Values (*values)();
};

constexpr std::array kRules{
    Rule{"simulate", "--format", &written_formats},
    Rule{"simulate", "--set", &assignments<Keys::world>},
    Rule{"simulate", "--seed", &anything},
    Rule{"simulate", "--tour-seed", &anything},
    Rule{"simulate", "--laps", &anything},
    Rule{"simulate", "--laser-sigma", &anything},
    Rule{"simulate", "--odometry-noise", &anything},
    Rule{"reproduce", "--world", &assignments<Keys::world>},
    Rule{"", "--format", &read_formats},
    Rule{"", "--to", &written_formats},
    Rule{"", "--preset", &preset_values},
    Rule{"", "--odometry-noise-kind", &noise_kinds},
    Rule{"", "--reading", &reading_values},
    Rule{"", "--only", &figures},
    Rule{"", "--scan-topic", &all_topics},
    Rule{"", "--odom-topic", &odometry_topics},
    Rule{"", "--pictures", &picture_values},
    Rule{"", "--set", &assignments<Keys::configuration>},
    Rule{"", "--world-set", &assignments<Keys::world>},
    Rule{"", "--vary", &assignments<Keys::study>},
    Rule{"", "--second", &thesis_names},
    Rule{"", "--shard", &anything},
    Rule{"world", "--unit", &drawing_units},
    Rule{"", "--layer", &anything},
    Rule{"", "--start", &anything},
    Rule{"", "--size", &anything},
    Rule{"", "log", &sources},
    Rule{"", "world", &sources},
    Rule{"", "file", &sources},
    Rule{"parameters", "key", &keys_and_tables},
    Rule{"", "Parametro", &thesis_names},
    Rule{"", "Valores", &anything},
};

bool fits(const Rule& rule, const Command& command, const Argument& argument) {
    return (rule.command.empty() || rule.command == command.below) &&
           std::ranges::find(argument.names, rule.argument) != argument.names.end();
}

template <class Owner>
Key key_of(const Parameter<Owner>& parameter) {
    Key key{{std::string(parameter.key), std::string(parameter.description)}, {}};
    for (const ParameterChoice& choice : parameter.choices) {
        key.choices.push_back({choice.word, choice.purpose});
    }
    return key;
}

}  // namespace

std::vector<Key> keys_of(Keys kind) {
    std::vector<Key> keys;
    if (kind == Keys::configuration) {
        for (const ConfigParameter& parameter : parameters()) keys.push_back(key_of(parameter));
    } else if (kind == Keys::world) {
        for (const WorldKey& key : world_keys()) keys.push_back(key_of(key));
    } else if (kind == Keys::study) {
        for (const Word& word : thesis_names().words) keys.push_back({word, {}});
        for (const ConfigParameter& parameter : parameters()) {
            if (can_be_varied(parameter)) keys.push_back(key_of(parameter));
        }
    }
    return keys;
}

Values values_of(const Command& command, const Argument& argument) {
    if (!argument.words.empty()) {
        Values values;
        for (const std::string& word : argument.words) values.words.push_back({word, ""});
        return values;
    }
    for (const Rule& rule : kRules) {
        if (fits(rule, command, argument)) return rule.values();
    }
    if (argument.value != "TEXT") return {};  // a number, or nothing
    const bool folder = argument.meaning.starts_with("Folder");
    return {{}, folder ? Paths::folders : Paths::files, Keys::none};
}

}  // namespace hitos::manual
