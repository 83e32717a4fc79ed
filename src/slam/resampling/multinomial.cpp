// SPDX-License-Identifier: GPL-3.0-or-later
// Multinomial (Gordon, Salmond and Smith, 1993): M independent draws.

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {

ResamplingMethodEntry multinomial_resampling() {
    return selecting(
        {"multinomial", HITOS_TEXT("ParameterChoice", "Multinomial"),
         "every particle drawn by itself; the most random differences, for comparison"},
        [](std::span<const double> weights, RandomStream& random,
           std::vector<std::uint32_t>& selected) {
            selected.resize(weights.size());
            const auto weight = [&](std::size_t i) { return weights[i]; };
            CumulatedWeights walk(weights.size(), weight);
            AscendingDraws draws(weights.size(), random);
            for (std::uint32_t& particle : selected) particle = walk.at(draws.next());
        });
}

}  // namespace hitos
