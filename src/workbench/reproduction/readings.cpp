#include "hitos/workbench/readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

std::vector<Reading> make_readings() {
    return {
        {"plain", "the worlds as they are, motion noise as standard deviations"},
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
    throw ConfigError("--reading",
                      fmt::format("found '{}', expected one of {}", name, fmt::join(known, ", ")));
}

const Reading& reading_as_published() {
    return readings().back();
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
