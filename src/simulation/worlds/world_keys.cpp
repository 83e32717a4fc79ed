// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a world file that hold one value, and how they are set from words.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "wall_raster.hpp"
#include "world_values.hpp"

namespace hitos {
namespace {

using namespace declare;
using Type = WorldKey::Type;
using W = World;
using Tour = TourParams;
using Robot = RobotParams;
using Laser = LaserParams;
using Marks = MarkParams;
using Raster = RasterParams;
using Odometry = OdometryParams;

std::vector<WorldKey> make_keys() {
    const std::vector<ParameterChoice> yes_no = {{"false", HITOS_TEXT("ParameterChoice", "no")},
                                                 {"true", HITOS_TEXT("ParameterChoice", "yes")}};
    std::vector<ParameterChoice> kinds;
    kinds.reserve(std::size(kOdometryNoiseKinds));
    for (const OdometryNoiseFacts& kind : kOdometryNoiseKinds) {
        kinds.push_back({std::string(kind.word), std::string(kind.label)});
    }
    return {
        integer<&W::seed>(
            {"seed", "", 0, 0x1p53, HITOS_TEXT("ParameterLabel", "Seed of the noise"),
             HITOS_TEXT("Parameter",
                        "seed of the laser's and the odometry's noise; 0: that of the run")}),
        integer<&W::tour, &Tour::laps>(
            {"tour.laps", "", 1, 1000, HITOS_TEXT("ParameterLabel", "Laps"),
             HITOS_TEXT("Parameter", "how often the way points are driven, end to end")}),
        real<&W::tour, &Tour::rest_s>(
            {"tour.rest", "s", 0, 3600, HITOS_TEXT("ParameterLabel", "Rest at first"),
             HITOS_TEXT("Parameter", "time at rest before the robot leaves")}),
        choice<&W::tour, &Tour::look_around>(
            {"tour.look_around", HITOS_TEXT("ParameterLabel", "Look around first"),
             HITOS_TEXT("Parameter", "turn once round on the spot before leaving")},
            yes_no),
        choice<&W::tour, &Tour::reverse>(
            {"tour.reverse", HITOS_TEXT("ParameterLabel", "Backwards"),
             HITOS_TEXT("Parameter", "the way points backwards, the last one still last")},
            yes_no),
        real<&W::robot, &Robot::radius_m>(
            {"robot.radius", "m", 0, 10, HITOS_TEXT("ParameterLabel", "Radius"),
             HITOS_TEXT("Parameter", "no wall may come nearer to the robot's centre")}),
        real<&W::robot, &Robot::max_speed>({"robot.max_speed", "m/s", 0.01, 10,
                                            HITOS_TEXT("ParameterLabel", "Greatest speed"),
                                            HITOS_TEXT("Parameter", "greatest speed")}),
        real<&W::robot, &Robot::acceleration>(
            {"robot.acceleration", "m/s^2", 0.01, 100, HITOS_TEXT("ParameterLabel", "Acceleration"),
             HITOS_TEXT("Parameter", "greatest change of speed")}),
        real<&W::robot, &Robot::max_turn_rate>({"robot.max_turn_rate", "rad/s", 0.01, 10,
                                                HITOS_TEXT("ParameterLabel", "Greatest turn rate"),
                                                HITOS_TEXT("Parameter", "greatest turn rate")}),
        real<&W::robot, &Robot::turn_acceleration>(
            {"robot.turn_acceleration", "rad/s^2", 0.01, 100,
             HITOS_TEXT("ParameterLabel", "Turn acceleration"),
             HITOS_TEXT("Parameter", "greatest change of the turn rate")}),
        real<&W::robot, &Robot::tolerance_m>(
            {"robot.tolerance", "m", 0.01, 10, HITOS_TEXT("ParameterLabel", "Tolerance"),
             HITOS_TEXT("Parameter", "every way point is passed at least this near")}),
        real<&W::robot, &Robot::control_rate_hz>(
            {"robot.control_rate", "Hz", 1, 1000, HITOS_TEXT("ParameterLabel", "Control rate"),
             HITOS_TEXT("Parameter", "how often the robot's velocities are set anew")}),
        real<&W::robot, &Robot::track_m>(
            {"robot.track", "m", 0.01, 10, HITOS_TEXT("ParameterLabel", "Track"),
             HITOS_TEXT("Parameter", "between the wheels; of a robot whose wheel slips")}),
        integer<&W::laser, &Laser::rays>({"laser.rays", "", 2, 100000,
                                          HITOS_TEXT("ParameterLabel", "Rays"),
                                          HITOS_TEXT("Parameter", "rays of a scan")}),
        real<&W::laser, &Laser::field_of_view_deg>(
            {"laser.field_of_view", "degrees", 1, 360,
             HITOS_TEXT("ParameterLabel", "Field of view"),
             HITOS_TEXT("Parameter", "from the first ray to the last")}),
        real<&W::laser, &Laser::fan_turn_deg>(
            {"laser.fan_turn", "degrees", -360, 360, HITOS_TEXT("ParameterLabel", "Fan turned"),
             HITOS_TEXT("Parameter",
                        "how far the fan is turned to the left in the laser's frame, which has it "
                        "straight ahead where this is 0")}),
        choice<&W::laser, &Laser::clockwise>(
            {"laser.clockwise", HITOS_TEXT("ParameterLabel", "Clockwise"),
             HITOS_TEXT("Parameter", "the rays follow each other to the right")},
            yes_no),
        real<&W::laser, &Laser::max_range_m>(
            {"laser.max_range", "m", 0.1, 1000, HITOS_TEXT("ParameterLabel", "Greatest range"),
             HITOS_TEXT("Parameter", "walls further away give no reading")}),
        real<&W::laser, &Laser::sigma_m>(
            {"laser.sigma", "m", 0, 1, HITOS_TEXT("ParameterLabel", "σ range"),
             HITOS_TEXT("Parameter", "standard deviation of a range")}),
        real<&W::laser, &Laser::rate_hz>({"laser.rate", "Hz", 0.01, 1000,
                                          HITOS_TEXT("ParameterLabel", "Scans"),
                                          HITOS_TEXT("Parameter", "scans per second")}),
        choice<&W::laser, &Laser::sweep>(
            {"laser.sweep", HITOS_TEXT("ParameterLabel", "Rays one by one"),
             HITOS_TEXT("Parameter",
                        "the rays of a scan are measured one after the other while the robot "
                        "drives on, a whole turn from scan to scan")},
            off_on()),
        real<&W::laser, &Laser::mount_x_m>(
            {"laser.mount_x", "m", -10, 10, HITOS_TEXT("ParameterLabel", "Mounted ahead"),
             HITOS_TEXT("Parameter", "the laser's place, ahead of the robot's centre")}),
        real<&W::laser, &Laser::mount_y_m>(
            {"laser.mount_y", "m", -10, 10, HITOS_TEXT("ParameterLabel", "Mounted left"),
             HITOS_TEXT("Parameter", "the laser's place, left of the robot's centre")}),
        real<&W::laser, &Laser::mount_heading_deg>(
            {"laser.mount_heading", "degrees", -180, 180,
             HITOS_TEXT("ParameterLabel", "Mounted turned"),
             HITOS_TEXT("Parameter", "the laser's heading, left of the robot's")}),
        choice<&W::laser, &Laser::no_return>(
            {"laser.no_return", HITOS_TEXT("ParameterLabel", "No return"),
             HITOS_TEXT("Parameter",
                        "what a ray gives that meets no wall: nothing, or a point at max_range")},
            {{"none", HITOS_TEXT("ParameterChoice", "no point")},
             {"max-range", HITOS_TEXT("ParameterChoice", "greatest range")}}),
        integer<&W::laser, &Laser::sample_skip>(
            {"laser.sample_skip", "", 1, 1000, HITOS_TEXT("ParameterLabel", "Rays traced: one in"),
             HITOS_TEXT("Parameter",
                        "one ray in so many is traced and the ranges between are interpolated, as "
                        "Stage 2 can; 1: all")}),
        real<&W::landmarks, &Marks::sigma_range_m>(
            {"landmarks.sigma_range", "m", 0, 100, HITOS_TEXT("ParameterLabel", "σ range"),
             HITOS_TEXT("Parameter", "standard deviation of a landmark's range")}),
        real<&W::landmarks, &Marks::sigma_bearing_deg>(
            {"landmarks.sigma_bearing", "degrees", 0, 180,
             HITOS_TEXT("ParameterLabel", "σ bearing"),
             HITOS_TEXT("Parameter", "standard deviation of a landmark's bearing")}),
        choice<&W::landmarks, &Marks::identities>(
            {"landmarks.identities", HITOS_TEXT("ParameterLabel", "Identities"),
             HITOS_TEXT("Parameter", "whether the sensor tells which landmark it sees")},
            yes_no),
        real<&W::raster, &Raster::cell_m>(
            {"raster.cell", "m", 0, 1, HITOS_TEXT("ParameterLabel", "Cell"),
             HITOS_TEXT("Parameter", "cells in which the laser sees the walls; 0: none")}),
        real<&W::raster, &Raster::wall_m>(
            {"raster.wall", "m", 0, 1, HITOS_TEXT("ParameterLabel", "Wall"),
             HITOS_TEXT("Parameter", "how thick the walls are drawn into the cells")}),
        choice<&W::raster, &Raster::fit>(
            {"raster.fit", HITOS_TEXT("ParameterLabel", "Fit"),
             HITOS_TEXT("Parameter",
                        "shrink the drawing until the thick walls end at the outermost lines")},
            yes_no),
        choice<&W::raster, &Raster::ranges>(
            {"raster.ranges", HITOS_TEXT("ParameterLabel", "Ranges"),
             HITOS_TEXT("Parameter",
                        "to the edge of the cell that is hit, or in whole cells as Stage counts")},
            {{"exact", HITOS_TEXT("ParameterChoice", "to the edge")},
             {"whole-cells", HITOS_TEXT("ParameterChoice", "in whole cells")}}),
        real<&W::odometry, &Odometry::rate_hz>(
            {"odometry.rate", "Hz", 0.01, 1000, HITOS_TEXT("ParameterLabel", "Readings"),
             HITOS_TEXT("Parameter", "odometry readings per second")}),
        real<&W::odometry, &Odometry::noise>(
            {"odometry.noise", "", 0, 10, HITOS_TEXT("ParameterLabel", "Noise"),
             HITOS_TEXT("Parameter", "level of the noise on v and w of each reading")}),
        choice<&W::odometry, &Odometry::noise_kind>(
            {"odometry.noise_kind", HITOS_TEXT("ParameterLabel", "Kind of noise"),
             HITOS_TEXT("Parameter", "sigma = level |v|, or variance = level |v|")},
            kinds),
    };
}

[[noreturn]] void refuse(const WorldKey& key, std::string_view found) {
    throw ConfigError(std::string(key.key), HITOS_TEXT("Errors", "found %1, expected %2"), found,
                      world_values::allowed(key));
}

void refuse(const char* key, const Message& problem) {
    if (!problem.empty()) throw ConfigError(key, problem);
}

}  // namespace

std::span<const WorldKey> world_keys() {
    static const std::vector<WorldKey> table = make_keys();
    return table;
}

namespace world_values {

Message allowed(const WorldKey& key) {
    if (key.type != Type::integer) return key.allowed_message();
    return message(HITOS_TEXT("Errors", "a whole number, %1 to %2"),
                   fmt::format("{:g}", key.minimum), fmt::format("{:g}", key.maximum));
}

const WorldKey& find(std::string_view key) {
    if (const WorldKey* found = look_up(world_keys(), key)) return *found;
    const std::string_view group = key.substr(0, key.find('.') + 1);
    std::vector<std::string_view> near;
    for (const WorldKey& other : world_keys()) {
        if (!group.empty() && other.key.starts_with(group)) near.push_back(other.key);
    }
    if (group == "tour.")
        near.insert(near.end(), {"tour.start", "tour.way_points", "tour.commands", "tour.events"});
    if (group == "landmarks.") near.insert(near.end(), {"landmarks.at", "landmarks.radii"});
    if (near.empty()) {
        for (const WorldKey& other : world_keys()) near.push_back(other.key);
    }
    throw ConfigError(std::string(key), HITOS_TEXT("Errors", "no such key; expected one of %1"),
                      fmt::format("{}", fmt::join(near, ", ")));
}

void set_number(World& world, const WorldKey& key, double value) {
    const bool inside = value >= key.minimum && value <= key.maximum;  // false for NaN
    const bool whole = key.type == Type::real || value == std::floor(value);
    if (key.type == Type::choice || !inside || !whole) refuse(key, fmt::format("{}", value));
    if (key.type == Type::integer) {
        key.put(world, static_cast<std::int64_t>(value));
    } else {
        key.put(world, value);
    }
}

void set_word(World& world, const WorldKey& key, std::string_view word) {
    if (key.type != Type::choice || !key.place_of(word)) refuse(key, fmt::format("\"{}\"", word));
    key.put(world, std::string(word));
}

}  // namespace world_values

void set_world_value(World& world, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        throw ConfigError(std::string(assignment),
                          HITOS_TEXT("Errors", "found no \"=\", expected KEY=VALUE"));
    }
    const WorldKey& key = world_values::find(assignment.substr(0, equals));
    const std::string_view text = assignment.substr(equals + 1);
    if (key.type == Type::choice) {
        world_values::set_word(world, key, text);
        return;
    }
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error != std::errc{}) {
        refuse(key, fmt::format("\"{}\"", text));
    }
    world_values::set_number(world, key, value);
}

void check(const World& world) {
    for (const WorldKey& key : world_keys()) {
        if (!key.allows(key.get(world))) refuse(key, key.text(world));
    }
    if (world.walls.empty()) {
        throw ConfigError("walls", HITOS_TEXT("Errors", "found none, expected one or more"));
    }
    if (world.tour.way_points.empty() && world.tour.commands.empty()) {
        throw FormatError(world.file, 0,
                          HITOS_TEXT("Errors",
                                     "has no tour to drive; expected way_points = [[x, y], ...] or "
                                     "commands in [tour], or drive it by hand in the window"));
    }
    for (const DriveCommand& command : world.tour.commands) {
        refuse("tour.commands", problem_of(command, world.robot));
    }
    for (const Disturbance& event : world.tour.events) {
        refuse("tour.events", problem_of(event, world));
    }
    for (const Walker& walker : world.walkers) refuse("people", problem_of(walker));
    refuse("landmarks.radii", problem_of(world.landmarks));
    if (world.raster.cell_m > 0.0) check_raster(world.walls, world.raster);
}

}  // namespace hitos
