// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the table of parameters that stand in files of their own.
#pragma once

#include <vector>

#include "hitos/slam/filter_parameters.hpp"

namespace hitos {

using FilterTable = std::vector<Parameter<FilterParams>>;

/// Bounded lines, exclusion and hypotheses: the end of the table "association".
FilterTable bounded_association_entries();
/// Which landmarks stay.
FilterTable landmark_entries();
/// The motion model "registered".
FilterTable registered_motion_entries();

}  // namespace hitos
