// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_placing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "hitos/simulation/farthest.hpp"

namespace hitos::dxf {
namespace {

/// Metres per unit for the values of $INSUNITS, from 1 on.
constexpr std::array kUnits = {0.0254,
                               0.3048,
                               1609.344,
                               1e-3,
                               1e-2,
                               1.0,
                               1e3,
                               2.54e-8,
                               2.54e-5,
                               0.9144,
                               1e-10,
                               1e-9,
                               1e-6,
                               0.1,
                               10.0,
                               100.0,
                               1e9,
                               149597870700.0,
                               9460730472580800.,
                               3.0856775814913673e16,
                               1200.0 / 3937.0,
                               100.0 / 3937.0,
                               3600.0 / 3937.0,
                               6336000.0 / 3937.0};

/// Between these the places lie that robots map [m], the longer side.
constexpr double kSmall = 2.0;
constexpr double kLarge = 2000.0;
/// Where no unit is said, so that a room in centimetres or feet looks like a quarter of a town.
constexpr double kLargeUnsaid = 300.0;

bool reasonable(double size_m, double most_m = kLarge) {
    return size_m >= kSmall && size_m <= most_m;
}

Bounds bounds_of(const std::vector<Wall>& walls) {
    Bounds box;
    for (const Wall& wall : walls) {
        for (const Point2& point : wall.points) box.hold(point);
    }
    return box;
}

/// What lies so far from most of the walls that no world holds both. Twice half the reach is what
/// stays.
std::vector<Wall> without_strays(std::vector<Wall> walls, DxfWalls& result) {
    const Bounds box = bounds_of(walls);
    const auto reach = [](double from, double to) { return !(to - from <= kFarthest); };
    if (walls.empty() || !(reach(box.low.x, box.high.x) || reach(box.low.y, box.high.y)))
        return walls;
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Wall& wall : walls) {
        xs.push_back(wall.points.front().x);
        ys.push_back(wall.points.front().y);
    }
    const auto middle = [](std::vector<double>& values) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, at);
        return *at;
    };
    const Point2 most{middle(xs), middle(ys)};
    std::map<std::string, std::size_t> strays;
    std::erase_if(walls, [&](const Wall& wall) {
        const bool stray = !std::ranges::all_of(wall.points, [&](const Point2& point) {
            return std::abs(point.x - most.x) <= kFarthest / 2.0 &&
                   std::abs(point.y - most.y) <= kFarthest / 2.0;
        });
        if (stray) ++strays[fmt::format("{} ({})", wall.type, wall.layer)];
        return stray;
    });
    std::vector<std::string> names;
    names.reserve(strays.size());
    for (const auto& [name, count] : strays) names.push_back(fmt::format("{} {}", count, name));
    result.warnings.push_back(message(HITOS_TEXT("Errors",
                                                 "drawing: left out, farther from the rest than a "
                                                 "world reaches: %1; are they in the right place?"),
                                      fmt::format("{}", fmt::join(names, ", "))));
    return walls;
}

std::string size_of(double width, double height) {
    return fmt::format("{:.6g} m x {:.6g} m", width, height);
}

/// By the units that would make it a place for robots.
std::string other_sizes(double width, double height, double taken_m) {
    std::vector<std::string> sizes;
    for (const auto& [word, metres, name] : kDrawingUnits) {
        if (metres != taken_m && reasonable(std::max(width, height) * metres))
            sizes.push_back(fmt::format("{}: {}", word, size_of(width * metres, height * metres)));
    }
    return fmt::format("{}", fmt::join(sizes, ", "));
}

void tell_size(const Bounds& box, const Unit& unit, DxfWalls& result) {
    const double width = box.high.x - box.low.x;
    const double height = box.high.y - box.low.y;
    result.notes.push_back(unit.note);
    if (reasonable(std::max(width, height), unit.known ? kLarge : kLargeUnsaid)) return;
    const std::string size = size_of(width, height);
    const std::string others = other_sizes(width / unit.metres, height / unit.metres, unit.metres);
    if (!unit.known && reasonable(std::max(width, height)) && !others.empty()) {
        result.warnings.push_back(message(
            HITOS_TEXT("Errors",
                       "drawing: as metres, which nothing says, it is %1, large for a place that a "
                       "robot maps. By other units (--unit, dxf_unit) it is: %2"),
            size, others));
        return;
    }
    result.warnings.push_back(
        others.empty()
            ? message(HITOS_TEXT("Errors",
                                 "drawing: %1 is no size of a place that a robot maps; is anything "
                                 "far from the rest, or missing?"),
                      size)
            : message(HITOS_TEXT("Errors",
                                 "drawing: %1 is no size of a place that a robot maps; is the unit "
                                 "right? By others (--unit, dxf_unit) it is: %2"),
                      size, others));
}

}  // namespace

Unit unit_of(std::optional<int> insunits, std::optional<double> asked) {
    if (asked) {
        return {*asked, true,
                message(HITOS_TEXT("Errors", "drawing: unit %1 m, as asked"), *asked)};
    }
    const int value = insunits.value_or(0);
    if (value >= 1 && value <= static_cast<int>(kUnits.size())) {
        const double metres = kUnits[static_cast<std::size_t>(value) - 1];
        return {metres, true,
                message(HITOS_TEXT("Errors", "drawing: unit %1 m, as it says ($INSUNITS %2)"),
                        metres, value)};
    }
    return {1.0, false,
            message(HITOS_TEXT("Errors",
                               "drawing: tells no unit ($INSUNITS); taken for metres, another one "
                               "is given by --unit, or dxf_unit of a world"))};
}

void place(std::vector<Wall> walls, const Unit& unit, double far_m, DxfWalls& result) {
    walls = without_strays(std::move(walls), result);
    if (walls.empty()) return;
    Bounds box = bounds_of(walls);
    const Point2 nearest{std::clamp(0.0, box.low.x, box.high.x),
                         std::clamp(0.0, box.low.y, box.high.y)};
    const double most = std::max(
        {std::abs(box.low.x), std::abs(box.high.x), std::abs(box.low.y), std::abs(box.high.y)});
    if (std::isfinite(far_m) && (distance(nearest, {}) > far_m || most > kFarthest)) {
        result.moved = {std::floor(box.low.x), std::floor(box.low.y)};
        result.warnings.push_back(
            message(HITOS_TEXT("Errors",
                               "drawing: lies far from its origin, as in survey coordinates; moved "
                               "by (%1, %2) m, so that its lower left corner is near (0, 0)"),
                    fmt::format("{:.0f}", 0.0 - result.moved.x),
                    fmt::format("{:.0f}", 0.0 - result.moved.y)));
    }
    const auto rounded = [](double value) {
        constexpr double kDigit = 1e9;  // nanometres: sums that were exact in the drawing are again
        return std::round(value * kDigit) / kDigit + 0.0;
    };
    for (Wall& wall : walls) {
        for (Point2& point : wall.points)
            point = {rounded(point.x - result.moved.x), rounded(point.y - result.moved.y)};
        wall.points.erase(std::unique(wall.points.begin(), wall.points.end()), wall.points.end());
        if (wall.points.size() >= 2) result.walls.push_back(std::move(wall.points));
    }
    tell_size(box, unit, result);
}

}  // namespace hitos::dxf
