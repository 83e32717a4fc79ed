// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_tables.hpp"

namespace hitos {

using namespace declare;
using Filter = FilterParams;

FilterTable registered_motion_entries() {
    return {
        real<&Filter::motion, &MotionParams::registered_memory_m>(
            {"motion.registered_memory", "m", 0.001, 1e6, HITOS_TEXT("ParameterLabel", "Memory"),
             HITOS_TEXT("Parameter",
                        "Registered path: way after which 1/e of a particle's deviation from it is "
                        "left; with a higher value particles keep their deviations longer."),
             "motion"}),
        real<&Filter::motion, &MotionParams::registered_share>(
            {"motion.registered_share", "", 0, 100, HITOS_TEXT("ParameterLabel", "Share"),
             HITOS_TEXT("Parameter",
                        "Registered path: share of the registered step's covariance in the spread "
                        "of the particles about the path; a higher value spreads them more where "
                        "the match is poor."),
             "motion"}),
        real<&Filter::motion, &MotionParams::registered_sigma_m>(
            {"motion.registered_sigma", "m", 0, 10, HITOS_TEXT("ParameterLabel", "σ position"),
             HITOS_TEXT("Parameter",
                        "Registered path: standard deviation that the particles' positions have "
                        "about it besides; a higher value spreads them more everywhere."),
             "motion"}),
        real<&Filter::motion, &MotionParams::registered_heading_rad>(
            {"motion.registered_heading", "rad", 0, 3, HITOS_TEXT("ParameterLabel", "σ heading"),
             HITOS_TEXT("Parameter",
                        "Registered path: standard deviation that the particles' headings have "
                        "about it besides; a higher value spreads them more everywhere."),
             "motion"}),
    };
}

}  // namespace hitos
