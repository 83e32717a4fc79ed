// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of thesis chapter 10: what was measured, with which fixed parameters, and which
// values the text calls good.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// The values that the text calls good, both ends included.
struct WorkingRange {
    double least = 0.0;
    double greatest = 0.0;
    bool holds(double value) const { return least <= value && value <= greatest; }
};

/// "10.10-recinto-dmax" of what the figures "10.10/10.11" show.
std::string thesis_stem(const std::string& figure, const std::string& place,
                        const std::string& parameter);
/// Whether the word means it: one of the figures or all, the place, the parameter, the stem.
bool names_thesis(std::string_view word, const std::string& figure, const std::string& place,
                  const std::string& parameter);

/// A table of fixed parameters and the parameter that was varied with it.
struct ThesisTable {
    std::string parameter;  ///< as data/results.csv names it
    std::string key;        ///< of the configuration
    std::string unit;
    std::string table;    ///< "10.2"
    std::string section;  ///< "10.4.1"
    /// The whole table as "key=value"; what it does not name stays at Hitos's defaults.
    std::vector<std::string> settings;
    /// By world, "any" for those that no entry before it names.
    std::vector<std::pair<std::string, WorkingRange>> ranges;
};
/// Throws FileError and, with the line, FormatError.
std::vector<ThesisTable> read_thesis_tables(const std::filesystem::path& path);
/// Those of data/thesis/tables.toml.
std::span<const ThesisTable> thesis_tables();

/// One value of a figure as data/results.csv has it.
struct ThesisRow {
    std::string value;
    std::optional<double> error_m;  ///< nothing: infinite, for no landmark was found
    double error_variance = 0.0;
    double landmarks = 0.0;
};

/// A pair of error and landmark figures: one world, one parameter.
struct ThesisFigure {
    std::string name;  ///< "10.10/10.11"
    std::string world;
    const ThesisTable* table = nullptr;
    WorkingRange range;
    std::vector<ThesisRow> rows;

    /// "10.10-recinto-dmax": the name of its files.
    std::string stem() const;
    /// Whether a word of --only means it: a figure's number, a world, a parameter, a stem.
    bool is_named(std::string_view word) const;
};

/// Reads data/results.csv. Throws FileError and, with the line, FormatError.
std::vector<ThesisFigure> read_thesis_figures(const std::filesystem::path& path);

/// The fixed parameters of the figure in a configuration.
Configuracion thesis_configuration(const ThesisTable& table);

/// Throws ConfigError for a parameter or world without figures.
const ThesisTable& find_thesis_table(std::string_view parameter);
WorkingRange working_range(std::string_view parameter, std::string_view world);

}  // namespace hitos
