// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over the rows of a reproduction, and the tables made of them.
#pragma once

#include <functional>
#include <string>

#include "hitos/workbench/reproduction.hpp"

namespace hitos {

/// How many of a set of rows agree with the thesis, in the senses of Verdict.
struct Agreement {
    int rows = 0;
    int error_near = 0;
    int landmarks_near = 0;
    int both_near = 0;
    int at_least = 0;
    int below = 0;  ///< errors more than kErrorMargin below the thesis's
    int above = 0;
    int fewer = 0;  ///< landmarks more than kLandmarkMargin below the thesis's
    int more = 0;
    int truth_met = 0;
    int thesis_truth_met = 0;
    int tendency_asked = 0;
    int same_tendency = 0;
    int compared = 0;  ///< rows in which both have an error
    double thesis_m = 0.0;
    double ours_m = 0.0;
    /// Rows that would be within kErrorMargin if both means were estimates of one and the same.
    double expected_near = 0.0;

    void add(const ReproducedRow& row);
    double mean_thesis_m() const { return compared > 0 ? thesis_m / compared : 0.0; }
    double mean_ours_m() const { return compared > 0 ? ours_m / compared : 0.0; }
    double mean_difference_m() const { return mean_ours_m() - mean_thesis_m(); }
};

using RowFilter = std::function<bool(const ReproducedFigure&, const ReproducedRow&)>;

Agreement sum_up(const Reproduction& reproduction, const RowFilter& wanted);
bool in_range(const ReproducedFigure& figure, const ReproducedRow& row);
bool any_row(const ReproducedFigure& figure, const ReproducedRow& row);

/// The counts and the tables by parameter and by world.
std::string summary_text(const Reproduction& reproduction);

}  // namespace hitos
