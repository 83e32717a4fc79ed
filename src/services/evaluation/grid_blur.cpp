// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/grid_blur.hpp"

#include <cmath>

namespace hitos {
namespace {

/// p log2 p, whose limit at 0 is 0.
double term(double p) {
    return p > 0.0 ? p * std::log2(p) : 0.0;
}

}  // namespace

std::optional<double> grid_blur_m2(const Grid& grid) {
    double sum = 0.0;
    bool seen = false;
    // Most cells stand at one of the two limits, so the last result is often the next one.
    float last = 0.0F;
    double last_term = 0.0;
    for (int row = 0; row < grid.rows(); ++row) {
        for (int column = 0; column < grid.columns(); ++column) {
            if (!grid.known(column, row)) continue;
            const float log_odds = grid.log_odds(column, row);
            if (!seen || log_odds != last) {
                const double p = 1.0 / (1.0 + std::exp(-static_cast<double>(log_odds)));
                last = log_odds;
                last_term = term(p) + term(1.0 - p);
            }
            sum += last_term;
            seen = true;
        }
    }
    if (!seen) return std::nullopt;
    return -sum * grid.resolution_m() * grid.resolution_m();
}

}  // namespace hitos
