// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/calibration_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hitos {

std::string word_of_share(const CalibrationKind& kind, double region) {
    return fmt::format("{}_in_{:.0f}", kind.word, 100.0 * region);
}

std::array<std::optional<double>, kRegions.size()> shares_in_regions(
    const ByMeasure<Spread>& figures, const CalibrationKind& kind) {
    std::array<std::optional<double>, kRegions.size()> shares;
    for (std::size_t i = 0; i < kRegions.size(); ++i) {
        const auto& spread = figures[word_of_share(kind, kRegions.at(i))];
        if (spread) shares.at(i) = spread->mean;
    }
    return shares;
}

bool has_shares(const ByMeasure<Spread>& figures, const CalibrationKind& kind) {
    return shares_in_regions(figures, kind).front().has_value();
}

std::optional<NeesFigure> nees_figure(const ByMeasure<Spread>& figures,
                                      const CalibrationKind& kind) {
    const Measure& measure = run_measures().find(fmt::format("{}_nees", kind.word));
    const std::optional<Spread>& spread = figures[measure];
    if (!spread || spread->count < 1) return std::nullopt;
    const auto degrees = static_cast<int>(std::lround(measure.target.value()));
    return NeesFigure{spread->mean, spread->count, degrees, nees_interval(spread->count, degrees)};
}

}  // namespace hitos
