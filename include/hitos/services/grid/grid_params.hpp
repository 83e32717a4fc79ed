// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of occupancy grids [T 2.5.4].
#pragma once

namespace hitos {

/// How the two ends of a path are marked in pictures.
enum class PathMarks {
    discs,          ///< start a green disc, end a blue one
    cross_and_ring  ///< start a green X, end a blue O, as in the thesis
};

/// Of occupancy grids.
struct GridParams {
    double resolution_m = 0.05;   ///< side of a cell
    double log_odds_hit = 0.85;   ///< added to the cell a ray ends in
    double log_odds_miss = -0.4;  ///< added to the cells a ray passes
    double log_odds_limit = 5.0;  ///< greatest absolute value of a cell
    double max_range_m = 0.0;     ///< rays are drawn up to it; 0: whole
    PathMarks path_marks = PathMarks::discs;
};

}  // namespace hitos
