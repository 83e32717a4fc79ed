// SPDX-License-Identifier: GPL-3.0-or-later
// Residual (Liu and Chen, 1998, "Sequential Monte Carlo methods for dynamic systems"): whole
// copies first, and the rest by multinomial draws.

#include <algorithm>
#include <cmath>

#include "cumulated_weights.hpp"
#include "methods.hpp"

namespace hitos {
namespace {

void select_residual(std::span<const double> weights, RandomStream& random,
                     std::vector<std::uint32_t>& selected) {
    const auto count = static_cast<double>(weights.size());
    // Rounding must not turn one whole copy into a chance.
    const auto whole = [&](std::size_t i) {
        return std::floor(weights[i] * count * (1.0 + 1e-12));
    };
    const auto rest = [&](std::size_t i) { return std::max(weights[i] * count - whole(i), 0.0); };
    std::size_t drawn = weights.size();
    double rests = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        drawn -= static_cast<std::size_t>(whole(i));
        rests += rest(i);
    }
    selected.clear();
    CumulatedWeights walk(weights.size(), rest);
    AscendingDraws draws(drawn, random);
    std::size_t next = drawn > 0 ? walk.at(draws.next() * rests) : weights.size();
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
        selected.insert(selected.end(), static_cast<std::size_t>(whole(i)), i);
        while (next == i) {
            selected.push_back(i);
            next = --drawn > 0 ? walk.at(draws.next() * rests) : weights.size();
        }
    }
}

}  // namespace

ResamplingMethodEntry residual_resampling() {
    return selecting(
        {"residual", HITOS_TEXT("ParameterChoice", "Residual"),
         "as many whole copies as the weight says, the rest drawn by what is left of it"},
        select_residual);
}

}  // namespace hitos
