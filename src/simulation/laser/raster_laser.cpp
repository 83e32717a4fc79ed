// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster_laser.hpp"

#include <cmath>
#include <limits>

namespace hitos {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The walk of a ray from cell to cell, in units of cells.
struct Ray {
    Point2 from;
    double cosine = 0.0;
    double sine = 0.0;
    double reach = 0.0;
};

/// The cells of a ray one after the other, by the next border that it crosses (J. Amanatides,
/// A. Woo, A fast voxel traversal algorithm for ray tracing, Eurographics 1987).
double exact_range(const WallRaster& raster, const Ray& ray) {
    const auto floor = [](double value) { return static_cast<std::int64_t>(std::floor(value)); };
    std::int64_t x = floor(ray.from.x);
    std::int64_t y = floor(ray.from.y);
    const int step_x = ray.cosine < 0.0 ? -1 : 1;
    const int step_y = ray.sine < 0.0 ? -1 : 1;
    const double per_x = ray.cosine != 0.0 ? 1.0 / std::abs(ray.cosine) : kInfinity;
    const double per_y = ray.sine != 0.0 ? 1.0 / std::abs(ray.sine) : kInfinity;
    // Distance to the next border of each kind: counted in whole borders, so that it stays exact.
    const double to_x =
        step_x > 0 ? static_cast<double>(x + 1) - ray.from.x : ray.from.x - static_cast<double>(x);
    const double to_y =
        step_y > 0 ? static_cast<double>(y + 1) - ray.from.y : ray.from.y - static_cast<double>(y);
    std::int64_t crossed_x = 0;
    std::int64_t crossed_y = 0;
    double range = 0.0;
    while (range <= ray.reach) {
        if (raster.occupied(x, y)) return range;
        const double next_x =
            std::isinf(per_x) ? kInfinity : (to_x + static_cast<double>(crossed_x)) * per_x;
        const double next_y =
            std::isinf(per_y) ? kInfinity : (to_y + static_cast<double>(crossed_y)) * per_y;
        if (next_x < next_y) {
            range = next_x;
            x += step_x;
            ++crossed_x;
        } else {
            range = next_y;
            y += step_y;
            ++crossed_y;
        }
    }
    return kInfinity;
}

/// The walk of Stage 3 and 4: from the centre of the first cell to the end of the ray by whole
/// cells, choosing the axis by an integer error; the range is the number of cells along the longer
/// axis over the ray's cosine with it. A wall that the ray meets nearly along is so seen in steps.
double whole_cell_range(const WallRaster& raster, const Ray& ray) {
    auto x = static_cast<std::int64_t>(std::floor(ray.from.x));
    auto y = static_cast<std::int64_t>(std::floor(ray.from.y));
    const auto whole_x = static_cast<std::int64_t>(ray.reach * ray.cosine);
    const auto whole_y = static_cast<std::int64_t>(ray.reach * ray.sine);
    const std::int64_t wide = std::abs(whole_x);
    const std::int64_t high = std::abs(whole_y);
    const int step_x = whole_x < 0 ? -1 : 1;
    const int step_y = whole_y < 0 ? -1 : 1;
    std::int64_t crossed_x = 0;
    std::int64_t crossed_y = 0;
    std::int64_t error = high - wide;
    for (std::int64_t left = wide + high; left > 0; --left) {
        if (raster.occupied(x, y)) {
            return wide > high ? static_cast<double>(crossed_x) / std::abs(ray.cosine)
                               : static_cast<double>(crossed_y) / std::abs(ray.sine);
        }
        if (error < 0) {
            x += step_x;
            ++crossed_x;
            error += 2 * high;
        } else {
            y += step_y;
            ++crossed_y;
            error -= 2 * wide;
        }
    }
    return kInfinity;
}

}  // namespace

RayHit RasterLaser::hit(const Pose& pose_world_robot, std::uint32_t ray) const {
    const Pose laser = compose(pose_world_robot, fan_.pose_robot_laser);
    const double cell_m = raster_.cell_m();
    const double step = fan_.count > 1 ? fan_.step_rad() : 1.0;
    const double angle = laser.theta + fan_.min_angle_rad + ray * step;
    Ray walk;
    walk.from = {laser.x / cell_m, laser.y / cell_m};
    walk.reach = fan_.max_range_m / cell_m;
    walk.cosine = std::cos(angle);
    walk.sine = std::sin(angle);
    const double cells = ranges_ == RasterRanges::exact ? exact_range(raster_, walk)
                                                        : whole_cell_range(raster_, walk);
    const double range = cells * cell_m;
    return range <= fan_.max_range_m ? RayHit{range, -1} : RayHit{};
}

void RasterLaser::cast(const Pose& pose_world_robot, std::vector<RayHit>& out) const {
    out.resize(fan_.count);
    for (std::uint32_t ray = 0; ray < fan_.count; ++ray) out[ray] = hit(pose_world_robot, ray);
}

}  // namespace hitos
