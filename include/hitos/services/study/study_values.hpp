// SPDX-License-Identifier: GPL-3.0-or-later
// What a study varies: the thesis's parameters, configuration keys, lists and ranges of values.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// One value of a study's parameter: a text for each configuration key that it sets.
using StudyValue = std::vector<std::string>;

/// One parameter of a study. Most set a single key; `sensor` sets two together, `mov` three.
struct StudyParameter {
    std::string name;               ///< as the user says it: "dmax", "split_merge.dmax"
    std::vector<std::string> keys;  ///< of the configuration
    std::vector<StudyValue> values;
};

/// The names of BatchSLAM [T 9.2.7].
struct ThesisParameter {
    std::string_view name;
    std::vector<std::string_view> keys;
    const char* meaning;  ///< of its components, in their order; translated in the context "Errors"
};
std::span<const ThesisParameter> thesis_parameters();

/// The parameter of that name, without values: one of the thesis's, a key, or keys joined by `+`.
/// Throws ConfigError.
StudyParameter find_study_parameter(std::string_view name);

/// As above, the thesis's names alone.
StudyParameter find_thesis_parameter(std::string_view name);

/// Makes values of a flat list: two words for each value of `sensor`, three for `mov`. A word of a
/// parameter of one key may be a range. Throws ConfigError where the count does not fit, naming
/// what is expected.
void set_values(StudyParameter& parameter, std::span<const std::string> words);

/// Reads "name=v1,v2,…": each v a value or a range from:to:step, the components of a value that
/// sets several keys joined by `/`. Whether a key can take a value is for each run to find.
StudyParameter parse_study_parameter(std::string_view assignment);

/// Throws ConfigError of a value that a key cannot take, whatever the other ones are, and of one
/// that is there twice.
void check_values(const StudyParameter& parameter);
/// Throws ConfigError where the configuration cannot have one of the values with any value of the
/// other parameter (null: there is none). What is wrong with the other one is not told.
void check_values(const Configuracion& configuration, const StudyParameter& parameter,
                  const StudyParameter* other);
/// The same of each of one or two parameters.
void check_values(const Configuracion& configuration, std::span<const StudyParameter> parameters);

/// The values of from:to:step, both ends included, with as many decimals as `from` and `step`
/// show, so that 0.1:0.3:0.1 ends with 0.3. Throws ConfigError where the range is empty, endless or
/// not of numbers.
std::vector<std::string> expand_range(std::string_view range);

}  // namespace hitos
