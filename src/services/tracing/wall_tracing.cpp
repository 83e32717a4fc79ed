// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/tracing/wall_tracing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "hitos/base/error.hpp"
#include "thinning.hpp"
#include "wall_corners.hpp"

namespace hitos {
namespace {

/// In cells, columns to the right, rows downwards.
struct Limits {
    double tolerance = 0.0;
    double shortest = 0.0;
    double opening = 0.0;
    int thickest = 0;
};

Limits limits_of(const OccupancyPicture& picture, const TracingOptions& options) {
    const auto check = [](const char* name, double value) {
        if (!(value >= 0.0) || !std::isfinite(value)) {
            throw ConfigError(name, HITOS_TEXT("Errors", "found %1, expected %2"), value,
                              message(HITOS_TEXT("Errors", "0 m or more")));
        }
    };
    check("tolerance", options.tolerance_m);
    check("shortest", options.shortest_m);
    check("thickest", options.thickest_m);
    const auto cells = [&](double metres, double otherwise) {
        return metres > 0.0 ? metres / picture.resolution_m : otherwise;
    };
    Limits limits;
    limits.tolerance = std::max(1.0, cells(options.tolerance_m, 2.0));
    limits.shortest = cells(options.shortest_m, 6.0);
    limits.opening = std::max(4.0, 2.0 * limits.tolerance);
    const auto greatest = static_cast<double>(std::max(picture.columns, picture.rows));
    limits.thickest = static_cast<int>(
        std::clamp(std::ceil(options.thickest_m / picture.resolution_m), 5.0, greatest + 5.0));
    return limits;
}

/// What is too thick for a wall is replaced by its outline.
CellMask walls_of(const OccupancyPicture& picture, const Limits& limits) {
    const int margin = 2;  // for what grows
    CellMask mask(picture.columns + 2 * margin, picture.rows + 2 * margin);
    for (int row = 0; row < picture.rows; ++row) {
        for (int column = 0; column < picture.columns; ++column)
            mask.set(column + margin, row + margin, picture.at(column, row));
    }
    mask = shrunk(grown(mask, 1), 1);  // both sides of a wall, with a cell or two between
    const int half = limits.thickest / 2;
    const CellMask blocks = grown(shrunk(mask, half), half);
    const CellMask inside = shrunk(blocks, 1);
    CellMask result(picture.columns, picture.rows);
    for (int row = 0; row < picture.rows; ++row) {
        for (int column = 0; column < picture.columns; ++column) {
            const int x = column + margin;
            const int y = row + margin;
            result.set(column, row, mask.at(x, y) && !inside.at(x, y));
        }
    }
    return result;
}

double off_line(const SkeletonCell& cell, const SkeletonCell& a, const SkeletonCell& b) {
    const double dx = b.column - a.column;
    const double dy = b.row - a.row;
    const double length = std::hypot(dx, dy);
    const double x = cell.column - a.column;
    const double y = cell.row - a.row;
    return length == 0.0 ? std::hypot(x, y) : std::abs(x * dy - y * dx) / length;
}

struct Seed {
    SkeletonCell a;
    SkeletonCell b;
    double length() const { return std::hypot(b.column - a.column, b.row - a.row); }
};

/// The straight pieces of a chain: split where it is furthest off (Douglas and Peucker 1973).
void split_chain(std::span<const SkeletonCell> chain, double tolerance, std::vector<Seed>& seeds) {
    std::vector<std::span<const SkeletonCell>> todo{chain};
    while (!todo.empty()) {
        const std::span<const SkeletonCell> part = todo.back();
        todo.pop_back();
        std::size_t worst = 0;
        double most = tolerance;
        for (std::size_t i = 1; i + 1 < part.size(); ++i) {
            const double off = off_line(part[i], part.front(), part.back());
            if (off > most) most = off, worst = i;
        }
        if (worst == 0) {
            seeds.push_back({part.front(), part.back()});
        } else {
            todo.push_back(part.subspan(worst));
            todo.push_back(part.first(worst + 1));
        }
    }
}

class Tracer {
  public:
    Tracer(const CellMask& thin, const CellMask& thick, const Limits& limits)
        : thin_(thin), thick_(thick), limits_(limits), used_(thin.columns(), thin.rows()) {}

