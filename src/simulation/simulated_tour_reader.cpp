#include "hitos/simulation/simulated_tour_reader.hpp"

#include <cmath>
#include <utility>

namespace hitos {
namespace {

OdometryNoise noise_of(const World& world) {
    return {world.odometry.noise, world.odometry.noise_kind, world.seed};
}

/// The scan of a laser that sees less far.
Scan limited(const Scan& scan, double max_range_m) {
    const Pose& laser = scan.fan.pose_robot_laser;
    Scan near = scan;
    near.fan.max_range_m = std::min(scan.fan.max_range_m, max_range_m);
    near.points.clear();
    near.rays.clear();
    near.run_starts.clear();
    for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
        bool run_open = false;
        for (std::uint32_t i = scan.run_starts[run]; i < scan.run_end(run); ++i) {
            const Point2& p = scan.points[i];
            const bool seen = std::hypot(p.x - laser.x, p.y - laser.y) < max_range_m;
            if (seen) {
                if (!run_open) {
                    near.run_starts.push_back(static_cast<std::uint32_t>(near.points.size()));
                }
                near.points.push_back(p);
                near.rays.push_back(scan.rays[i]);
            }
            run_open = seen;
        }
    }
    return near;
}

}  // namespace

SimulatedTourReader::SimulatedTourReader(std::shared_ptr<const SimulatedTour> tour,
                                         ReadOptions options)
    : tour_(std::move(tour)), options_(std::move(options)), noise_(noise_of(tour_->world())) {}

std::optional<Scan> SimulatedTourReader::next_scan() {
    if (report_.scans >= tour_->scans()) return std::nullopt;
    Scan scan = tour_->scan(report_.scans);
    while (readings_before_ < tour_->readings() &&
           tour_->reading_time(readings_before_) <= scan.time_s) {
        ++readings_before_;
    }
    scan.line = ++report_.scans + readings_before_;
    return options_.max_range_m > 0.0 ? limited(scan, options_.max_range_m) : scan;
}

std::optional<Odometria> SimulatedTourReader::next_odometry() {
    if (report_.odometry >= tour_->readings()) return std::nullopt;
    Odometria reading =
        noise_(tour_->true_reading(report_.odometry), tour_->odometry_noise(report_.odometry));
    while (scans_before_ < tour_->scans() && tour_->scan_time(scans_before_) < reading.time_s) {
        ++scans_before_;
    }
    reading.line = ++report_.odometry + scans_before_;
    return reading;
}

void SimulatedTourReader::restart() {
    *this = SimulatedTourReader(tour_, options_);
}

std::unique_ptr<TourReader> SimulatedTourReader::reopen() const {
    return std::make_unique<SimulatedTourReader>(tour_, options_);
}

std::optional<double> SimulatedTourReader::progress() const {
    if (tour_->is_live()) return std::nullopt;  // nobody knows how long it will be
    return static_cast<double>(report_.scans) / static_cast<double>(tour_->scans());
}

std::optional<Truth> SimulatedTourReader::truth() const {
    Truth truth;
    truth.seed = tour_->world().seed;
    const std::uint64_t scans = tour_->scans();
    truth.path.reserve(scans);
    for (std::uint64_t k = 0; k < scans; ++k) {
        truth.path.push_back({tour_->scan_time(k), tour_->true_pose(k)});
    }
    const Pose pose_start_world = inverse(tour_->world().tour.start);
    for (const auto* walls : {&tour_->world().walls, &tour_->world().doors}) {
        for (const WallSegment& wall : *walls) {
            truth.walls.emplace_back(transform(pose_start_world, wall.a),
                                     transform(pose_start_world, wall.b));
        }
    }
    return truth;
}

}  // namespace hitos
