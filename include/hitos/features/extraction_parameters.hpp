// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the extraction of features, one entry for each.
#pragma once

#include <span>

#include "hitos/base/parameter.hpp"
#include "hitos/features/extraction_params.hpp"

namespace hitos {

/// All of them; keys of one table of a configuration file stand together.
std::span<const Parameter<ExtractionParams>> extraction_parameters();

}  // namespace hitos
