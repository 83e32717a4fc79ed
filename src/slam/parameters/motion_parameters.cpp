#include "parameter_tables.hpp"

namespace hitos {

using namespace declare;
using Filter = FilterParams;

void add_registered_motion(FilterTable& table) {
    table.push_back(real<&Filter::motion, &MotionParams::registered_memory_m>(
        {.key = "motion.registered_memory",
         .unit = "m",
         .minimum = 0.001,
         .maximum = 1e6,
         .description =
             HITOS_TEXT("Parameter",
                        "Registered path: way after which 1/e of a particle's deviation from it is "
                        "left; with a higher value particles keep their deviations longer."),
         .label = HITOS_TEXT("ParameterLabel", "Memory"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::registered_share>(
        {.key = "motion.registered_share",
         .minimum = 0.0,
         .maximum = 100.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Registered path: share of the registered step's covariance in the spread of the "
             "particles about the path; a higher value spreads them more where the match is poor."),
         .label = HITOS_TEXT("ParameterLabel", "Share"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::registered_sigma_m>(
        {.key = "motion.registered_sigma",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description =
             HITOS_TEXT("Parameter",
                        "Registered path: standard deviation that the particles' positions have "
                        "about it besides; a higher value spreads them more everywhere."),
         .label = HITOS_TEXT("ParameterLabel", "σ position"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::registered_heading_rad>(
        {.key = "motion.registered_heading",
         .unit = "rad",
         .minimum = 0.0,
         .maximum = 3.0,
         .description =
             HITOS_TEXT("Parameter",
                        "Registered path: standard deviation that the particles' headings have "
                        "about it besides; a higher value spreads them more everywhere."),
         .label = HITOS_TEXT("ParameterLabel", "σ heading"),
         .card = "motion"}));
}

}  // namespace hitos
