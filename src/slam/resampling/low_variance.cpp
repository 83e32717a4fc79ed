// SPDX-License-Identifier: GPL-3.0-or-later
// Low variance [T table 6.2], elsewhere called systematic (Kitagawa, 1996): one draw for all.

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {

void low_variance_selection(std::span<const double> weights, double start,
                            std::vector<std::uint32_t>& selected) {
    select_from_parts(
        weights, [start] { return start; }, selected);
}

ResamplingMethodEntry low_variance_resampling() {
    return selecting(
        {"low-variance", HITOS_TEXT("ParameterChoice", "Low variance"),
         "one draw for all particles at equal distances; the fewest random differences"},
        [](std::span<const double> weights, RandomStream& random,
           std::vector<std::uint32_t>& selected) {
            low_variance_selection(weights, random.uniform(), selected);
        });
}

}  // namespace hitos
