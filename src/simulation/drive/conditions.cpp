// SPDX-License-Identifier: GPL-3.0-or-later
#include "conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "laser/raster_laser.hpp"

namespace hitos {

namespace {

void append_box(const Disturbance& box, std::vector<WallSegment>& walls) {
    const Polyline outline = box_outline(box);
    for (std::size_t i = 1; i < outline.size(); ++i)
        walls.push_back({outline[i - 1], outline[i], 0, box.line});
}

}  // namespace

Surroundings::Surroundings(std::vector<WallSegment> walls, const World& world) {
    const Fan fan = fan_of(world.laser);
    if (world.landmarks.told()) walls_ = walls;
    if (world.raster.cell_m > 0.0) {
        raster_ = std::make_shared<RasterLaser>(walls, world.raster, fan);
    } else {
        laser_ = std::make_shared<SimulatedLaser>(std::move(walls), fan);
    }
}

void Surroundings::cast(const Pose& pose_world_robot, std::vector<RayHit>& out) const {
    if (raster_) {
        raster_->cast(pose_world_robot, out);
    } else {
        laser_->cast(pose_world_robot, out);
    }
}

RayHit Surroundings::hit(const Pose& pose_world_robot, std::uint32_t ray) const {
    return raster_ ? raster_->hit(pose_world_robot, ray) : laser_->hit(pose_world_robot, ray);
}

bool Surroundings::sees(const Point2& from, const Point2& to) const {
    constexpr double kBefore = 0.01;  // [m]
    const double way = distance(from, to);
    const double part = way > kBefore ? 1.0 - kBefore / way : 0.0;
    const Point2 before{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
    return std::ranges::none_of(
        walls_, [&](const WallSegment& wall) { return distance(wall, from, before) == 0.0; });
}

ConditionTrack::ConditionTrack(const World& world) {
    Conditions first;
    first.laser_sigma_m =
        world.landmarks.told() ? world.landmarks.sigma_range_m : world.laser.sigma_m;
    first.odometry_noise = world.odometry.noise;
    track_.push_back(first);
    walls_ = walls_after(0, world);
    if (world.raster.cell_m > 0.0) check_raster(walls_, world.raster);
}

std::vector<WallSegment> ConditionTrack::walls_after(std::size_t changes,
                                                     const World& world) const {
    std::vector<bool> open(world.doors.size(), false);
    std::vector<WallSegment> boxes;
    for (const Disturbance& change : std::span(changes_).first(changes)) {
        if (change.kind == DisturbanceKind::box) {
            append_box(change, boxes);
        } else {
            open.at(static_cast<std::size_t>(change.values[0]) - 1) =
                change.kind == DisturbanceKind::open;
        }
    }
    std::vector<WallSegment> walls = world.walls;
    for (std::size_t i = 0; i < world.doors.size(); ++i) {
        if (open[i]) continue;
        walls.push_back(world.doors[i]);
        walls.back().wall = -static_cast<int>(i) - 1;  // told from the walls by it
    }
    walls.insert(walls.end(), boxes.begin(), boxes.end());
    return walls;
}

std::vector<WallSegment> ConditionTrack::walls_with(const Disturbance& change,
                                                    const World& world) const {
    std::vector<WallSegment> walls = walls_;
    if (change.kind == DisturbanceKind::box) append_box(change, walls);
    if (change.kind == DisturbanceKind::close)
        walls.push_back(world.doors.at(static_cast<std::size_t>(change.values[0]) - 1));
    return walls;
}

std::shared_ptr<const Surroundings> ConditionTrack::surroundings(const Conditions& of,
                                                                 const World& world) const {
    constexpr std::size_t kKept = 4;  // for readers that are at different times
    for (const auto& [changes, one] : kept_) {
        if (changes == of.changes) return one;
    }
    if (kept_.size() == kKept) kept_.pop_front();
    return kept_
        .emplace_back(of.changes,
                      std::make_shared<Surroundings>(walls_after(of.changes, world), world))
        .second;
}

void ConditionTrack::apply(const Disturbance& disturbance, double time_s, const World& world) {
    const auto& [one, other, third] = disturbance.values;
    Conditions next = track_.back();
    next.from_s = time_s;
    switch (disturbance.kind) {
        case DisturbanceKind::push:
            return;
        case DisturbanceKind::slip:
            next.slip_until_s = time_s + one;
            next.slip_left = other;
            next.slip_right = third;
            break;
        case DisturbanceKind::blind:
            next.blind_until_s = time_s + one;
            break;
        case DisturbanceKind::box:
        case DisturbanceKind::open:
        case DisturbanceKind::close:
            if (world.raster.cell_m > 0.0)
                check_raster(walls_with(disturbance, world), world.raster);
            changes_.push_back(disturbance);
            next.changes = changes_.size();
            if (disturbance.kind == DisturbanceKind::box) {
                append_box(disturbance, walls_);
            } else {
                walls_ = walls_after(next.changes, world);
            }
            break;
        case DisturbanceKind::odometry_noise:
            next.odometry_noise = one;
            break;
        case DisturbanceKind::laser_sigma:
            next.laser_sigma_m = one;
            break;
    }
    track_.push_back(next);
}

const Conditions& ConditionTrack::at(double time_s) const {
    constexpr double kRounding = 1e-9;
    const auto after = std::upper_bound(
        track_.begin() + 1, track_.end(), time_s + kRounding,
        [](double time, const Conditions& conditions) { return time < conditions.from_s; });
    return *(after - 1);
}

Point2 place_of(const Walker& walker, double time_s) {
    double whole = 0.0;
    for (std::size_t i = 1; i < walker.way.size(); ++i) {
        whole += std::hypot(walker.way[i].x - walker.way[i - 1].x,
                            walker.way[i].y - walker.way[i - 1].y);
    }
    const bool round = walker.way.front() == walker.way.back();
    double gone = std::fmod(walker.speed * time_s, round ? whole : 2.0 * whole);
    if (gone > whole) gone = 2.0 * whole - gone;
    for (std::size_t i = 1; i < walker.way.size(); ++i) {
        const Point2& a = walker.way[i - 1];
        const Point2& b = walker.way[i];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (gone <= length) {
            const double part = gone / length;
            return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
        }
        gone -= length;
    }
    return walker.way.back();
}

namespace {

/// Lets rays end at a circle that they meet from outside; its middle in the laser's frame.
void cast_circle(const Point2& middle, double radius_m, std::span<const Point2> directions,
                 std::span<RayHit> out) {
    const double beyond2 = middle.x * middle.x + middle.y * middle.y - radius_m * radius_m;
    if (beyond2 <= 0.0) return;  // the laser is within
    for (std::size_t ray = 0; ray < directions.size(); ++ray) {
        // |r u - m|^2 = radius^2, the nearer solution.
        const double along = middle.x * directions[ray].x + middle.y * directions[ray].y;
        const double root2 = along * along - beyond2;
        if (along <= 0.0 || root2 < 0.0) continue;
        const double range = along - std::sqrt(root2);
        if (range < out[ray].range_m) out[ray] = {range, -1};
    }
}

}  // namespace

void cast_round_things(const World& world, double time_s, const Pose& pose_world_laser,
                       std::span<const Point2> directions, std::span<RayHit> out) {
    const Pose pose_laser_world = inverse(pose_world_laser);
    for (const Walker& walker : world.walkers) {
        cast_circle(transform(pose_laser_world, place_of(walker, time_s)), walker.radius_m,
                    directions, out);
    }
    const MarkParams& marks = world.landmarks;
    for (std::size_t i = 0; i < marks.radii_m.size(); ++i) {
        cast_circle(transform(pose_laser_world, marks.at[i]), marks.radii_m[i], directions, out);
    }
}

Message problem_of(const Disturbance& disturbance, const World& world) {
    const DisturbanceFacts& facts = disturbance.facts();
    if (!(disturbance.at_s >= 0.0) || !std::isfinite(disturbance.at_s)) {
        return message(HITOS_TEXT("Errors", "at: found %1, expected seconds, 0 or more"),
                       fmt::format("{}", disturbance.at_s));
    }
    for (std::size_t i = 0; i < facts.count; ++i) {
        const DisturbanceValue& value = facts.values[i];
        const double found = disturbance.values[i];
        if (!(found >= value.least && found <= value.greatest)) {
            return message(HITOS_TEXT("Errors", "%1: found %2 for %3, expected %4 to %5"),
                           facts.word, fmt::format("{}", found), value.name,
                           fmt::format("{:g}", value.least), fmt::format("{:g}", value.greatest));
        }
    }
    const bool door =
        disturbance.kind == DisturbanceKind::open || disturbance.kind == DisturbanceKind::close;
    if (!door) return {};
    const double number = disturbance.values[0];
    if (number == std::floor(number) && number <= static_cast<double>(world.doors.size())) {
        return {};
    }
    return message(HITOS_TEXT("Errors", "%1: found door %2, expected one of the world's %3 doors"),
                   facts.word, fmt::format("{}", number), world.doors.size());
}

}  // namespace hitos
