// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/position_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stamp_pairs.hpp"

namespace hitos {

PositionError::PositionError(Trajectory reference, double tolerance_s)
    : reference_(std::move(reference)), tolerance_s_(tolerance_s) {
    std::ranges::stable_sort(reference_, {}, &StampedPose::time_s);
}

std::optional<Pose> PositionError::reference_at(const StampedPose& estimate) {
    const std::optional<Pose> there = pose_at(reference_, estimate.time_s, tolerance_s_);
    if (!there) return std::nullopt;
    if (!pose_world_reference_) pose_world_reference_ = compose(estimate.pose, inverse(*there));
    return compose(*pose_world_reference_, *there);
}

std::optional<double> PositionError::at(const StampedPose& estimate) {
    const std::optional<Pose> there = reference_at(estimate);
    if (!there) return std::nullopt;
    return std::hypot(estimate.pose.x - there->x, estimate.pose.y - there->y);
}

}  // namespace hitos
