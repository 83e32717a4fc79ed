// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_landmark.hpp"

#include <limits>

namespace hitos {

NearestLandmark::NearestLandmark(const LandmarkMap& map) : map_(map) {
    points_.reserve(map.size());
    for (const ICaracteristica& landmark : map) points_.push_back(landmark.point());
}

std::optional<std::size_t> NearestLandmark::of(const ICaracteristica& landmark,
                                               bool identities) const {
    const Point2 point = landmark.point();
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < map_.size(); ++i) {
        if (map_[i].kind() != landmark.kind()) continue;
        if (identities && map_[i].identity != landmark.identity) continue;
        const double away = distance(point, points_[i]);
        if (best && !(away < least)) continue;
        best = i;
        least = away;
    }
    return best;
}

}  // namespace hitos
