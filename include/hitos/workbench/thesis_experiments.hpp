// SPDX-License-Identifier: GPL-3.0-or-later
// What thesis chapter 10 shows without a table of errors: grid maps for several values of a
// parameter, pairs of SLAM's and odometry's map, counts.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// One value of an experiment and what the thesis says of it, in our words.
struct ThesisClaim {
    std::string value;  ///< as the study takes it
    std::string says;
};

/// An experiment of the thesis, as data/thesis has it.
struct ThesisExperiment {
    enum class Show {
        maps,   ///< a sheet of the grid maps, the odometry's last
        counts  ///< a table alone
    };
    /// Where the tour comes from.
    enum class Place {
        world,  ///< one of data/worlds, for a world of the thesis or its like
        log     ///< a recorded tour of the public data set Radish
    };

    std::string figure;     ///< "10.66/10.67"
    std::string parameter;  ///< short, for file names and --only: "dmax"
    std::string key;        ///< that is varied; several joined by '+'
    std::string table;      ///< of the fixed parameters, "10.11"
    Place place = Place::world;
    std::string name;  ///< of the world, or the stem of the log
    Show show = Show::maps;
    int runs = 1;  ///< of each value; several where the thesis gives errors
    std::vector<std::string> settings;
    std::vector<ThesisClaim> claims;
    std::string remark;  ///< what we see, and where we differ

    /// "10.66-usc-sal-mov": the name of its files.
    std::string stem() const;
    /// Whether a word of --only means it: a figure's number, a place, a parameter, a stem.
    bool is_named(std::string_view word) const;
};

/// Throws FileError and, with the line, FormatError.
std::vector<ThesisExperiment> read_thesis_experiments(const std::filesystem::path& path);

/// Those of data/thesis/experiments.toml, in the order of the thesis, those on recorded tours last.
std::span<const ThesisExperiment> thesis_experiments();

/// The fixed parameters in a configuration: Hitos's defaults and the settings; for recorded tours
/// the preset `recorded-fastslam1` and the settings. Throws FileError where that is not found.
Configuracion experiment_configuration(const ThesisExperiment& experiment);

}  // namespace hitos
