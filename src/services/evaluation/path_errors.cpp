// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/path_errors.hpp"

#include <cmath>

#include "stamp_pairs.hpp"

namespace hitos {

std::optional<Pose> first_alignment(const Trajectory& estimate, const Trajectory& reference,
                                    double tolerance_s) {
    const auto matched = matched_by_stamp(estimate, reference, tolerance_s);
    if (matched.empty()) return std::nullopt;
    const auto& [first, there] = matched.front();
    return compose(there, inverse(estimate[first].pose));
}

std::vector<PathError> path_errors(const Trajectory& estimate, const Trajectory& reference,
                                   std::optional<Pose> pose_reference_estimate,
                                   double tolerance_s) {
    std::vector<PathError> errors;
    double way = 0.0;
    std::size_t at = 0;  // the pose that the way leads to
    for (const auto& [i, there] : matched_by_stamp(estimate, reference, tolerance_s)) {
        for (; at < i; ++at) {
            const Pose& a = estimate[at].pose;
            const Pose& b = estimate[at + 1].pose;
            way += std::hypot(b.x - a.x, b.y - a.y);
        }
        const Pose& pose = estimate[i].pose;
        if (!pose_reference_estimate) pose_reference_estimate = compose(there, inverse(pose));
        const Pose own = compose(*pose_reference_estimate, pose);
        errors.push_back(
            {i, estimate[i].time_s, way, std::hypot(own.x - there.x, own.y - there.y)});
    }
    return errors;
}

}  // namespace hitos
