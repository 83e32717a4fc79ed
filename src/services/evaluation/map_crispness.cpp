// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_crispness.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {

void MapCrispness::add(const Scan& scan, const Pose& pose_world_robot) {
    const auto number = [](double coordinate) {
        return static_cast<std::int64_t>(std::floor(std::clamp(coordinate / kCell, -1e9, 1e9)));
    };
    for (const Point2& point : scan.points) {
        const Point2 p = transform(pose_world_robot, point);
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        ++points_;
        cells_.insert(static_cast<std::uint64_t>(number(p.x)) << 32U |
                      (static_cast<std::uint64_t>(number(p.y)) & 0xffffffffU));
    }
}

double MapCrispness::cells_per_point() const {
    return points_ > 0 ? static_cast<double>(cells_.size()) / static_cast<double>(points_) : 0.0;
}

}  // namespace hitos
