// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/simulated_tour_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {
namespace {

OdometryNoise noise_of(const World& world) {
    return {world.odometry.noise, world.odometry.noise_kind, world.seed};
}

/// The scan without the readings that are not wanted.
Scan limited(const Scan& scan, double min_range_m, double max_range_m) {
    const Pose& laser = scan.fan.pose_robot_laser;
    Scan kept = scan;
    kept.fan.max_range_m = std::min(scan.fan.max_range_m, max_range_m);
    std::erase_if(kept.landmarks, [&](const LandmarkSighting& seen) {
        const double range = distance(seen.point(), {laser.x, laser.y});
        return !(range > min_range_m && range < max_range_m);
    });
    kept.points.clear();
    kept.rays.clear();
    kept.times_s.clear();
    kept.run_starts.clear();
    for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
        bool run_open = false;
        for (std::uint32_t i = scan.run_starts[run]; i < scan.run_end(run); ++i) {
            const Point2& p = scan.points[i];
            const double range = std::hypot(p.x - laser.x, p.y - laser.y);
            const bool wanted = range > min_range_m && range < max_range_m;
            if (wanted) {
                if (!run_open) {
                    kept.run_starts.push_back(static_cast<std::uint32_t>(kept.points.size()));
                }
                kept.points.push_back(p);
                kept.rays.push_back(scan.rays[i]);
                if (!scan.times_s.empty()) kept.times_s.push_back(scan.times_s[i]);
            }
            run_open = wanted;
        }
    }
    return kept;
}

}  // namespace

SimulatedTourReader::SimulatedTourReader(std::shared_ptr<const SimulatedTour> tour,
                                         ReadOptions options)
    : tour_(std::move(tour)), options_(std::move(options)), noise_(noise_of(tour_->world())) {
    if (input::trimmed(options_.laser_pose).empty()) return;
    throw ConfigError(
        kLaserPoseKey,
        HITOS_TEXT("Errors",
                   "found \"%1\" for the world %2, expected nothing: a world says itself where its "
                   "laser sits, by laser.mount_x, laser.mount_y and laser.mount_heading"),
        options_.laser_pose, tour_->world().file);
}

std::optional<Scan> SimulatedTourReader::next_scan() {
    while (taken_ < tour_->scans()) {
        Scan scan = tour_->scan(taken_++);
        scan.mark.value = short_digest({reinterpret_cast<const char*>(scan.points.data()),
                                        scan.points.size() * sizeof(Point2)});
        while (readings_before_ < tour_->readings() &&
               tour_->reading_time(readings_before_) <= scan.time_s) {
            ++readings_before_;
        }
        scan.line = taken_ + readings_before_;
        scan.time_s += options_.scan_delay_s;
        scan.delay_s = options_.scan_delay_s;
        if (scan.time_s < 0.0) {  // the first reading's time is 0
            if (options_.leave_out_early_scans) {
                ++report_.early_scans_left_out;
                continue;
            }
            ++report_.early_scans;
        }
        ++report_.scans;
        if (options_.max_range_m > 0.0 || options_.min_range_m > 0.0) {
            double farthest = options_.max_range_m;
            if (!(farthest > 0.0)) farthest = std::numeric_limits<double>::infinity();
            scan = limited(scan, options_.min_range_m, farthest);
        }
        if (options_.mend != Mend::nothing && !scan.times_s.empty()) {
            if (!track_) {
                // By a reader of its own: this one's odometry sequence is whoever's reads it.
                track_ = std::make_unique<OdometryTrack>(
                    [ahead = std::make_shared<SimulatedTourReader>(tour_, options_)] {
                        return ahead->next_odometry();
                    });
            }
            unwarp(scan, *track_);
        }
        return scan;
    }
    return std::nullopt;
}

std::optional<Odometria> SimulatedTourReader::next_odometry() {
    if (report_.odometry >= tour_->readings()) return std::nullopt;
    Odometria reading =
        noise_(tour_->true_reading(report_.odometry), tour_->odometry_noise(report_.odometry));
    reading.twist.v *= options_.odometry_scale;
    reading.twist.v_lateral *= options_.odometry_scale;
    reading.twist.w *= options_.odometry_turns;
    if (options_.odometry_turns < 0.0) reading.twist.v_lateral *= -1.0;
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
    const std::uint64_t scans = tour_->scans();
    return scans == 0 ? 1.0 : static_cast<double>(taken_) / static_cast<double>(scans);
}

std::vector<TourFinding> SimulatedTourReader::findings() const {
    std::vector<TourFinding> found;
    for (const Message& warning : tour_->world().drawing_warnings) {
        found.push_back({TourFinding::Kind::unsure_drawing,
                         static_cast<double>(found.size() + 1),
                         warning,
                         {{marked(HITOS_TEXT("Errors",
                                             "look at the world's walls, in the window or by "
                                             "hitos-cli world, and correct the drawing"))}}});
    }
    return found;
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
