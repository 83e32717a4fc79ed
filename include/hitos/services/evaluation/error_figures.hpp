// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of many errors.
#pragma once

#include <vector>

namespace hitos {

/// Of errors of one kind, in their unit; all 0 where there is none.
struct ErrorFigures {
    double mean = 0.0;
    double deviation = 0.0;  ///< standard deviation over all of them (divided by n)
    double rmse = 0.0;       ///< root of the mean square
    double median = 0.0;     ///< of an even number the mean of the two in the middle
    double maximum = 0.0;    ///< of the absolute values
};

ErrorFigures figures_of(std::vector<double> errors);

}  // namespace hitos
