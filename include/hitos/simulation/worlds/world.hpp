// SPDX-License-Identifier: GPL-3.0-or-later
// A world to simulate: walls, the tour through them, robot, laser and odometry [T 10.2].
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"
#include "hitos/simulation/worlds/disturbance.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {

/// One straight piece of a wall, seen from both sides [m, world frame].
struct WallSegment {
    Point2 a;
    Point2 b;
    int wall = 0;            ///< number of its polyline, from 1, for messages
    std::uint64_t line = 0;  ///< in the world file; 0: it comes from a drawing
};

/// A point that the robot drives to [m].
struct WayPoint {
    Point2 at;
    std::uint64_t line = 0;  ///< in the world file
};

/// Velocities that are asked of the robot for a time, as by somebody who drives it by hand.
struct DriveCommand {
    double v = 0.0;           ///< m/s, backwards below 0
    double w = 0.0;           ///< rad/s
    double duration_s = 0.0;  ///< rounded to whole control periods
    std::uint64_t line = 0;   ///< in the world file
};

/// Somebody who walks along a way: round and round where it ends at its beginning, else to and fro.
/// The laser sees a circle. Walkers step aside: the robot is never stopped by them.
struct Walker {
    std::vector<Point2> way;  ///< [m, world frame], two points or more
    double speed = 0.8;       ///< m/s
    double radius_m = 0.25;
    std::uint64_t line = 0;  ///< in the world file
};

/// How the robot drives.
struct TourParams {
    Pose start;                          ///< of the robot in the world
    std::vector<WayPoint> way_points;    ///< of one lap
    std::vector<DriveCommand> commands;  ///< instead of way points
    std::vector<Disturbance> events;
    int laps = 1;              ///< how often the list is driven, end to end
    double rest_s = 5.0;       ///< at rest before it leaves
    bool look_around = false;  ///< turns once round on the spot before it leaves
    bool reverse = false;      ///< the list backwards, its last point still last
    std::uint64_t line = 0;    ///< of the way points in the world file
};

/// The defaults are a Pioneer 3-DX (swing radius 0.26 m), driven gently.
struct RobotParams {
    double radius_m = 0.26;
    double max_speed = 0.5;          ///< m/s
    double acceleration = 0.4;       ///< m/s^2, speeding up and braking
    double max_turn_rate = 0.5;      ///< rad/s
    double turn_acceleration = 1.0;  ///< rad/s^2
    double tolerance_m = 0.1;        ///< every way point is passed at least this near
    double control_rate_hz = 10.0;   ///< the velocities are set anew this often and held between
    double track_m = 0.33;           ///< between the wheels; where one slips
};

/// What a ray that meets no wall within the greatest range gives.
enum class NoReturn {
    none,      ///< no point; it ends a run of neighbours
    max_range  ///< a point at the greatest range, as programs make that do not ask for it
};

/// The defaults are a SICK LMS-200 at one degree and 8 m.
struct LaserParams {
    int rays = 181;
    double field_of_view_deg = 180.0;  ///< symmetric about the laser's heading, unless turned:
    double fan_turn_deg = 0.0;         ///< of the fan in the laser's frame, to the left
    bool clockwise = false;            ///< the rays follow each other to the right
    double max_range_m = 8.0;
    double sigma_m = 0.01;  ///< standard deviation of a range
    double rate_hz = 5.0;
    bool sweep = false;      ///< the rays are measured one after the other, a turn in 1 / rate_hz
    double mount_x_m = 0.0;  ///< of the laser in the robot frame
    double mount_y_m = 0.0;
    double mount_heading_deg = 0.0;
    NoReturn no_return = NoReturn::none;
    int sample_skip = 1;  ///< one ray in so many is traced, those between interpolated
};

/// How the range of a ray is taken from the raster.
enum class RasterRanges {
    exact,       ///< distance to the edge of the first occupied cell
    whole_cells  ///< cells walked along the ray's longer axis, over its cosine: Stage 3 and 4
};

