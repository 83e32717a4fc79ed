// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_parameters.hpp"

#include <vector>

namespace hitos {

std::span<const Parameter<GridParams>> grid_parameters() {
    using namespace declare;
    static const std::vector<Parameter<GridParams>> table{
        real<&GridParams::resolution_m>(
            {"grid.resolution", "m", 0.001, 10, HITOS_TEXT("ParameterLabel", "Cell size"),
             HITOS_TEXT("Parameter",
                        "Side of a cell of the occupancy grid; a higher value makes a coarser and "
                        "faster map.")}),
        real<&GridParams::log_odds_hit>({"grid.hit", "log-odds", 0, 50,
                                         HITOS_TEXT("ParameterLabel", "Gain of a hit"),
                                         HITOS_TEXT("Parameter",
                                                    "Added to the cell that a ray ends in; a "
                                                    "higher value makes walls appear sooner.")}),
        real<&GridParams::log_odds_miss>(
            {"grid.miss", "log-odds", -50, 0, HITOS_TEXT("ParameterLabel", "Loss of a pass"),
             HITOS_TEXT("Parameter",
                        "Added to every cell that a ray passes; a value nearer to 0 clears free "
                        "space more slowly.")}),
        real<&GridParams::log_odds_limit>(
            {"grid.limit", "log-odds", 0.1, 100, HITOS_TEXT("ParameterLabel", "Greatest log-odds"),
             HITOS_TEXT("Parameter",
                        "Greatest absolute value of a cell; a higher value makes a sure cell "
                        "slower to change again.")}),
        real<&GridParams::max_range_m>(
            {"grid.max_range", "m", 0, 1000, HITOS_TEXT("ParameterLabel", "Longest ray"),
             HITOS_TEXT("Parameter",
                        "Rays are drawn up to this length, so a higher value draws more of the far "
                        "readings; 0 draws them whole.")}),
        choice<&GridParams::path_marks>(
            {"grid.path_marks", HITOS_TEXT("ParameterLabel", "Ends of the path"),
             HITOS_TEXT("Parameter",
                        "How the pictures of grids that a run leaves mark where the path begins "
                        "and where it ends: by discs, green and blue, or by an X and an O as the "
                        "thesis prints them.")},
            {{"discs", HITOS_TEXT("ParameterChoice", "Discs")},
             {"x-and-o", HITOS_TEXT("ParameterChoice", "X and O")}}),
    };
    return table;
}

}  // namespace hitos
