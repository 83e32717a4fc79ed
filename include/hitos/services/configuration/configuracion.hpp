// Every parameter of a run in one value, with its unit, range, default and meaning.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/services/run/grid.hpp"
#include "hitos/slam/params.hpp"

namespace hitos {

/// Where the data come from [T 9.2.6.1].
struct SourceParams {
    std::string file;  ///< path of the log; empty: none chosen
    std::string format{kAutoFormat};  ///< word of log_formats(), or "auto"
    ReadOptions read;
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
    grid,
    run
};

/// Describes one parameter; the table of all of them drives files, options, forms and studies.
struct Parameter {
    enum class Type { real, integer, choice, text };

    std::string_view key;  ///< "split_merge.dmax"
    ParameterGroup group = ParameterGroup::source;
    Type type = Type::real;
    std::string_view unit;                       ///< "m", "rad", "m^2", … or empty
    std::string_view description;                ///< one sentence
    double minimum = 0.0;                        ///< numbers: smallest value allowed
    double maximum = 0.0;                        ///< numbers: greatest value allowed
    std::vector<std::string_view> choices = {};  ///< choice: the words, in the enum's order

    /// The value as text, exact: reading it back gives the same bits.
    std::string text(const Configuracion& configuration) const;
    /// Sets the value from text. Throws ConfigError that names key, value found and what is
    /// allowed; the configuration is then unchanged.
    void set(Configuracion& configuration, std::string_view value) const;
    /// What is allowed, in words: "0 to 10 m", "one of ml, gnn", "any text".
    std::string allowed() const;
    /// Throws ConfigError where the configuration's value is not allowed.
    void check(const Configuracion& configuration) const;

    // How the value is reached; the pair that `type` names is set, the others are null. A choice is
    // reached as the integer that is its place in `choices`.
    double& (*real)(Configuracion&) = nullptr;
    double (*get_real)(const Configuracion&) = nullptr;
    std::int64_t (*get_integer)(const Configuracion&) = nullptr;
    void (*set_integer)(Configuracion&, std::int64_t) = nullptr;
    std::string& (*words)(Configuracion&) = nullptr;
    const std::string& (*get_words)(const Configuracion&) = nullptr;
};

/// All parameters, group by group.
std::span<const Parameter> parameters();

/// The parameter of that key. Throws ConfigError that names near keys where there is none.
const Parameter& find_parameter(std::string_view key);

/// Sets one parameter from "key=value". Throws ConfigError.
void set_parameter(Configuracion& configuration, std::string_view assignment);

/// Throws ConfigError for a value out of its range (code can fill the struct without set()) and for
/// values that are each allowed but impossible together.
void check(const Configuracion& configuration);

}  // namespace hitos
