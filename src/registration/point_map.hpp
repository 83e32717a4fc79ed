// Points of several scans in buckets, for the nearest one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "surface_points.hpp"

namespace hitos {

/// A point of a map and which of the map's scans it is of.
struct MapPoint : SurfacePoint {
    std::uint32_t source = 0;
};

/// Nearest points within radii of decimetres: square buckets are quicker here than a tree, to build
/// and to ask. Points further than `half_m` from the centre, in x or y, are left out.
class PointMap {
  public:
    void clear() { points_.clear(); }
    /// Adds a scan's points, seen from `pose`.
    void add(std::span<const SurfacePoint> points, const Pose& pose, std::uint32_t source);
    /// Puts what was added into buckets.
    void build(const Point2& centre, double half_m);

    /// The nearest point within `radius_m`, null where there is none; of two as near the one added
    /// first. `distance2_m2`, where given, takes its squared distance.
    const MapPoint* nearest(double x, double y, double radius_m,
                            double* distance2_m2 = nullptr) const;
    /// All points, in no useful order after build().
    std::span<const MapPoint> points() const { return points_; }

  private:
    int bucket(double offset) const;

    std::vector<MapPoint> points_;       // bucket by bucket after build()
    std::vector<std::uint32_t> starts_;  // of each bucket in points_
    std::vector<MapPoint> sorted_;       // scratch
    std::vector<std::uint32_t> places_;  // scratch: the bucket of each point
    double x0_ = 0.0;
    double y0_ = 0.0;
    int side_ = 0;  // buckets
};

}  // namespace hitos
