// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr double kBoundless = std::numeric_limits<double>::infinity();
/// One byte each; a building of 200 x 100 m in cells of 2 cm has 50 million.
constexpr double kMostCells = 6.4e7;
/// Walls are at least this thick, so that one on the border of cells is in those on both sides, and
/// what only touches a cell from outside, but for rounding, does not occupy it.
constexpr double kThinnest = 1e-6;  // m
constexpr double kTouch = 1e-9;     // m

struct Box {
    Point2 least{kBoundless, kBoundless};
    Point2 most{-kBoundless, -kBoundless};

    void add(const Point2& p) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
};

using Quad = std::array<Point2, 4>;

/// The wall as it is drawn, in order round.
Quad ink_of(const WallSegment& wall, double thickness_m) {
    const double half = 0.5 * std::max(thickness_m, kThinnest);
    const double dx = wall.b.x - wall.a.x;
    const double dy = wall.b.y - wall.a.y;
    const double length = std::hypot(dx, dy);
    const Point2 along{half * dx / length, half * dy / length};
    const Point2 a{wall.a.x - along.x, wall.a.y - along.y};
    const Point2 b{wall.b.x + along.x, wall.b.y + along.y};
    return {Point2{a.x - along.y, a.y + along.x}, Point2{b.x - along.y, b.y + along.x},
            Point2{b.x + along.y, b.y - along.x}, Point2{a.x + along.y, a.y - along.x}};
}

/// All walls as they are drawn.
std::vector<Quad> draw(const std::vector<WallSegment>& walls, const RasterParams& params) {
    std::vector<Quad> ink;
    ink.reserve(walls.size());
    Box lines;
    Box drawn;
    for (const WallSegment& wall : walls) {
        lines.add(wall.a);
        lines.add(wall.b);
        for (const Point2& p : ink.emplace_back(ink_of(wall, params.wall_m))) drawn.add(p);
    }
    if (!params.fit) return ink;
    const auto fitted = [](double value, double drawn_least, double drawn_most, double least,
                           double most) {
        return least + (value - drawn_least) * (most - least) / (drawn_most - drawn_least);
    };
    for (Quad& quad : ink) {
        for (Point2& p : quad) {
            p = {fitted(p.x, drawn.least.x, drawn.most.x, lines.least.x, lines.most.x),
                 fitted(p.y, drawn.least.y, drawn.most.y, lines.least.y, lines.most.y)};
        }
    }
    return ink;
}

Box box_of(const std::vector<Quad>& ink) {
    Box box;
    for (const Quad& quad : ink) {
        for (const Point2& p : quad) box.add(p);
    }
    return box;
}

/// Whether no line along a side of the quad parts it from the square; lines along the axes are
/// left to the caller.
bool meets(const Quad& quad, const Point2& least, const Point2& most) {
    for (std::size_t i = 0; i < quad.size(); ++i) {
        const Point2& a = quad[i];
        const Point2& b = quad[(i + 1) % quad.size()];
        const Point2& inside = quad[(i + 2) % quad.size()];
        // Normal of the side, towards the quad's inside.
        Point2 normal{a.y - b.y, b.x - a.x};
        if (normal.x * (inside.x - a.x) + normal.y * (inside.y - a.y) < 0.0) {
            normal = {-normal.x, -normal.y};
        }
        const double deepest = normal.x * ((normal.x > 0.0 ? most.x : least.x) - a.x) +
                               normal.y * ((normal.y > 0.0 ? most.y : least.y) - a.y);
        if (deepest <= kTouch * std::hypot(normal.x, normal.y)) return false;
    }
    return true;
}

}  // namespace

void check_raster(const std::vector<WallSegment>& walls, const RasterParams& params) {
    if (walls.empty()) return;
    const Box box = box_of(draw(walls, params));
    const double columns = (box.most.x - box.least.x) / params.cell_m + 2.0;
    const double rows = (box.most.y - box.least.y) / params.cell_m + 2.0;
    if (columns * rows > kMostCells) {
        throw ConfigError("raster.cell",
                          HITOS_TEXT("Errors",
                                     "found %1 m for walls over %2 x %3 m, which is %4 cells; "
                                     "expected at most %5, so take greater cells"),
                          fmt::format("{:g}", params.cell_m),
                          fmt::format("{:g}", box.most.x - box.least.x),
                          fmt::format("{:g}", box.most.y - box.least.y),
                          fmt::format("{:.3g}", columns * rows), fmt::format("{:.3g}", kMostCells));
    }
}

WallRaster::WallRaster(const std::vector<WallSegment>& walls, const RasterParams& params)
    : cell_m_(params.cell_m) {
    if (!(cell_m_ > 0.0)) {
        throw ConfigError("raster.cell", HITOS_TEXT("Errors", "found %1, expected more than 0"),
                          fmt::format("{:g}", cell_m_));
    }
    if (walls.empty()) return;
    check_raster(walls, params);
    const std::vector<Quad> ink = draw(walls, params);
    const auto cell_of = [&](double value) {
        return static_cast<std::int64_t>(std::floor(value / cell_m_));
    };
    const Box all = box_of(ink);
    left_ = cell_of(all.least.x);
    bottom_ = cell_of(all.least.y);
    columns_ = cell_of(all.most.x) - left_ + 1;
    rows_ = cell_of(all.most.y) - bottom_ + 1;
    cells_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
    for (const Quad& quad : ink) {
        const Box box = box_of({quad});
        // What only touches the next cell is not in it.
        const std::int64_t first_x = cell_of(box.least.x + kTouch);
        const std::int64_t last_x = cell_of(box.most.x - kTouch);
        const std::int64_t first_y = cell_of(box.least.y + kTouch);
        const std::int64_t last_y = cell_of(box.most.y - kTouch);
        for (std::int64_t y = first_y; y <= last_y; ++y) {
            for (std::int64_t x = first_x; x <= last_x; ++x) {
                const Point2 least{static_cast<double>(x) * cell_m_,
                                   static_cast<double>(y) * cell_m_};
                if (!meets(quad, least, {least.x + cell_m_, least.y + cell_m_})) continue;
                cells_[static_cast<std::size_t>((y - bottom_) * columns_ + (x - left_))] = 1;
            }
        }
    }
}

}  // namespace hitos
