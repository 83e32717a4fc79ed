// Every parameter of a run in one value, with its unit, range, default and meaning.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/parameter.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/registration/registration_params.hpp"
#include "hitos/services/run/grid.hpp"
#include "hitos/slam/params.hpp"

namespace hitos {

/// Where the data come from [T 9.2.6.1].
struct SourceParams {
    std::string file;                 ///< path of the log; empty: none chosen
    std::string format{kAutoFormat};  ///< word of log_formats(), or "auto"
    ReadOptions read;
    /// Of a world's noise, so that many runs have the same tour; 0: as the world says, else that of
    /// the run.
    std::uint64_t tour_seed = 0;
    std::string world_set = {};  ///< changes of a world's values: "laser.sigma=0.003 tour.laps=2"
    friend bool operator==(const SourceParams&, const SourceParams&) = default;
};

/// How a run is done; nothing here changes a result but the seed.
struct RunParams {
    std::uint64_t seed = 1;
    int threads = 0;  ///< 0: as many as the machine has
};

/// The one configuration struct: window, command line, files and studies fill it and nothing else.
struct Configuracion {
    SourceParams source;
    RunParams run;
    FilterParams filter;
    RegistrationParams registration;
    ExtractionParams extraction;
    GridParams grid;
};

/// The five groups of the thesis's form plus resampling [T 9.2.6.5], and Hitos's own.
enum class ParameterGroup {
    source,
    particle_filter,
    motion,
    observation,
    split_merge,
    resampling,
    registration,
    grid,
    run
};

/// What a group is called, and the tables of a configuration file whose parameters it shows.
struct ParameterGroupFacts {
    ParameterGroup group;
    std::string_view title;           ///< translated in the context "ParameterGroup"; or empty, and
    std::string_view title_key = {};  ///< the parameter whose choice is the title
    std::vector<std::string_view> tables;
};

/// All groups, in the order of their tables in a configuration file.
std::span<const ParameterGroupFacts> parameter_groups();

/// The group of a table of a configuration file: "split_merge". Throws ConfigError where no group
/// has it.
const ParameterGroupFacts& group_of(std::string_view table);

/// One entry for each parameter; files, options, forms, help texts, checks and studies are made of
/// the table of all of them.
using ConfigParameter = Parameter<Configuracion>;

/// All parameters, group by group.
std::span<const ConfigParameter> parameters();

/// The parameter of that key. Throws ConfigError that names near keys where there is none.
const ConfigParameter& find_parameter(std::string_view key);

/// Sets one parameter from "key=value". Throws ConfigError.
void set_parameter(Configuracion& configuration, std::string_view assignment);

/// Throws ConfigError for a value out of its range (code can fill the struct without set()) and for
/// values that are each allowed but impossible together.
void check(const Configuracion& configuration);

}  // namespace hitos
