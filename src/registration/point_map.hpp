// SPDX-License-Identifier: GPL-3.0-or-later
// Points of several scans in buckets, for the nearest one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "surface_points.hpp"

namespace hitos {

/// A point of a map, from the map's centre on in the axes of the world, and which of the map's
/// scans it is of.
struct MapPoint : SurfacePoint {
    std::uint32_t source = 0;
};

/// Nearest points within radii of decimetres: square buckets are quicker here than a tree, to build
/// and to ask. Coordinates count from the centre, so that a tour may be as far from the origin as
/// it likes.
class PointMap {
  public:
    /// Empty, about `centre`. Points further than `half_m` from it, in x or y, will be left out.
    void begin(const Point2& centre, double half_m);
    /// Adds a scan's points, seen from `pose` in the world.
    void add(std::span<const SurfacePoint> points, const Pose& pose, std::uint32_t source);
    /// Puts what was added into buckets.
    void build();

    const Point2& centre() const { return centre_; }
    /// The point nearest to (x, y), from the centre on, within `radius_m`; null where there is
    /// none. `distance2_m2`, where given, takes its squared distance.
    const MapPoint* nearest(double x, double y, double radius_m,
                            double* distance2_m2 = nullptr) const;
    /// How many points it has, and each of them, bucket by bucket.
    std::size_t size() const { return order_.size(); }
    const MapPoint& point(std::size_t number) const { return added_[order_[number]]; }

  private:
    struct Corner {
        float x = 0.0F;
        float y = 0.0F;
    };
    struct Place {
        std::uint32_t bucket = 0;
        std::uint32_t in_bucket = 0;
    };
    struct Nearest {
        float d2;
        const MapPoint* point;
    };
    void search_row(int row, int first_column, int last_column, float x, float y,
                    Nearest& best) const;

    Point2 centre_;
    double half_m_ = 0.0;
    std::vector<MapPoint> added_;
    Corner low_, high_;                  // of these
    std::vector<std::uint32_t> order_;   // of these, bucket by bucket
    std::vector<float> xs_, ys_;         // in that order once more, to look through
    std::vector<std::uint32_t> starts_;  // of each bucket in order_
    std::vector<Place> places_;          // scratch: of each point
    double x0_ = 0.0;                    // corner of the first bucket
    double y0_ = 0.0;
    int columns_ = 0;
    int rows_ = 0;
};

}  // namespace hitos
