// SPDX-License-Identifier: GPL-3.0-or-later
// How a study's parameter lies along the x axis of its plots.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hitos/services/study/study_result.hpp"

namespace hitos {

/// By its number where each value is one, else place by place with the values as words.
struct StudyAbscissa {
    bool numbers = true;
    bool logarithmic = false;
    std::vector<double> positions;   ///< one for each value, in the plan's order
    std::vector<std::string> words;  ///< likewise

    /// From the least to the greatest, with so much more of it at both ends.
    std::pair<double, double> range(double room) const;
};

StudyAbscissa study_abscissa(const StudyPlan::Axis& axis);

/// "error [m]", as axes of figures have it.
std::string figure_label(const std::string& name, const std::string& unit);

/// "split_merge.dmax [m]"
std::string study_axis_label(const StudyPlan::Axis& axis);

}  // namespace hitos
