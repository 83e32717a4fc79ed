// The parts of the table of parameters that stand in files of their own.
#pragma once

#include <vector>

#include "hitos/slam/filter_parameters.hpp"

namespace hitos {

using FilterTable = std::vector<Parameter<FilterParams>>;

/// Bounded lines, exclusion and hypotheses, at the end of the table "association".
void add_bounded_association(FilterTable& table);
/// Which landmarks stay.
void add_landmarks(FilterTable& table);
/// The motion model "registered".
void add_registered_motion(FilterTable& table);

}  // namespace hitos
