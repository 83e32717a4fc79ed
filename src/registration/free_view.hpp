// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a place that a scan looked through holds a point that another scan saw.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "key_graph.hpp"

namespace hitos {

/// How far one scan saw in every direction.
class FreeView {
  public:
    FreeView(std::span<const SurfacePoint> scan, const Pose& pose_world_robot);

    enum class Said { nothing, there, through };
    /// What the scan says of a point of the world: `there` where it saw something within a
    /// decimetre or three of it, `through` where it looked past it on both sides.
    Said of(const Point2& world) const;

  private:
    static constexpr int kSectors = 360;
    struct Sector {
        float nearest = 0.0F;  // [m]; 0 where the scan saw nothing in it
        float furthest = 0.0F;
    };

    Pose pose_robot_world_;
    std::array<Sector, kSectors> sectors_;
};

/// Appends the points of a scan as they lie in the world.
void place(std::span<const SurfacePoint> scan, const Pose& pose_world_robot,
           std::vector<Point2>& points);

/// The share of points that a view looks through, of those that views say anything of; 0 where
/// there are too few to tell.
double contradiction(std::span<const Point2> points, std::span<const FreeView> views);

}  // namespace hitos
