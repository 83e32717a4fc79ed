// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hitos {

namespace {

/// The sector of a direction, `off` sectors aside.
std::size_t sector_of(double x, double y, double off, int sectors) {
    const double turn = std::atan2(y, x) / (2.0 * kPi) * sectors + 1.5 * sectors + off;
    return static_cast<std::size_t>(turn) % static_cast<std::size_t>(sectors);
}

}  // namespace

FreeView::FreeView(std::span<const SurfacePoint> scan, const Pose& pose_world_robot)
    : pose_robot_world_(inverse(pose_world_robot)) {
    constexpr double kBorder = 0.25;  // sectors
    sectors_.fill({});
    for (const SurfacePoint& p : scan) {
        const auto x = static_cast<double>(p.x);
        const auto y = static_cast<double>(p.y);
        const auto range = static_cast<float>(std::hypot(x, y));
        // A ray on the border of two sectors, where those at whole degrees lie, is of both.
        const std::size_t first = sector_of(x, y, -kBorder, kSectors);
        const std::size_t last = sector_of(x, y, kBorder, kSectors);
        for (std::size_t place = first;; place = last) {
            Sector& sector = sectors_[place];
            sector.nearest = sector.furthest == 0.0F ? range : std::min(sector.nearest, range);
            sector.furthest = std::max(sector.furthest, range);
            if (place == last) break;
        }
    }
}

FreeView::Said FreeView::of(const Point2& world) const {
    constexpr double kNear = 0.3;       // [m]
    constexpr double kPast = 0.5;       // [m]
    constexpr double kLeast = 0.3;      // [m]; nearer is the robot
    constexpr double kFurthest = 15.0;  // [m]; a degree there is a quarter of a metre
    const Point2 p = transform(pose_robot_world_, world);
    const double range = std::hypot(p.x, p.y);
    if (range < kLeast || range > kFurthest) return Said::nothing;
    const auto place = static_cast<int>(sector_of(p.x, p.y, 0.0, kSectors));
    bool through = true;
    for (const int side : {-1, 0, 1}) {
        const Sector& sector =
            sectors_[static_cast<std::size_t>((place + side + kSectors) % kSectors)];
        if (sector.furthest == 0.0F) {
            through = false;
            continue;
        }
        const auto nearest = static_cast<double>(sector.nearest);
        const auto furthest = static_cast<double>(sector.furthest);
        if (range > nearest - kNear && range < furthest + kNear) return Said::there;
        if (nearest < range + kPast) through = false;
    }
    return through ? Said::through : Said::nothing;
}

void place(std::span<const SurfacePoint> scan, const Pose& pose_world_robot,
           std::vector<Point2>& points) {
    for (const SurfacePoint& p : scan) {
        points.push_back(transform(pose_world_robot,
                                   Point2{static_cast<double>(p.x), static_cast<double>(p.y)}));
    }
}

double contradiction(std::span<const Point2> points, std::span<const FreeView> views) {
    constexpr int kFewest = 30;
    int told = 0;
    int through = 0;
    for (const Point2& point : points) {
        bool there = false;
        bool seen_through = false;
        for (const FreeView& view : views) {
            const FreeView::Said said = view.of(point);
            there |= said == FreeView::Said::there;
            seen_through |= said == FreeView::Said::through;
        }
        if (!there && !seen_through) continue;
        ++told;
        // What one view saw there, another may have looked past at a shallow angle.
        if (!there) ++through;
    }
    return told >= kFewest ? static_cast<double>(through) / told : 0.0;
}

}  // namespace hitos
