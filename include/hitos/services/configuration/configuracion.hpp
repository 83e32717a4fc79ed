// SPDX-License-Identifier: GPL-3.0-or-later
// Every parameter of a run in one value, with its unit, range, default and meaning.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/features/extraction_params.hpp"
#include "hitos/registration/registration_params.hpp"
#include "hitos/services/grid/grid_params.hpp"
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
    std::string map = {};    ///< results of the run whose tour comes before this one; empty: none
    bool hold = false;       ///< that map stays as it is
    std::string start = {};  ///< "x,y,degrees" where in that map it begins; empty: anywhere
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

// The table of all parameters: hitos/services/configuration/config_parameter.hpp.
template <class Owner>
struct Parameter;
using ConfigParameter = Parameter<Configuracion>;
enum class ParameterGroup;

/// Sets one parameter from "key=value". Throws ConfigError.
void set_parameter(Configuracion& configuration, std::string_view assignment);

/// Throws ConfigError for a value out of its range (code can fill the struct without set()) and for
/// values that are each allowed but impossible together.
void check(const Configuracion& configuration);

/// What was said of the recording alone, how it is read, which map it goes on with and what was
/// changed in its graph, is not said of another one.
void forget_recording(SourceParams& source);
void forget_recording(Configuracion& configuration);

}  // namespace hitos
