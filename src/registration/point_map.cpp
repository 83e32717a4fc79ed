#include "point_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hitos {
namespace {

constexpr double kBucket = 0.3;  // [m]
constexpr std::uint32_t kOutside = UINT32_MAX;

}  // namespace

void PointMap::add(std::span<const SurfacePoint> points, const Pose& pose, std::uint32_t source) {
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    for (const SurfacePoint& p : points) {
        const double x = static_cast<double>(p.x);
        const double y = static_cast<double>(p.y);
        const double nx = static_cast<double>(p.nx);
        const double ny = static_cast<double>(p.ny);
        MapPoint placed;
        placed.x = static_cast<float>(pose.x + c * x - s * y);
        placed.y = static_cast<float>(pose.y + s * x + c * y);
        placed.nx = static_cast<float>(c * nx - s * ny);
        placed.ny = static_cast<float>(s * nx + c * ny);
        placed.source = source;
        points_.push_back(placed);
    }
}

int PointMap::bucket(double offset) const {
    return static_cast<int>(std::floor(std::clamp(offset / kBucket, -1.0, side_ + 1.0)));
}

void PointMap::build(const Point2& centre, double half_m) {
    side_ = static_cast<int>(std::ceil(2.0 * half_m / kBucket)) + 1;
    x0_ = centre.x - half_m;
    y0_ = centre.y - half_m;
    const auto buckets = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
    starts_.assign(buckets + 1, 0);
    places_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const int column = bucket(static_cast<double>(points_[i].x) - x0_);
        const int row = bucket(static_cast<double>(points_[i].y) - y0_);
        if (column < 0 || row < 0 || column >= side_ || row >= side_) {
            places_[i] = kOutside;
            continue;
        }
        places_[i] = static_cast<std::uint32_t>(row * side_ + column);
        ++starts_[places_[i] + 1];
    }
    for (std::size_t b = 0; b < buckets; ++b) starts_[b + 1] += starts_[b];
    sorted_.resize(starts_[buckets]);
    std::vector<std::uint32_t>& next = starts_;  // moves on while filling, put back below
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (places_[i] != kOutside) sorted_[next[places_[i]]++] = points_[i];
    }
    for (std::size_t b = buckets; b > 0; --b) starts_[b] = starts_[b - 1];
    starts_[0] = 0;
    std::swap(points_, sorted_);
}

const MapPoint* PointMap::nearest(double x, double y, double radius_m, double* distance2_m2) const {
    const int first_column = std::max(bucket(x - radius_m - x0_), 0);
    const int last_column = std::min(bucket(x + radius_m - x0_), side_ - 1);
    const int first_row = std::max(bucket(y - radius_m - y0_), 0);
    const int last_row = std::min(bucket(y + radius_m - y0_), side_ - 1);
    double best2 = radius_m * radius_m;
    const MapPoint* best = nullptr;
    for (int row = first_row; row <= last_row && first_column <= last_column; ++row) {
        const auto line = static_cast<std::size_t>(row) * static_cast<std::size_t>(side_);
        // The buckets of a row lie one after the other.
        const MapPoint* p = points_.data() + starts_[line + static_cast<std::size_t>(first_column)];
        const MapPoint* const end =
            points_.data() + starts_[line + static_cast<std::size_t>(last_column) + 1];
        for (; p != end; ++p) {
            const double dx = static_cast<double>(p->x) - x;
            const double dy = static_cast<double>(p->y) - y;
            const double d2 = dx * dx + dy * dy;
            if (d2 < best2) {
                best2 = d2;
                best = p;
            }
        }
    }
    if (best != nullptr && distance2_m2 != nullptr) *distance2_m2 = best2;
    return best;
}

}  // namespace hitos
