// SPDX-License-Identifier: GPL-3.0-or-later
// The table of all parameters of a run, of which files, options, forms and help texts are made.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "hitos/base/parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

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

/// All parameters, group by group.
std::span<const ConfigParameter> parameters();

/// The parameter of that key. Throws ConfigError that names near keys where there is none.
const ConfigParameter& find_parameter(std::string_view key);

}  // namespace hitos
