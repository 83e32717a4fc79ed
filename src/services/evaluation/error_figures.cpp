// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/error_figures.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {

ErrorFigures figures_of(std::vector<double> errors) {
    ErrorFigures figures;
    if (errors.empty()) return figures;
    const auto count = static_cast<double>(errors.size());
    double squares = 0.0;
    for (const double error : errors) {
        figures.mean += error / count;
        squares += error * error / count;
        figures.maximum = std::max(figures.maximum, std::abs(error));
    }
    figures.rmse = std::sqrt(squares);
    double scatter = 0.0;
    for (const double error : errors) {
        scatter += (error - figures.mean) * (error - figures.mean) / count;
    }
    figures.deviation = std::sqrt(scatter);
    std::ranges::sort(errors);
    const std::size_t middle = errors.size() / 2;
    figures.median = errors.size() % 2 == 1
                         ? errors[middle]
                         : errors[middle - 1] + (errors[middle] - errors[middle - 1]) / 2.0;
    return figures;
}

}  // namespace hitos
