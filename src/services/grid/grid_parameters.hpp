// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the occupancy grid, one entry for each.
#pragma once

#include <span>

#include "hitos/base/parameter.hpp"
#include "hitos/services/grid/grid_params.hpp"

namespace hitos {

std::span<const Parameter<GridParams>> grid_parameters();

}  // namespace hitos
