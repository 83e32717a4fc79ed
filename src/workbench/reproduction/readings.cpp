// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

constexpr std::string_view kAsPublished = "thin-interpolated-3-hz";

/// A reading by what it adds to one before it.
struct ReadingStep {
    const char* base;
    const char* name;
    const char* sentence;
    const char* world = "";  ///< "key=value" of world files, with spaces between them
    double wall_pixels = 0.0;
    double motion_factor = 1.0;
    bool variances = false;
};

std::vector<Reading> make_readings() {
    constexpr double kTwoReadings = 1.4142135623730951;
    constexpr double kFiveReadings = 2.23606797749979;
    constexpr auto kSteps = std::to_array<ReadingStep>({
        {"", "plain",
         "the worlds as they are: exact walls, 3 mm of noise, 5 s at rest, then northwards"},
        // Walls 3 pixels thick in cells of 2 cm are [T 10.3.1]; how its version of Stage fitted the
        // picture and counted ranges the thesis does not say.
        {"plain", "thick-walls",
         "cells of 2 cm, walls 3 pixels thick about their lines, no noise of ranges",
         "raster.cell=0.02 laser.sigma=0", 3.0},
        {"thick-walls", "fitted-walls",
         "`thick-walls`, the picture's ink fitted to the world's size, so that outer walls lie "
         "wholly inside",
         "raster.fit=true"},
        {"fitted-walls", "stage",
         "`fitted-walls`, ranges counted in whole cells as Stage 3 and 4 do",
         "raster.ranges=whole-cells"},
        {"plain", "no-rest", "the robot leaves at once", "tour.rest=0"},
        {"fitted-walls", "fitted-no-rest", "`fitted-walls`, and the robot leaves at once",
         "tour.rest=0"},
        // Stage's own description of this laser has 361 rays.
        {"fitted-no-rest", "fitted-no-rest-361-rays",
         "`fitted-no-rest` with a ray every half degree", "laser.rays=361"},
        {"fitted-no-rest", "fitted-no-rest-per-reading",
         "`fitted-no-rest`, motion noise drawn for every odometry reading, two a scan", "", 0.0,
         kTwoReadings},
        {"fitted-no-rest", "fitted-no-rest-east",
         "`fitted-no-rest` with tours that leave eastwards", "tour.reverse=true"},
        {"fitted-no-rest", "fitted-no-rest-2-pixels", "`fitted-no-rest`, walls 2 pixels thick", "",
         2.0},
        {"fitted-no-rest", "fitted-no-rest-2-pixels-361-rays",
         "`fitted-no-rest` with both, thinner walls and more rays", "laser.rays=361", 2.0},
        {"fitted-no-rest", "fitted-no-rest-2-hz", "`fitted-no-rest` with 2 scans a second, not 5",
         "laser.rate=2"},
        {"stage", "stage-no-rest", "`stage`, and the robot leaves at once", "tour.rest=0"},
        {"stage-no-rest", "stage-no-rest-361-rays", "`stage-no-rest` with a ray every half degree",
         "laser.rays=361"},
        // What the sample world of Stage 2.0.1 to 2.0.4 has: docs/simulation.md, "Which Stage".
        {"no-rest", "interpolated",
         "`no-rest`, a ray every half degree of which one in four is traced and those between are "
         "interpolated, as in Stage 2's sample world; no noise of ranges",
         "laser.rays=361 laser.sample_skip=4 laser.sigma=0"},
        {"interpolated", "interpolated-3-mm", "`interpolated` with 3 mm of noise",
         "laser.sigma=0.003"},
        {"fitted-no-rest", "fitted-interpolated",
         "`fitted-no-rest` with the laser of `interpolated`", "laser.rays=361 laser.sample_skip=4"},
        {"fitted-no-rest-2-pixels", "thin-interpolated",
         "`fitted-no-rest-2-pixels` with the laser of `interpolated`",
         "laser.rays=361 laser.sample_skip=4"},
        {"thin-interpolated", "thin-interpolated-181-rays",
         "`thin-interpolated` with a ray a degree, every second traced",
         "laser.rays=181 laser.sample_skip=2"},
        {"thin-interpolated", "thin-interpolated-3-hz",
         "`thin-interpolated` with a scan at every third of Stage's steps of 100 ms",
         "laser.rate=3.3333"},
        {"thin-interpolated-3-hz", "thin-interpolated-3-hz-rest",
         "`thin-interpolated-3-hz`, and 5 s at rest first", "tour.rest=5"},
        {"thin-interpolated", "thin-interpolated-2-hz", "`thin-interpolated` with 2 scans a second",
         "laser.rate=2"},
        {"thin-interpolated-2-hz", "thin-interpolated-2-hz-faster",
         "`thin-interpolated-2-hz`, the robot quicker by a fifth, 0.6 m/s where the thesis says "
         "0.5",
         "robot.max_speed=0.6 robot.max_turn_rate=0.6 robot.acceleration=0.48 "
         "robot.turn_acceleration=1.2"},
        {"fitted-no-rest-2-pixels", "thin-2-hz-per-reading",
         "`fitted-no-rest-2-pixels` with 2 scans a second and motion noise for every odometry "
         "reading, five a scan",
         "laser.rate=2", 0.0, kFiveReadings},
        {"thin-interpolated-2-hz", "thin-interpolated-2-hz-per-reading",
         "`thin-2-hz-per-reading` with the laser of `interpolated`", "", 0.0, kFiveReadings},
        {"fitted-no-rest-2-pixels", "thin-odometry-2-hz",
         "`fitted-no-rest-2-pixels`, the odometry read, and disturbed, twice a second",
         "odometry.rate=2"},
        {"thin-interpolated", "thin-interpolated-odometry-2-hz",
         "`thin-odometry-2-hz` with the laser of `interpolated`", "odometry.rate=2"},
        {"fitted-no-rest-2-pixels", "thin-odometry-noise-0.2",
         "`fitted-no-rest-2-pixels`, odometry noise of 20 %", "odometry.noise=0.2"},
        {"thin-interpolated", "thin-interpolated-odometry-noise-0.2",
         "`thin-odometry-noise-0.2` with the laser of `interpolated`", "odometry.noise=0.2"},
        {"fitted-no-rest-2-pixels", "thin-odometry-variance",
         "`fitted-no-rest-2-pixels`, the odometry's noise alone a variance, of 0.03 times the "
         "speed",
         "odometry.noise=0.03 odometry.noise_kind=variance"},
        {"thin-interpolated", "thin-interpolated-odometry-variance",
         "`thin-odometry-variance` with the laser of `interpolated`",
         "odometry.noise=0.03 odometry.noise_kind=variance"},
        {"plain", "variances", "the thesis's words: motion and odometry noise are variances", "",
         0.0, 1.0, true},
        {"plain", "far-points", "rays without return are points at 8 m",
         "laser.no_return=max-range"},
    });
    std::vector<Reading> made;
    for (const ReadingStep& step : kSteps) {
        const auto base = std::ranges::find(made, step.base, &Reading::name);
        Reading reading = base != made.end() ? *base : Reading();
        reading.name = step.name;
        reading.sentence = step.sentence;
        for (const std::string_view change : input::fields(step.world)) {
            reading.world.emplace_back(change);
        }
        if (step.wall_pixels > 0.0) reading.wall_pixels = step.wall_pixels;
        reading.motion_factor *= step.motion_factor;
        reading.variances = reading.variances || step.variances;
        made.push_back(std::move(reading));
    }
    return made;
}