    std::optional<Straight> grow(const Seed& seed) {
        const std::vector<SkeletonCell> own =
            cells_along({{double(seed.a.column), double(seed.a.row)},
                         {double(seed.b.column), double(seed.b.row)}},
                        false);
        if (static_cast<double>(own.size()) < 0.6 * seed.length()) return std::nullopt;
        Straight wall{{double(seed.a.column), double(seed.a.row)},
                      {double(seed.b.column), double(seed.b.row)}};
        std::vector<SkeletonCell> cells;
        constexpr int kRounds = 4;
        for (int round = 0; round < kRounds; ++round) {
            cells = cells_along(wall, true);
            if (cells.size() < 2) return std::nullopt;
            wall = fitted(cells, wall);
        }
        wall = centred(wall);
        if (std::hypot(wall.b.x - wall.a.x, wall.b.y - wall.a.y) + 1.0 < limits_.shortest)
            return std::nullopt;
        return wall;
    }

    /// Cells on and beside the wall belong to no further one.
    void use(const Straight& wall) {
        visit(thin_, wall, limits_.tolerance + 1.0, false,
              [&](const SkeletonCell& cell) { used_.set(cell.column, cell.row, true); });
    }

  private:
    /// Thinning takes a wall of an even number of cells half a cell to one side; all of its cells
    /// have their middle where the wall is. Its ends are where they end.
    Straight centred(const Straight& wall) const {
        Straight middle = wall;
        constexpr int kRounds = 3;  // what is cut off on one side comes in
        for (int round = 0; round < kRounds; ++round) {
            std::vector<SkeletonCell> cells;
            visit(thick_, middle, limits_.tolerance + 0.5, false,
                  [&](const SkeletonCell& cell) { cells.push_back(cell); });
            if (cells.size() < 2) return wall;
            const Straight fit = fitted(cells, middle);
            const double length = std::hypot(fit.b.x - fit.a.x, fit.b.y - fit.a.y);
            const double ux = (fit.b.x - fit.a.x) / length;
            const double uy = (fit.b.y - fit.a.y) / length;
            const auto foot = [&](const Point2& p) {
                const double t = (p.x - fit.a.x) * ux + (p.y - fit.a.y) * uy;
                return Point2{fit.a.x + t * ux, fit.a.y + t * uy};
            };
            middle = {foot(wall.a), foot(wall.b)};
        }
        return {lengthened(middle.a, middle.b), lengthened(middle.b, middle.a)};
    }

    /// The end `a` moved away from `b` as far as there are cells of a wall.
    Point2 lengthened(const Point2& a, const Point2& b) const {
        constexpr int kSteps = 4;  // a cell
        const double length = std::hypot(a.x - b.x, a.y - b.y);
        const Point2 step{(a.x - b.x) / length / kSteps, (a.y - b.y) / length / kSteps};
        Point2 end = a;
        for (int gone = 0; gone < kSteps * limits_.thickest; ++gone) {
            const Point2 next{end.x + step.x, end.y + step.y};
            if (!thick_.at(static_cast<int>(std::lround(next.x)),
                           static_cast<int>(std::lround(next.y))))
                break;
            end = next;
        }
        return end;
    }

    std::vector<SkeletonCell> cells_along(const Straight& wall, bool beyond) {
        std::vector<SkeletonCell> cells;
        visit(thin_, wall, limits_.tolerance, beyond,
              [&](const SkeletonCell& cell) { cells.push_back(cell); });
        return cells;
    }

    /// Free cells within `off` of the wall, each once; beyond its ends too, as far as no opening is
    /// wider than the limit. Goes along the axis on which the wall is longer.
    template <class Visit>
    void visit(const CellMask& of, const Straight& wall, double off, bool beyond,
               const Visit& visitor) const {
        const double dx = wall.b.x - wall.a.x;
        const double dy = wall.b.y - wall.a.y;
        const bool wide = std::abs(dx) >= std::abs(dy);
        const double length = std::hypot(dx, dy);
        if (length == 0.0) return;
        const double slope = wide ? dy / dx : dx / dy;
        const double along = (wide ? std::abs(dx) : std::abs(dy)) / length;
        const double reach = off / along;
        const double a = wide ? wall.a.x : wall.a.y;
        const double b = wide ? wall.b.x : wall.b.y;
        const double base = wide ? wall.a.y : wall.a.x;
        const int end = wide ? thin_.columns() : thin_.rows();
        const auto line_up = [&](int at) {
            bool any = false;
            const double middle = base + slope * (at - a);
            for (int k = static_cast<int>(std::ceil(middle - reach));
                 k <= static_cast<int>(std::floor(middle + reach)); ++k) {
                const SkeletonCell cell = wide ? SkeletonCell{at, k} : SkeletonCell{k, at};
                if (!of.at(cell.column, cell.row) || used_.at(cell.column, cell.row)) continue;
                visitor(cell);
                any = true;
            }
            return any;
        };
        const int low = static_cast<int>(std::lround(std::min(a, b)));
        const int high = static_cast<int>(std::lround(std::max(a, b)));
        for (int at = std::max(low, 0); at <= std::min(high, end - 1); ++at) line_up(at);
        if (!beyond) return;
        const int opening = static_cast<int>(limits_.opening * along);
        for (int at = high + 1, last = high; at < end && at - last <= opening + 1; ++at) {
            if (line_up(at)) last = at;
        }
        for (int at = low - 1, last = low; at >= 0 && last - at <= opening + 1; --at) {
            if (line_up(at)) last = at;
        }
    }

