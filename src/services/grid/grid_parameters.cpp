#include "grid_parameters.hpp"

#include <vector>

namespace hitos {

std::span<const Parameter<GridParams>> grid_parameters() {
    using namespace declare;
    static const std::vector<Parameter<GridParams>> table{
        real<&GridParams::resolution_m>(
            {.key = "grid.resolution",
             .unit = "m",
             .minimum = 0.001,
             .maximum = 10.0,
             .description = HITOS_TEXT("Parameter",
                                       "Side of a cell of the occupancy grid; a higher value makes "
                                       "a coarser and faster map."),
             .label = HITOS_TEXT("ParameterLabel", "Cell size")}),
        real<&GridParams::log_odds_hit>(
            {.key = "grid.hit",
             .unit = "log-odds",
             .minimum = 0.0,
             .maximum = 50.0,
             .description = HITOS_TEXT(
                 "Parameter",
                 "Added to the cell that a ray ends in; a higher value makes walls appear sooner."),
             .label = HITOS_TEXT("ParameterLabel", "Hit")}),
        real<&GridParams::log_odds_miss>(
            {.key = "grid.miss",
             .unit = "log-odds",
             .minimum = -50.0,
             .maximum = 0.0,
             .description = HITOS_TEXT("Parameter",
                                       "Added to every cell that a ray passes; a value nearer to 0 "
                                       "clears free space more slowly."),
             .label = HITOS_TEXT("ParameterLabel", "Miss")}),
        real<&GridParams::log_odds_limit>(
            {.key = "grid.limit",
             .unit = "log-odds",
             .minimum = 0.1,
             .maximum = 100.0,
             .description = HITOS_TEXT("Parameter",
                                       "Greatest absolute value of a cell; a higher value makes a "
                                       "sure cell slower to change again."),
             .label = HITOS_TEXT("ParameterLabel", "Limit")}),
        real<&GridParams::max_range_m>(
            {.key = "grid.max_range",
             .unit = "m",
             .minimum = 0.0,
             .maximum = 1000.0,
             .description = HITOS_TEXT("Parameter",
                                       "Rays are drawn up to this length, so a higher value draws "
                                       "more of the far readings; 0 draws them whole."),
             .label = HITOS_TEXT("ParameterLabel", "Longest ray")}),
    };
    return table;
}

}  // namespace hitos
