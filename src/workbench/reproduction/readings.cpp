#include "hitos/workbench/readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr std::string_view kAsPublished = "fitted-no-rest-2-pixels";

/// What a reading adds to another one.
struct More {
    std::vector<std::string> world = {};
    double wall_pixels = 0.0;
    double motion_factor = 1.0;
};

Reading with_more(Reading base, std::string name, std::string sentence, const More& more) {
    base.name = std::move(name);
    base.sentence = std::move(sentence);
    base.world.insert(base.world.end(), more.world.begin(), more.world.end());
    if (more.wall_pixels > 0.0) base.wall_pixels = more.wall_pixels;
    base.motion_factor *= more.motion_factor;
    return base;
}

std::vector<Reading> make_readings() {
    const Reading plain{"plain",
                        "the worlds as they are: exact walls, 3 mm of noise, 5 s at rest, then "
                        "northwards"};
    Reading variances = plain;
    variances.name = "variances";
    variances.sentence = "the thesis's words: motion and odometry noise are variances";
    variances.variances = true;
    // Walls 3 pixels thick in cells of 2 cm are [T 10.3.1]; how its version of Stage fitted the
    // picture and counted ranges the thesis does not say.
    const Reading walls =
        with_more(plain, "thick-walls",
                  "cells of 2 cm, walls 3 pixels thick about their lines, no noise of ranges",
                  {{"raster.cell=0.02", "laser.sigma=0"}, 3.0});
    const Reading fitted =
        with_more(walls, "fitted-walls",
                  "`thick-walls`, the picture's ink fitted to the world's size, so "
                  "that outer walls lie wholly inside",
                  {{"raster.fit=true"}});
    const Reading stage = with_more(
        fitted, "stage", "`fitted-walls`, ranges counted in whole cells as Stage 3 and 4 do",
        {{"raster.ranges=whole-cells"}});
    const Reading stage_no_rest = with_more(
        stage, "stage-no-rest", "`stage`, and the robot leaves at once", {{"tour.rest=0"}});
    const Reading fitted_no_rest =
        with_more(fitted, "fitted-no-rest", "`fitted-walls`, and the robot leaves at once",
                  {{"tour.rest=0"}});
    constexpr double kTwoReadings = 1.4142135623730951;
    return {
        plain,
        walls,
        fitted,
        stage,
        with_more(plain, "no-rest", "the robot leaves at once", {{"tour.rest=0"}}),
        fitted_no_rest,
        // Stage's own description of this laser has 361 rays.
        with_more(fitted_no_rest, "fitted-no-rest-361-rays",
                  "`fitted-no-rest` with a ray every half degree", {{"laser.rays=361"}}),
        with_more(fitted_no_rest, "fitted-no-rest-per-reading",
                  "`fitted-no-rest`, motion noise drawn for every odometry reading, two a scan",
                  {{}, 0.0, kTwoReadings}),
        with_more(fitted_no_rest, "fitted-no-rest-east",
                  "`fitted-no-rest` with tours that leave eastwards", {{"tour.reverse=true"}}),
        with_more(fitted_no_rest, "fitted-no-rest-2-pixels",
                  "`fitted-no-rest`, walls 2 pixels thick", {{}, 2.0}),
        with_more(fitted_no_rest, "fitted-no-rest-2-pixels-361-rays",
                  "`fitted-no-rest` with both, thinner walls and more rays",
                  {{"laser.rays=361"}, 2.0}),
        with_more(fitted_no_rest, "fitted-no-rest-2-hz",
                  "`fitted-no-rest` with 2 scans a second, not 5", {{"laser.rate=2"}}),
        stage_no_rest,
        with_more(stage_no_rest, "stage-no-rest-361-rays",
                  "`stage-no-rest` with a ray every half degree", {{"laser.rays=361"}}),
        variances,
        with_more(plain, "far-points", "rays without return are points at 8 m",
                  {{"laser.no_return=max-range"}}),
    };
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
