// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_correction.hpp"

#include <stdexcept>
#include <string>

namespace hitos {

void follow(std::span<Association> associations, std::span<const NewPlaces> places,
            std::span<const std::size_t> sizes) {
    std::vector<std::uint32_t> all;
    std::uint32_t before = 0;  // landmarks of the kinds before, which come first in the map
    for (std::size_t kind = 0; kind < places.size(); ++kind) {
        for (const std::uint32_t place : places[kind]) all.push_back(before + place);
        before += static_cast<std::uint32_t>(sizes[kind]);
    }
    for (Association& association : associations) {
        if (association.landmark < 0) continue;
        // Resampling may have left no copy of the particle whose associations these are.
        const auto landmark = static_cast<std::size_t>(association.landmark);
        association.landmark =
            landmark < all.size() ? static_cast<std::int32_t>(all[landmark]) : -1;
    }
}

void check(const PathCorrection& correction, std::uint64_t steps) {
    if (correction.by_scan.size() == steps) return;
    throw std::invalid_argument("a correction of " + std::to_string(correction.by_scan.size()) +
                                " scans for a filter that has seen " + std::to_string(steps));
}

}  // namespace hitos
