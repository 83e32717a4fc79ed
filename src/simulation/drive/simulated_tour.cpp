// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/simulated_tour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "drive.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/random_stream.hpp"

namespace hitos {
namespace {

/// Samples at 0, 1 / rate, 2 / rate, ... up to the end, which belongs to them.
std::uint64_t samples(double duration_s, double rate_hz) {
    constexpr double kRounding = 1e-9;
    if (duration_s < 0.0) return 0;
    return static_cast<std::uint64_t>(std::floor(duration_s * rate_hz + kRounding)) + 1;
}

/// A seed stands there from now on, for all who make noise for the tour.
World seeded(World world) {
    if (world.seed == 0) world.seed = 1;
    return world;
}

/// Rather than something that happens to the robot.
bool is_of_the_place(DisturbanceKind kind) {
    return kind == DisturbanceKind::box || kind == DisturbanceKind::open ||
           kind == DisturbanceKind::close;
}

}  // namespace

SimulatedTour::SimulatedTour(World world)
    : world_(seeded(std::move(world))),
      fan_(fan_of(world_.laser)),
      directions_(ray_directions(fan_, fan_.pose_robot_laser.theta, fan_.step_rad())),
      laser_directions_(ray_directions(fan_, 0.0, fan_.step_rad())),
      ray_step_s_(world_.laser.sweep
                      ? std::abs(fan_.step_rad()) / (2.0 * kPi * world_.laser.rate_hz)
                      : 0.0),
      motion_(std::make_unique<RobotMotion>(driven(world_))) {}

SimulatedTour::~SimulatedTour() = default;

std::shared_ptr<SimulatedTour> SimulatedTour::live(World world) {
    world.tour.way_points.clear();
    world.tour.commands = {DriveCommand{}};  // of no time
    std::erase_if(world.tour.events, [](const Disturbance& event) {
        return event.at_s > 0.0 || !is_of_the_place(event.kind);
    });
    world.tour.rest_s = 0.0;
    world.tour.look_around = false;
    world.tour.laps = 1;
    world.tour.reverse = false;
    auto tour = std::make_shared<SimulatedTour>(std::move(world));
    tour->live_ = true;
    return tour;
}

void SimulatedTour::drive_on(double v, double w) {
    const std::lock_guard lock(mutex_);
    if (!live_) return;
    const Message problem = problem_of(DriveCommand{v, w}, world_.robot);
    if (!problem.empty()) throw ConfigError("drive", problem);
    check_steps(motion_->steps() + 1);
    motion_->command_among_walls(v, w);
    if (held_.empty() || held_.back().v != v || held_.back().w != w) held_.push_back({v, w, 0});
    ++held_.back().periods;
}

void SimulatedTour::disturb(Disturbance disturbance) {
    const std::lock_guard lock(mutex_);
    if (!live_) return;
    disturbance.at_s = motion_->time_s();
    const Message problem = problem_of(disturbance, world_);
    if (!problem.empty()) throw ConfigError(std::string(disturbance.facts().word), problem);
    motion_->disturb(disturbance);
    events_.push_back(disturbance);
}

void SimulatedTour::end() {
    const std::lock_guard lock(mutex_);
    live_ = false;
}

bool SimulatedTour::is_live() const {
    const std::lock_guard lock(mutex_);
    return live_;
}

std::vector<Disturbance> SimulatedTour::disturbances() const {
    const std::lock_guard lock(mutex_);
    std::vector<Disturbance> all = world_.tour.events;
    std::erase_if(all, [](const Disturbance& event) {
        return event.at_s <= 0.0 && is_of_the_place(event.kind);
    });
    all.insert(all.end(), events_.begin(), events_.end());
    return all;
}

std::uint64_t SimulatedTour::scan_from(double at_s) const {
    constexpr double kRounding = 1e-9;
    return static_cast<std::uint64_t>(
        std::max(0.0, std::ceil(at_s * world_.laser.rate_hz - kRounding)));
}

World SimulatedTour::recorded() const {
    const std::lock_guard lock(mutex_);
    World world = world_;
    if (!held_.empty()) world.tour.commands.clear();
    for (const Held& held : held_) {
        world.tour.commands.push_back(
            {held.v, held.w, static_cast<double>(held.periods) / world_.robot.control_rate_hz, 0});
    }
    world.tour.events.insert(world.tour.events.end(), events_.begin(), events_.end());
    return world;
}

Pose SimulatedTour::pose_now() const {
    const std::lock_guard lock(mutex_);
    return motion_->pose();
}

Twist SimulatedTour::twist_now() const {
    const std::lock_guard lock(mutex_);
    return motion_->twist();
}

std::vector<WallSegment> SimulatedTour::walls_now() const {
    const std::lock_guard lock(mutex_);
    return motion_->conditions().walls();
}

std::vector<Point2> SimulatedTour::people_now() const {
    const std::lock_guard lock(mutex_);
    std::vector<Point2> places;
    for (const Walker& walker : world_.walkers) {
        places.push_back(place_of(walker, motion_->time_s()));
    }
    return places;
}

double SimulatedTour::duration_s() const {
    const std::lock_guard lock(mutex_);
    return motion_->time_s();
}

const DrivenPath& SimulatedTour::path() const {
    return motion_->path();
}

/// Until the end, or what nothing that happens from now on can change.
double SimulatedTour::settled_s() const {
    if (!live_) return motion_->time_s();
    return (static_cast<double>(motion_->steps()) - 1.0) / world_.robot.control_rate_hz;
}

/// As a scan says it, after its own.
double SimulatedTour::ray_time_s(std::uint32_t ray) const {
    return static_cast<double>(static_cast<float>(ray * ray_step_s_));
}

std::uint64_t SimulatedTour::scans() const {
    // A sweep ends before what is known does, by more than times are rounded.
    constexpr double kRounding = 1e-6;
    const double sweep_s = ray_step_s_ > 0.0 ? ray_time_s(fan_.count - 1) + kRounding : 0.0;
    const std::lock_guard lock(mutex_);
    const double settled = settled_s();
    if (!live_) return samples(settled - sweep_s, world_.laser.rate_hz);
    const std::uint64_t known = samples(settled, world_.odometry.rate_hz);
    return known == 0 ? 0 : samples(reading_time(known - 1) - sweep_s, world_.laser.rate_hz);
}

std::uint64_t SimulatedTour::readings() const {
    const std::lock_guard lock(mutex_);
    return samples(settled_s(), world_.odometry.rate_hz);
}

Pose SimulatedTour::true_pose(std::uint64_t k) const {
    const std::lock_guard lock(mutex_);
    return between(world_.tour.start, motion_->path().pose_at(scan_time(k)));
}

Scan SimulatedTour::seen_landmarks(std::uint64_t k) const {
    Scan scan;
    scan.time_s = scan_time(k);
    scan.fan.pose_robot_laser = fan_.pose_robot_laser;
    Pose sensor;
    Conditions now;
    std::shared_ptr<const Surroundings> around;
    {
        const std::lock_guard lock(mutex_);
        sensor = compose(motion_->path().pose_at(scan.time_s), fan_.pose_robot_laser);
        now = motion_->conditions().at(scan.time_s);
        around = motion_->conditions().surroundings(now, world_);
    }
    const MarkParams& marks = world_.landmarks;
    const double widest_rad = 0.5 * world_.laser.field_of_view_deg * kRadiansPerDegree;
    const double turned_rad = world_.laser.fan_turn_deg * kRadiansPerDegree;
    RandomStream random(world_.seed, RandomPurpose::laser_noise, k, 0);
    for (std::size_t i = 0; i < marks.at.size(); ++i) {
        const auto noise = random.normal_pair();  // every landmark has its draw, seen or not
        const Point2 at = transform(inverse(sensor), marks.at[i]);
        const double range = std::hypot(at.x, at.y);
        const double bearing = std::atan2(at.y, at.x);
        if (scan.time_s < now.blind_until_s || range > world_.laser.max_range_m ||
            std::abs(wrap_angle(bearing - turned_rad)) > widest_rad ||
            !around->sees({sensor.x, sensor.y}, marks.at[i])) {
            continue;
        }
        LandmarkSighting seen{
            std::max(0.0, range + now.laser_sigma_m * noise[0]),
            wrap_angle(bearing + marks.sigma_bearing_deg * kRadiansPerDegree * noise[1])};
        const Point2 point = transform(fan_.pose_robot_laser, seen.point());
        if (fan_.pose_robot_laser != Pose()) {
            seen.range_m = std::hypot(point.x, point.y);
            seen.bearing_rad = std::atan2(point.y, point.x);
        }
        if (marks.identities) seen.identity = static_cast<std::int32_t>(i);
        scan.landmarks.push_back(seen);
    }
    return scan;
}

Scan SimulatedTour::scan(std::uint64_t k) const {
    if (world_.landmarks.told()) return seen_landmarks(k);
    struct Moment {
        double time_s;
        Pose pose;
        Conditions now;
    };
    const bool sweeps = ray_step_s_ > 0.0;
    std::vector<Moment> moments;  // of every ray where they differ
    {
        const std::lock_guard lock(mutex_);
        for (std::uint32_t ray = 0; ray < (sweeps ? fan_.count : 1); ++ray) {
            const double time_s = scan_time(k) + ray_time_s(ray);
            moments.push_back(
                {time_s, motion_->path().pose_at(time_s), motion_->conditions().at(time_s)});
        }
    }
    const Pose& mount = fan_.pose_robot_laser;
    const auto among = [this](const Conditions& now) {
        const std::lock_guard lock(mutex_);
        return motion_->conditions().surroundings(now, world_);
    };
    std::vector<RayHit> hits;
    if (sweeps) {
        for (std::uint32_t ray = 0; ray < fan_.count; ++ray) {
            const auto& [time_s, pose, now] = moments[ray];
            hits.push_back(among(now)->hit(pose, ray));
            cast_round_things(world_, time_s, compose(pose, mount),
                              std::span(laser_directions_).subspan(ray, 1),
                              std::span(hits).last(1));
        }
    } else {
        const auto& [time_s, pose, now] = moments.front();
        among(now)->cast(pose, hits);
        cast_round_things(world_, time_s, compose(pose, mount), laser_directions_, hits);
    }
    interpolate(hits, world_.laser.sample_skip, fan_.max_range_m);

    Scan scan;
    scan.time_s = scan_time(k);
    scan.fan = fan_;
    RandomStream random(world_.seed, RandomPurpose::laser_noise, k, 0);
    std::array<double, 2> normals{};
    bool run_open = false;
    for (std::uint32_t ray = 0; ray < fan_.count; ++ray) {
        // Every ray has its draw, whether it hits or not.
        if (ray % 2 == 0) normals = random.normal_pair();
        const auto& [time_s, pose, now] = moments[sweeps ? ray : 0];
        double range = hits[ray].range_m + now.laser_sigma_m * normals[ray % 2];
        const bool blind = time_s < now.blind_until_s;
        if (!blind && world_.laser.no_return == NoReturn::max_range && range >= fan_.max_range_m) {
            range = fan_.max_range_m;
        } else if (blind || !(range > 0.0 && range < fan_.max_range_m)) {
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        const Point2& direction = directions_[ray];
        scan.points.push_back({mount.x + range * direction.x, mount.y + range * direction.y});
        scan.rays.push_back(ray);
        if (sweeps) scan.times_s.push_back(static_cast<float>(ray_time_s(ray)));
    }
    return scan;
}

Odometria SimulatedTour::true_reading(std::uint64_t k) const {
    Odometria reading;
    reading.time_s = reading_time(k);
    if (k == 0) return reading;
    const std::lock_guard lock(mutex_);
    reading.twist = motion_->path().twist_between_times(reading_time(k - 1), reading.time_s);
    return reading;
}

double SimulatedTour::odometry_noise(std::uint64_t k) const {
    const std::lock_guard lock(mutex_);
    return motion_->conditions().at(reading_time(k)).odometry_noise;
}

}  // namespace hitos