/// Metres per pixel of the thesis's picture of a world, by the size of its walls.
double pixel_m(const World& world) {
    constexpr double kSmall = 0.018;
    constexpr double kLarge = 0.032;
    constexpr double kBetween = 30.0;  // m
    double least = world.walls.front().a.x;
    double most = least;
    for (const WallSegment& wall : world.walls) {
        least = std::min({least, wall.a.x, wall.b.x});
        most = std::max({most, wall.a.x, wall.b.x});
    }
    return most - least > kBetween ? kLarge : kSmall;
}

}  // namespace

std::span<const Reading> readings() {
    static const std::vector<Reading> all = make_readings();
    return all;
}

const Reading& find_reading(std::string_view name) {
    std::vector<std::string_view> known;
    known.reserve(readings().size());
    for (const Reading& reading : readings()) {
        if (reading.name == name) return reading;
        known.emplace_back(reading.name);
    }
    throw ConfigError("--reading", HITOS_TEXT("Errors", "found '%1', expected one of %2"), name,
                      fmt::format("{}", fmt::join(known, ", ")));
}

const Reading& reading_as_published() {
    return find_reading(kAsPublished);
}

void apply(const Reading& reading, World& world) {
    if (reading.wall_pixels > 0.0) world.raster.wall_m = reading.wall_pixels * pixel_m(world);
    if (reading.variances) world.odometry.noise_kind = OdometryNoiseKind::variance;
    for (const std::string& change : reading.world) set_world_value(world, change);
    check(world);
}

void apply(const Reading& reading, Configuracion& configuration) {
    auto& motion = configuration.filter.motion;
    for (double* sigma : {&motion.sigma_x_m, &motion.sigma_y_m, &motion.sigma_theta_rad}) {
        if (reading.variances) *sigma = std::sqrt(*sigma);
        *sigma *= reading.motion_factor;
    }
    for (const std::string& change : reading.settings) set_parameter(configuration, change);
}

std::string text_of(const Reading& reading) {
    std::string text;
    for (const std::string& change : reading.world) text += change + "\n";
    for (const std::string& change : reading.settings) text += change + "\n";
    if (reading.wall_pixels > 0.0) text += fmt::format("wall pixels {}\n", reading.wall_pixels);
    if (reading.motion_factor != 1.0) text += fmt::format("motion x {}\n", reading.motion_factor);
    if (reading.variances) text += "variances\n";
    return text;
}

}  // namespace hitos
