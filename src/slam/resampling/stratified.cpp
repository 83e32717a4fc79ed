// SPDX-License-Identifier: GPL-3.0-or-later
// Stratified (Kitagawa, 1996, "Monte Carlo filter and smoother"): one draw in each M-th part.

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {

ResamplingMethodEntry stratified_resampling() {
    return selecting({"stratified", HITOS_TEXT("ParameterChoice", "Stratified"),
                      "one draw for each M-th part of the weights"},
                     [](std::span<const double> weights, RandomStream& random,
                        std::vector<std::uint32_t>& selected) {
                         select_from_parts(
                             weights, [&] { return random.uniform(); }, selected);
                     });
}

}  // namespace hitos
