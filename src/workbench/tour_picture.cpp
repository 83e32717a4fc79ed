// SPDX-License-Identifier: GPL-3.0-or-later
#include "tour_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {
namespace {

// Pixels.
constexpr double kLongestSide = 1400.0;
constexpr double kMostPixelsPerM = 100.0;  // for small rooms
constexpr double kMargin = 30.0;           // around everything
constexpr double kFooter = 50.0;           // below for bar and legend

constexpr Colour kTruth{220, 40, 40};
constexpr Colour kOdometry{170, 170, 170};
constexpr Colour kWayPoints{20, 90, 200};
constexpr Colour kStart{0, 150, 0};

std::vector<Point2> true_path(const SimulatedTour& tour) {
    std::vector<Point2> points;
    for (const Pose& pose : tour.path().poses()) points.push_back({pose.x, pose.y});
    return points;
}

std::vector<Point2> odometry_path(const SimulatedTour& tour) {
    const World& world = tour.world();
    OdometryNoise noise(world.odometry.noise, world.odometry.noise_kind, world.seed);
    std::vector<Point2> points;
    Pose pose = world.tour.start;
    for (std::uint64_t k = 0; k < tour.readings(); ++k) {
        const Odometria reading = noise(tour.true_reading(k));
        if (k > 0) pose = compose(pose, displacement(reading.twist, 1.0 / world.odometry.rate_hz));
        points.push_back({pose.x, pose.y});
    }
    return points;
}

void add_words(VectorDrawing& picture, const Point2& at, const std::string& text,
               const Colour& colour) {
    picture.layers.push_back({"words", word_style(colour, kPictureLetters)});
    picture.layers.back().texts = {{at, text}};
}

void add_footer(VectorDrawing& picture, const SimulatedTour& tour, double pixels_per_m) {
    const double y = picture.height - kFooter + 10.0;
    add_scale_bar(picture, {kMargin, y + 15.0}, 160.0, pixels_per_m);
    const double x = kMargin + 190.0;
    add_words(picture, {x, y + 4.0},
              fmt::format("{}: {:.0f} m in {:.0f} s", tour.world().name, tour.path().length_m(),
                          tour.path().duration_s()),
              kBlack);
    add_words(picture, {x, y + 24.0}, "true path", kTruth);
    add_words(picture, {x + 90.0, y + 24.0}, "odometry", {136, 136, 136});
    add_words(picture, {x + 180.0, y + 24.0}, "way points", kWayPoints);
    add_words(picture, {x + 280.0, y + 24.0}, "start", kStart);
}

void add_way_points(VectorDrawing& picture, const std::vector<WayPoint>& points,
                    const Placement& placement) {
    DrawnLayer rings{"way-points", line_style(kWayPoints, 1.0)};
    DrawnLayer numbers{"numbers", word_style(kWayPoints, kPictureLetters)};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point2 at = placement.at(points[i].at);
        double x = at.x + 6.0;
        for (std::size_t k = 0; k < i; ++k) {
            // Numbers of a way point that is passed twice stand one beside the other.
            const Point2& other = points[k].at;
            if (std::hypot(other.x - points[i].at.x, other.y - points[i].at.y) < 0.6) x += 20.0;
        }
        rings.ellipses.push_back(disc(at, 4.0));
        numbers.texts.push_back({{x, at.y - 6.0}, std::to_string(i + 1)});
    }
    picture.layers.push_back(std::move(rings));
    picture.layers.push_back(std::move(numbers));
}

VectorDrawing drawn(const SimulatedTour& tour) {
    const World& world = tour.world();
    const std::vector<Point2> truth = true_path(tour);
    // The odometry may run far off: it is cut where walls and path end.
    Bounds bounds;
    for (const WallSegment& wall : world.walls) {
        bounds.hold(wall.a);
        bounds.hold(wall.b);
    }
    for (const Point2& point : world.landmarks.at) bounds.hold(point);
    for (const Point2& point : truth) bounds.hold(point);
    const double width = std::max(bounds.high.x - bounds.low.x, 0.1);
    const double height = std::max(bounds.high.y - bounds.low.y, 0.1);
    const double per_m = std::min(kLongestSide / std::max(width, height), kMostPixelsPerM);
    const Placement placement{bounds.low, {kMargin, kMargin + height * per_m}, per_m};
    const auto placed = [&](const std::vector<Point2>& points) {
        DrawnLine line;
        for (const Point2& point : points) line.push_back(placement.at(point));
        return line;
    };
    constexpr double kLeastWidth = 560.0;  // of the legend

    VectorDrawing picture;
    picture.width = std::max(width * per_m, kLeastWidth) + 2.0 * kMargin;
    picture.height = std::floor(height * per_m) + 2.0 * kMargin + kFooter;
    picture.frame = {{0.0, 0.0}, {picture.width, picture.height - kFooter}, false};
    DrawnLayer odometry{"odometry", line_style(kOdometry, 1.5), true};
    odometry.lines = {placed(odometry_path(tour))};
    DrawnLayer walls{"walls", line_style(kBlack, 3.0)};
    for (const WallSegment& wall : world.walls) walls.lines.push_back(placed({wall.a, wall.b}));
    DrawnLayer marks{"landmarks", {.fill = kBlack}};
    for (std::size_t i = 0; i < world.landmarks.at.size(); ++i) {
        constexpr double kLeast = 3.0;  // pixels
        const double radius = world.landmarks.round() ? world.landmarks.radii_m[i] * per_m : 0.0;
        marks.ellipses.push_back(
            disc(placement.at(world.landmarks.at[i]), std::max(kLeast, radius)));
    }
    DrawnLayer path{"path", line_style(kTruth, 1.5)};
    path.lines = {placed(truth)};
    picture.layers = {std::move(odometry), std::move(walls), std::move(marks), std::move(path)};
    add_way_points(picture, world.tour.way_points, placement);
    const Pose& start = world.tour.start;
    const Point2 ahead = transform(start, Point2{25.0 / per_m, 0.0});
    DrawnLayer robot{"start", {.fill = kStart, .line = kStart, .line_width = 3.0}};
    robot.lines = {placed({{start.x, start.y}, ahead})};
    robot.ellipses = {disc(robot.lines[0][0], 4.5)};
    picture.layers.push_back(std::move(robot));
    add_footer(picture, tour, per_m);
    return picture;
}

}  // namespace

void write_tour_picture(const SimulatedTour& tour, const std::filesystem::path& path) {
    write_picture(drawn(tour), path);
}

}  // namespace hitos