    /// The line with the least squares of distances, from the first cell along it to the last. Of
    /// a long wall the cells near its ends, which can be those of another wall, have no part in
    /// the direction.
    Straight fitted(const std::vector<SkeletonCell>& cells, const Straight& before) const {
        const double length = std::hypot(before.b.x - before.a.x, before.b.y - before.a.y);
        const double ux = (before.b.x - before.a.x) / length;
        const double uy = (before.b.y - before.a.y) / length;
        const auto along = [&](const SkeletonCell& cell) {
            return (cell.column - before.a.x) * ux + (cell.row - before.a.y) * uy;
        };
        double from = along(cells.front());
        double to = from;
        for (const SkeletonCell& cell : cells) {
            from = std::min(from, along(cell));
            to = std::max(to, along(cell));
        }
        const double trim = to - from > 8.0 * limits_.tolerance ? limits_.tolerance + 1.0 : 0.0;
        double n = 0.0;
        double x = 0.0;
        double y = 0.0;
        const auto counts = [&](const SkeletonCell& cell) {
            return along(cell) >= from + trim && along(cell) <= to - trim;
        };
        for (const SkeletonCell& cell : cells) {
            if (!counts(cell)) continue;
            n += 1.0;
            x += cell.column;
            y += cell.row;
        }
        if (n < 2.0) return before;
        x /= n;
        y /= n;
        double xx = 0.0;
        double xy = 0.0;
        double yy = 0.0;
        for (const SkeletonCell& cell : cells) {
            if (!counts(cell)) continue;
            xx += (cell.column - x) * (cell.column - x);
            xy += (cell.column - x) * (cell.row - y);
            yy += (cell.row - y) * (cell.row - y);
        }
        const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
        double vx = std::cos(angle);
        double vy = std::sin(angle);
        if (vx * ux + vy * uy < 0.0) vx = -vx, vy = -vy;
        const auto at = [&](double column, double row) {
            return (column - x) * vx + (row - y) * vy;
        };
        double first = at(cells.front().column, cells.front().row);
        double last = first;
        for (const SkeletonCell& cell : cells) {
            first = std::min(first, at(cell.column, cell.row));
            last = std::max(last, at(cell.column, cell.row));
        }
        if (last - first < 1.0) return before;
        return {{x + first * vx, y + first * vy}, {x + last * vx, y + last * vy}};
    }

    const CellMask& thin_;
    const CellMask& thick_;
    Limits limits_;
    CellMask used_;
};

}  // namespace

Walls trace_walls(const OccupancyPicture& picture, const TracingOptions& options) {
    const Limits limits = limits_of(picture, options);
    const CellMask thick = walls_of(picture, limits);
    CellMask thin = thinned(thick);
    constexpr int kSpur = 5;  // cells; what thinning leaves at the bumps of a wall
    std::vector<Seed> seeds;
    for (const CellChain& chain : chains_of(thin, kSpur)) {
        const std::span<const SkeletonCell> cells(chain);
        // A loop has no ends to draw a line between; its halves have.
        const bool loop = cells.size() > 3 && cells.front().column == cells.back().column &&
                          cells.front().row == cells.back().row;
        const std::size_t half = cells.size() / 2;
        if (loop) split_chain(cells.first(half + 1), limits.tolerance, seeds);
        split_chain(loop ? cells.subspan(half) : cells, limits.tolerance, seeds);
    }
    std::ranges::stable_sort(seeds, std::ranges::greater{}, &Seed::length);
    Tracer tracer(thin, thick, limits);
    std::vector<Straight> walls;
    for (const Seed& seed : seeds) {
        if (seed.length() + 1.0 < std::min(limits.shortest, 4.0)) break;
        const std::optional<Straight> wall = tracer.grow(seed);
        if (!wall) continue;
        tracer.use(*wall);
        walls.push_back(*wall);
    }
    join_corners(walls, limits.tolerance + 3.0);
    Walls result;
    for (const Straight& wall : walls) {
        if (std::hypot(wall.b.x - wall.a.x, wall.b.y - wall.a.y) + 1.0 < limits.shortest) continue;
        result.emplace_back(picture.world(wall.a.x, wall.a.y), picture.world(wall.b.x, wall.b.y));
    }
    return result;
}

}  // namespace hitos
