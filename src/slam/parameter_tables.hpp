// The parts of the table of parameters that stand in files of their own.
#pragma once

#include <vector>

#include "hitos/slam/filter_parameters.hpp"

namespace hitos {

using FilterTable = std::vector<Parameter<FilterParams>>;

/// The motion model "registered".
void add_registered_motion(FilterTable& table);

}  // namespace hitos
