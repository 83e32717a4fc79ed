// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/relative_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference_doubts.hpp"
#include "stamp_pairs.hpp"

namespace hitos {

std::optional<RelativeError> relative_error(const Trajectory& estimate, const Trajectory& reference,
                                            const PairSpacing& spacing, double tolerance_s) {
    auto common = matched_by_stamp(estimate, reference, tolerance_s);
    std::ranges::stable_sort(common, {},
                             [&](const Matched& pair) { return estimate[pair.estimate].time_s; });
    if (!fit_of_headings(estimate, common).told()) return std::nullopt;
    Trajectory own;
    std::vector<Pose> other;
    for (const auto& [i, there] : common) {
        own.push_back(estimate[i]);
        other.push_back(there);
    }
    std::vector<double> translations;
    std::vector<double> rotations;
    for (const auto& [i, j] : pose_pairs(own, spacing)) {
        const Pose error = between(between(other[i], other[j]), between(own[i].pose, own[j].pose));
        translations.push_back(std::hypot(error.x, error.y));
        rotations.push_back(std::abs(error.theta));
    }
    if (translations.empty()) return std::nullopt;
    RelativeError result;
    result.poses = static_cast<int>(own.size());
    result.pairs = static_cast<int>(translations.size());
    result.translation_m = figures_of(std::move(translations));
    result.rotation_rad = figures_of(std::move(rotations));
    return result;
}

}  // namespace hitos
