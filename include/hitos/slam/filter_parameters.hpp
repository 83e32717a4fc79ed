// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the SLAM algorithms, one entry for each.
#pragma once

#include <span>

#include "hitos/base/parameter.hpp"
#include "hitos/slam/params.hpp"

namespace hitos {

/// All of them; keys of one table of a configuration file stand together.
std::span<const Parameter<FilterParams>> filter_parameters();

/// Throws ConfigError for a value out of its range and for values that are each allowed but
/// impossible together.
void check(const FilterParams& params);

}  // namespace hitos
