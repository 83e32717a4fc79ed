#include "hitos/services/evaluation/position_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stamp_pairs.hpp"

namespace hitos {

PositionError::PositionError(Trajectory reference) : reference_(std::move(reference)) {
    std::ranges::stable_sort(reference_, {}, &StampedPose::time_s);
}

std::optional<Pose> PositionError::reference_at(const StampedPose& estimate) {
    const StampedPose* nearest = nearest_pose(reference_, estimate.time_s, kSameStamp);
    if (nearest == nullptr) return std::nullopt;
    if (!pose_world_reference_) {
        pose_world_reference_ = compose(estimate.pose, inverse(nearest->pose));
    }
    return compose(*pose_world_reference_, nearest->pose);
}

std::optional<double> PositionError::at(const StampedPose& estimate) {
    const std::optional<Pose> there = reference_at(estimate);
    if (!there) return std::nullopt;
    return std::hypot(estimate.pose.x - there->x, estimate.pose.y - there->y);
}

}  // namespace hitos