/// The picture of the walls that a simulator with a grid sees instead of them [T 10.3.1].
struct RasterParams {
    double cell_m = 0.0;  ///< 0: the laser sees the walls themselves
    double wall_m = 0.0;  ///< how thick the walls are drawn
    /// The drawing is shrunk until its ink fits between the outermost walls, which is how Stage
    /// brings a picture to its size: the outer walls then lie wholly inside their lines.
    bool fit = false;
    RasterRanges ranges = RasterRanges::exact;
};

/// What the wheels say.
struct OdometryParams {
    double rate_hz = 10.0;  ///< part of the noise's definition: each reading is disturbed anew
    double noise = 0.1;
    OdometryNoiseKind noise_kind = OdometryNoiseKind::relative_sigma;
};

/// Posts, beacons, marks with a code: landmarks that a sensor tells from the rest by themselves. A
/// robot in a world that has some has such a sensor in the place of the laser, where that would
/// sit, with its field of view, greatest range and rate; walls hide what is behind them. With radii
/// they are trees and posts that a laser sees as circles, and the robot has its laser.
struct MarkParams {
    std::vector<Point2> at;       ///< [m, world frame]; a mark's place in the list is its identity
    std::vector<double> radii_m;  ///< of each; empty where none is round
    double sigma_range_m = 0.1;
    double sigma_bearing_deg = 2.0;
    bool identities = true;  ///< whether the sensor tells which one it sees

    /// Whether there are some that a sensor tells by themselves.
    bool told() const { return !at.empty() && radii_m.empty(); }
    /// Whether there are some that a laser sees.
    bool round() const { return !radii_m.empty(); }
};

/// A place with walls, a tour through it and the robot's sensors, as a world file says.
struct World {
    std::string name;                       ///< the file's name without folder and extension
    std::string file;                       ///< path, for messages
    std::filesystem::path drawing;          ///< from which walls come too; empty: none
    std::vector<Message> drawing_notes;     ///< what became of it (DxfWalls)
    std::vector<Message> drawing_warnings;  ///< where walls of it may be missing
    std::vector<WallSegment> walls;
    std::vector<WallSegment> doors;  ///< walls that open and close, closed at the start
    std::vector<Walker> walkers;
    MarkParams landmarks;
    TourParams tour;
    RobotParams robot;
    LaserParams laser;
    RasterParams raster;
    OdometryParams odometry;
    /// Of the laser's and the odometry's noise; 0: whoever opens the tour chooses, else 1.
    std::uint64_t seed = 0;
};

/// Reads a world file (TOML, docs/simulation.md) and the drawing that it names. Throws FileError
/// where a file cannot be read and FormatError, with the line, for what it cannot be. A world
/// without way points and commands is one to drive by hand (SimulatedTour::live); check() refuses
/// it.
World read_world(const std::filesystem::path& path);

/// As read_world(), from text; `path` stands in messages and a drawing is looked for beside it.
World parse_world(std::string_view text, const std::filesystem::path& path);

/// Changes one value by "key=value". Throws ConfigError that says what is allowed.
void set_world_value(World& world, std::string_view assignment);

/// What speaks against it; empty where nothing does.
Message problem_of(const DriveCommand& command, const RobotParams& robot);
Message problem_of(const Walker& walker);
Message problem_of(const MarkParams& marks);

/// Throws ConfigError for a value out of its range, and FormatError where there is no tour; code
/// can fill the struct without a file.
void check(const World& world);

/// The distance [m] of a point from a wall.
double distance(const WallSegment& wall, const Point2& point);

/// The least distance [m] between a wall and the straight way from `from` to `to`.
double distance(const WallSegment& wall, const Point2& from, const Point2& to);

using Polyline = std::vector<Point2>;  ///< [m]; closed where its first point is the last one too

/// The square of a DisturbanceKind::box, closed.
Polyline box_outline(const Disturbance& box);

}  // namespace hitos
