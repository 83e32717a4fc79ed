// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_shapes.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr int kBandSteps = 12;  // pieces of each side of a line's band, which is curved

/// Beyond it the buffers of libraries end, and no building.
constexpr double kGreatestCoordinate = 1e9;  // m

bool drawable(const Point2& point) {
    return std::abs(point.x) <= kGreatestCoordinate && std::abs(point.y) <= kGreatestCoordinate;
}

void check_drawable(const Point2& point, const Message& what) {
    if (drawable(point)) return;
    throw Error(message(HITOS_TEXT("Errors",
                                   "%1 is at (%2, %3) and cannot be drawn; expected coordinates up "
                                   "to %4 m: check the log's readings and the motion noise"),
                        what, point.x, point.y, fmt::format("{:g}", kGreatestCoordinate)));
}

void add_corner(MapShapes& shapes, const Esquina& corner, const Eigen::Matrix2d& covariance,
                double sigmas) {
    shapes.corners.push_back({corner.x, corner.y});
    shapes.box.hold({corner.x, corner.y});
    if (!is_known(covariance)) return;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);  // least first
    const double greatest = std::max(axes.eigenvalues()[1], 0.0);
    const double least = std::max(axes.eigenvalues()[0], 0.0);
    if (!(greatest > 0.0)) return;
    const double wide = sigmas * std::sqrt(std::max(covariance(0, 0), 0.0));
    const double high = sigmas * std::sqrt(std::max(covariance(1, 1), 0.0));
    if (!drawable({std::abs(corner.x) + wide, std::abs(corner.y) + high})) return;
    const Eigen::Vector2d major = sigmas * std::sqrt(greatest) * axes.eigenvectors().col(1);
    shapes.ellipses.push_back(
        {{corner.x, corner.y}, {major.x(), major.y()}, std::sqrt(least / greatest)});
    shapes.box.hold({corner.x - wide, corner.y - high});
    shapes.box.hold({corner.x + wide, corner.y + high});
}

void add_band(MapShapes& shapes, const LineExtent& segment, const Recta& line,
              const Eigen::Matrix2d& covariance, double sigmas) {
    if (!is_known(covariance)) return;
    const PreparedRecta prepared(line);
    std::vector<Point2> band;
    for (const double side : {1.0, -1.0}) {
        for (int i = 0; i <= kBandSteps; ++i) {
            const double part = static_cast<double>(side > 0.0 ? i : kBandSteps - i) / kBandSteps;
            const Point2 on{segment.a.x + part * (segment.b.x - segment.a.x),
                            segment.a.y + part * (segment.b.y - segment.a.y)};
            const double t = prepared.along(on);
            const double variance =
                covariance(0, 0) - 2.0 * t * covariance(0, 1) + t * t * covariance(1, 1);
            const double across = side * sigmas * std::sqrt(std::max(variance, 0.0));
            band.push_back({on.x + across * prepared.c, on.y + across * prepared.s});
        }
    }
    if (!std::ranges::all_of(band, drawable)) return;
    std::ranges::for_each(band, [&](const Point2& point) { shapes.box.hold(point); });
    shapes.bands.push_back(std::move(band));
}

}  // namespace

MapShapes map_shapes(const LandmarkMap& map, std::span<const LineExtent> segments,
                     const Trajectory& path, double sigmas) {
    MapShapes shapes;
    for (std::size_t i = 0; i < map.size(); ++i) {
        check_drawable(map[i].point(), message(HITOS_TEXT("Errors", "landmark %1"), i));
        if (const auto* corner = std::get_if<Esquina>(&map[i].value)) {
            add_corner(shapes, *corner, map[i].covariance, sigmas);
        }
    }
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const LineExtent& segment = segments[i];
        const auto index = static_cast<std::size_t>(segment.landmark);
        const Recta* line = segment.landmark < 0 || index >= map.size()
                                ? nullptr
                                : std::get_if<Recta>(&map[index].value);
        if (line == nullptr) {
            throw Error(message(
                HITOS_TEXT("Errors",
                           "segment %1 belongs to landmark %2, which is no line of the map"),
                i, segment.landmark));
        }
        for (const Point2& end : {segment.a, segment.b}) {
            check_drawable(end, message(HITOS_TEXT("Errors", "an end of segment %1"), i));
            shapes.box.hold(end);
        }
        shapes.lines.emplace_back(segment.a, segment.b);
        add_band(shapes, segment, *line, map[index].covariance, sigmas);
    }
    for (std::vector<Point2>& line : lines_of(path)) {
        for (const Point2& place : line)
            check_drawable(place, message(HITOS_TEXT("Errors", "the path")));
        line.erase(std::unique(line.begin(), line.end()), line.end());
        if (line.size() < 2) continue;
        std::ranges::for_each(line, [&](const Point2& place) { shapes.box.hold(place); });
        shapes.paths.push_back(std::move(line));
    }
    return shapes;
}

}  // namespace hitos
