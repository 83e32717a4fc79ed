#include "hitos/simulation/simulated_tour.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "hitos/base/random_stream.hpp"
#include "hitos/simulation/odometry_noise.hpp"
#include "raster_laser.hpp"

namespace hitos {
namespace {

/// Samples at 0, 1 / rate, 2 / rate, ... up to the end, which belongs to them.
std::uint64_t samples(double duration_s, double rate_hz) {
    constexpr double kRounding = 1e-9;
    return static_cast<std::uint64_t>(std::floor(duration_s * rate_hz + kRounding)) + 1;
}

/// A seed stands there from now on, for all who make noise for the tour.
World seeded(World world) {
    if (world.seed == 0) world.seed = 1;
    return world;
}

}  // namespace

SimulatedTour::SimulatedTour(World world)
    : world_(seeded(std::move(world))),
      path_(drive(world_)),
      laser_(world_.walls, fan_of(world_.laser)),
      directions_(ray_directions(laser_.fan(), laser_.fan().pose_robot_laser.theta,
                                 laser_.fan().step_rad())),
      raster_(world_.raster.cell_m > 0.0
                  ? std::make_shared<RasterLaser>(world_.walls, world_.raster, fan_of(world_.laser))
                  : nullptr),
      scans_(samples(path_.duration_s(), world_.laser.rate_hz)),
      readings_(samples(path_.duration_s(), world_.odometry.rate_hz)) {}

Pose SimulatedTour::true_pose(std::uint64_t k) const {
    return between(world_.tour.start, path_.pose_at(scan_time(k)));
}

Scan SimulatedTour::scan(std::uint64_t k) const {
    std::vector<RayHit> hits;
    const Pose pose = path_.pose_at(scan_time(k));
    if (raster_) {
        raster_->cast(pose, hits);
    } else {
        laser_.cast(pose, hits);
    }
    const Fan& fan = laser_.fan();
    const Pose& mount = fan.pose_robot_laser;

    Scan scan;
    scan.time_s = scan_time(k);
    scan.fan = fan;
    RandomStream random(world_.seed, RandomPurpose::laser_noise, k, 0);
    std::array<double, 2> normals{};
    bool run_open = false;
    for (std::uint32_t ray = 0; ray < fan.count; ++ray) {
        // Every ray has its draw, whether it hits or not.
        if (ray % 2 == 0) normals = random.normal_pair();
        double range = hits[ray].range_m + world_.laser.sigma_m * normals[ray % 2];
        if (world_.laser.no_return == NoReturn::max_range && range >= fan.max_range_m) {
            range = fan.max_range_m;
        } else if (!(range > 0.0 && range < fan.max_range_m)) {
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        const Point2& direction = directions_[ray];
        scan.points.push_back({mount.x + range * direction.x, mount.y + range * direction.y});
        scan.rays.push_back(ray);
    }
    return scan;
}

Odometria SimulatedTour::true_reading(std::uint64_t k) const {
    Odometria reading;
    reading.time_s = reading_time(k);
    if (k > 0) reading.twist = path_.twist_between_times(reading_time(k - 1), reading.time_s);
    return reading;
}

}  // namespace hitos
