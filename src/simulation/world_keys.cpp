// The keys of a world file that hold one value, and how they are set from words.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/simulation/world.hpp"
#include "world_values.hpp"

namespace hitos {
namespace {

using W = World;

std::vector<WorldKey> make_keys() {
    const std::vector<std::string_view> kinds(kOdometryNoiseWords.begin(),
                                              kOdometryNoiseWords.end());
    const std::vector<std::string_view> yes_no = {"false", "true"};
    return {
        {"seed",
         "",
         "seed of the laser's and the odometry's noise",
         0,
         0x1p53,
         true,
         {},
         [](const W& w) { return static_cast<double>(w.seed); },
         [](W& w, double v) { w.seed = static_cast<std::uint64_t>(v); }},
        {"tour.laps",
         "",
         "how often the way points are driven, end to end",
         1,
         1000,
         true,
         {},
         [](const W& w) { return static_cast<double>(w.tour.laps); },
         [](W& w, double v) { w.tour.laps = static_cast<int>(v); }},
        {"tour.rest",
         "s",
         "time at rest before the robot leaves",
         0,
         3600,
         false,
         {},
         [](const W& w) { return w.tour.rest_s; },
         [](W& w, double v) { w.tour.rest_s = v; }},
        {"tour.look_around", "", "turn once round on the spot before leaving", 0, 1, true, yes_no,
         [](const W& w) { return w.tour.look_around ? 1.0 : 0.0; },
         [](W& w, double v) { w.tour.look_around = v != 0.0; }},
        {"robot.radius",
         "m",
         "no wall may come nearer to the robot's centre",
         0,
         10,
         false,
         {},
         [](const W& w) { return w.robot.radius_m; },
         [](W& w, double v) { w.robot.radius_m = v; }},
        {"robot.max_speed",
         "m/s",
         "greatest speed",
         0.01,
         10,
         false,
         {},
         [](const W& w) { return w.robot.max_speed; },
         [](W& w, double v) { w.robot.max_speed = v; }},
        {"robot.acceleration",
         "m/s^2",
         "greatest change of speed",
         0.01,
         100,
         false,
         {},
         [](const W& w) { return w.robot.acceleration; },
         [](W& w, double v) { w.robot.acceleration = v; }},
        {"robot.max_turn_rate",
         "rad/s",
         "greatest turn rate",
         0.01,
         10,
         false,
         {},
         [](const W& w) { return w.robot.max_turn_rate; },
         [](W& w, double v) { w.robot.max_turn_rate = v; }},
        {"robot.turn_acceleration",
         "rad/s^2",
         "greatest change of the turn rate",
         0.01,
         100,
         false,
         {},
         [](const W& w) { return w.robot.turn_acceleration; },
         [](W& w, double v) { w.robot.turn_acceleration = v; }},
        {"robot.tolerance",
         "m",
         "every way point is passed at least this near",
         0.01,
         10,
         false,
         {},
         [](const W& w) { return w.robot.tolerance_m; },
         [](W& w, double v) { w.robot.tolerance_m = v; }},
        {"robot.control_rate",
         "Hz",
         "how often the robot's velocities are set anew",
         1,
         1000,
         false,
         {},
         [](const W& w) { return w.robot.control_rate_hz; },
         [](W& w, double v) { w.robot.control_rate_hz = v; }},
        {"laser.rays",
         "",
         "rays of a scan",
         2,
         100000,
         true,
         {},
         [](const W& w) { return static_cast<double>(w.laser.rays); },
         [](W& w, double v) { w.laser.rays = static_cast<int>(v); }},
        {"laser.field_of_view",
         "degrees",
         "from the first ray to the last",
         1,
         360,
         false,
         {},
         [](const W& w) { return w.laser.field_of_view_deg; },
         [](W& w, double v) { w.laser.field_of_view_deg = v; }},
        {"laser.max_range",
         "m",
         "walls further away give no reading",
         0.1,
         1000,
         false,
         {},
         [](const W& w) { return w.laser.max_range_m; },
         [](W& w, double v) { w.laser.max_range_m = v; }},
        {"laser.sigma",
         "m",
         "standard deviation of a range",
         0,
         1,
         false,
         {},
         [](const W& w) { return w.laser.sigma_m; },
         [](W& w, double v) { w.laser.sigma_m = v; }},
        {"laser.rate",
         "Hz",
         "scans per second",
         0.01,
         1000,
         false,
         {},
         [](const W& w) { return w.laser.rate_hz; },
         [](W& w, double v) { w.laser.rate_hz = v; }},
        {"laser.mount_x",
         "m",
         "the laser's place, ahead of the robot's centre",
         -10,
         10,
         false,
         {},
         [](const W& w) { return w.laser.mount_x_m; },
         [](W& w, double v) { w.laser.mount_x_m = v; }},
        {"laser.mount_y",
         "m",
         "the laser's place, left of the robot's centre",
         -10,
         10,
         false,
         {},
         [](const W& w) { return w.laser.mount_y_m; },
         [](W& w, double v) { w.laser.mount_y_m = v; }},
        {"laser.mount_heading",
         "degrees",
         "the laser's heading, left of the robot's",
         -180,
         180,
         false,
         {},
         [](const W& w) { return w.laser.mount_heading_deg; },
         [](W& w, double v) { w.laser.mount_heading_deg = v; }},
        {"odometry.rate",
         "Hz",
         "odometry readings per second",
         0.01,
         1000,
         false,
         {},
         [](const W& w) { return w.odometry.rate_hz; },
         [](W& w, double v) { w.odometry.rate_hz = v; }},
        {"odometry.noise",
         "",
         "level of the noise on v and w of each reading",
         0,
         10,
         false,
         {},
         [](const W& w) { return w.odometry.noise; },
         [](W& w, double v) { w.odometry.noise = v; }},
        {"odometry.noise_kind", "", "sigma = level |v|, or variance = level |v|", 0, 1, true, kinds,
         [](const W& w) {
             return w.odometry.noise_kind == OdometryNoiseKind::variance ? 1.0 : 0.0;
         },
         [](W& w, double v) {
             w.odometry.noise_kind =
                 v != 0.0 ? OdometryNoiseKind::variance : OdometryNoiseKind::relative_sigma;
         }},
    };
}

const std::vector<WorldKey>& keys() {
    static const std::vector<WorldKey> table = make_keys();
    return table;
}

}  // namespace

std::string WorldKey::allowed() const {
    if (!words.empty()) return fmt::format("one of {}", fmt::join(words, ", "));
    return fmt::format("{}{:g} to {:g}{}{}", integer ? "a whole number, " : "", minimum, maximum,
                       unit.empty() ? "" : " ", unit);
}

std::string WorldKey::text(const World& world) const {
    const double value = get(world);
    if (!words.empty()) return std::string(words[static_cast<std::size_t>(value)]);
    return fmt::format("{:.17g}", value) == fmt::format("{:g}", value) ? fmt::format("{:g}", value)
                                                                       : fmt::format("{}", value);
}

std::span<const WorldKey> world_keys() {
    return keys();
}

namespace world_values {

const WorldKey& find(std::string_view key) {
    const auto found = std::ranges::find(keys(), key, &WorldKey::key);
    if (found != keys().end()) return *found;
    const std::string_view group = key.substr(0, key.find('.') + 1);
    std::vector<std::string_view> near;
    for (const WorldKey& other : keys()) {
        if (!group.empty() && other.key.starts_with(group)) near.push_back(other.key);
    }
    if (group == "tour.") near.insert(near.end(), {"tour.start", "tour.way_points"});
    if (near.empty()) {
        for (const WorldKey& other : keys()) near.push_back(other.key);
    }
    throw ConfigError(std::string(key),
                      fmt::format("no such key; expected one of {}", fmt::join(near, ", ")));
}

void set_number(World& world, const WorldKey& key, double value) {
    const bool whole = !key.integer || value == std::floor(value);
    if (!key.words.empty() || !(value >= key.minimum && value <= key.maximum) || !whole) {
        throw ConfigError(std::string(key.key),
                          fmt::format("found {}, expected {}", value, key.allowed()));
    }
    key.set(world, value);
}

void set_word(World& world, const WorldKey& key, std::string_view word) {
    const auto found = std::ranges::find(key.words, word);
    if (found == key.words.end()) {
        throw ConfigError(std::string(key.key),
                          fmt::format("found \"{}\", expected {}", word, key.allowed()));
    }
    key.set(world, static_cast<double>(found - key.words.begin()));
}

}  // namespace world_values

void set_world_value(World& world, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        throw ConfigError(std::string(assignment), "found no \"=\", expected KEY=VALUE");
    }
    const WorldKey& key = world_values::find(assignment.substr(0, equals));
    const std::string_view text = assignment.substr(equals + 1);
    if (!key.words.empty()) {
        world_values::set_word(world, key, text);
        return;
    }
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error != std::errc{}) {
        throw ConfigError(std::string(key.key),
                          fmt::format("found \"{}\", expected {}", text, key.allowed()));
    }
    world_values::set_number(world, key, value);
}

void check(const World& world) {
    for (const WorldKey& key : keys()) {
        const double value = key.get(world);
        if (!(value >= key.minimum && value <= key.maximum)) {
            throw ConfigError(std::string(key.key),
                              fmt::format("found {}, expected {}", value, key.allowed()));
        }
    }
    if (world.walls.empty()) throw ConfigError("walls", "found none, expected one or more");
    if (world.tour.way_points.empty()) {
        throw ConfigError("tour.way_points", "found none, expected one or more");
    }
}

}  // namespace hitos
