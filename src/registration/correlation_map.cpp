// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlation_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace hitos {
namespace {

constexpr int kReach = 2;  // of the blur [cells]
constexpr int kMost = CorrelationMap::kMost;
/// Value of a cell by its offset from a point's: a Gaussian of 1.2 cells, the point's own place in
/// its cell unknown.
constexpr std::array<std::array<std::uint8_t, kReach + 1>, kReach + 1> kBlur{
    {{kMost, 230, 130}, {230, 200, 110}, {130, 110, 60}}};

}  // namespace

CorrelationMap::CorrelationMap(const PointMap& map, double half_m, int levels) {
    blur(map, half_m);
    for (int level = 1; level <= levels; ++level) {
        pictures_.push_back(coarser(pictures_.back(), std::size_t{1} << (level - 1)));
    }
}

CorrelationMap::Cell CorrelationMap::cell(double x, double y) const {
    const auto number = [](double offset) {
        return static_cast<int>(std::floor(std::clamp(offset / kCell, -1e6, 1e6)));
    };
    return {number(x - x0_), number(y - y0_)};
}

void CorrelationMap::blur(const PointMap& map, double half_m) {
    Bounds bounds;  // no greater than the points: most places are long and thin
    const auto inside = [half_m](const MapPoint& p) {
        return std::abs(static_cast<double>(p.x)) <= half_m &&
               std::abs(static_cast<double>(p.y)) <= half_m;
    };
    for (std::size_t i = 0; i < map.size(); ++i) {
        const MapPoint& p = map.point(i);
        if (inside(p)) bounds.hold({static_cast<double>(p.x), static_cast<double>(p.y)});
    }
    // Cells count from the centre, whatever the bounds.
    const double first_column = std::floor(bounds.low.x / kCell) - kReach;
    const double first_row = std::floor(bounds.low.y / kCell) - kReach;
    columns_ = static_cast<int>(std::floor(bounds.high.x / kCell) - first_column) + kReach + 1;
    rows_ = static_cast<int>(std::floor(bounds.high.y / kCell) - first_row) + kReach + 1;
    x0_ = map.centre().x + first_column * kCell;
    y0_ = map.centre().y + first_row * kCell;
    Picture finest(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t i = 0; i < map.size(); ++i) {
        const MapPoint& p = map.point(i);
        if (!inside(p)) continue;
        const auto a =
            static_cast<int>(std::floor(static_cast<double>(p.x) / kCell) - first_column);
        const auto b = static_cast<int>(std::floor(static_cast<double>(p.y) / kCell) - first_row);
        for (int v = -kReach; v <= kReach; ++v) {
            const auto line = static_cast<std::size_t>(b + v) * static_cast<std::size_t>(columns_);
            for (int u = -kReach; u <= kReach; ++u) {
                std::uint8_t& value = finest[line + static_cast<std::size_t>(a + u)];
                value = std::max(value, kBlur[static_cast<std::size_t>(std::abs(u))]
                                             [static_cast<std::size_t>(std::abs(v))]);
            }
        }
    }
    pictures_.push_back(std::move(finest));
}

/// Running maxima over squares of twice the size; whole rows at a time, which the compiler makes
/// vectors of.
CorrelationMap::Picture CorrelationMap::coarser(const Picture& fine, std::size_t half) const {
    const auto columns = static_cast<std::size_t>(columns_);
    const auto rows = static_cast<std::size_t>(rows_);
    Picture coarse = fine;
    for (std::size_t y = 0; y < rows; ++y) {
        const std::uint8_t* const from = fine.data() + y * columns;
        std::uint8_t* const to = coarse.data() + y * columns;
        for (std::size_t x = 0; x + half < columns; ++x) to[x] = std::max(from[x], from[x + half]);
    }
    // From the first row on: the rows ahead are still those of the first pass.
    for (std::size_t y = 0; y + half < rows; ++y) {
        std::uint8_t* const to = coarse.data() + y * columns;
        const std::uint8_t* const ahead = to + half * columns;
        for (std::size_t x = 0; x < columns; ++x) to[x] = std::max(to[x], ahead[x]);
    }
    return coarse;
}

CorrelationMap::Pattern::Pattern(std::vector<Cell> all)
    : cells(std::move(all)), low(cells.front()), high(cells.front()) {
    for (const Cell& cell : cells) {
        low = {std::min(low.column, cell.column), std::min(low.row, cell.row)};
        high = {std::max(high.column, cell.column), std::max(high.row, cell.row)};
    }
}

template <std::size_t kPlaces>
std::array<int, kPlaces> CorrelationMap::sums(const Pattern& pattern,
                                              const std::array<Cell, kPlaces>& places, int level,
                                              int least) const {
    constexpr std::size_t kAtOnce = 32;  // cells between two looks at what can still be reached
    const std::uint8_t* const picture = pictures_[static_cast<std::size_t>(level)].data();
    const std::span<const Cell> cells = pattern.cells;
    const int reach = 1 << level;
    const bool inside = std::ranges::all_of(places, [&](const Cell& place) {
        return pattern.low.column + place.column >= 0 && pattern.low.row + place.row >= 0 &&
               pattern.high.column + place.column < columns_ &&
               pattern.high.row + place.row < rows_;
    });
    std::array<int, kPlaces> sums{};
    std::array<std::ptrdiff_t, kPlaces> offsets{};
    for (std::size_t i = 0; i < kPlaces; ++i)
        offsets[i] = std::ptrdiff_t{places[i].row} * columns_ + places[i].column;
    for (std::size_t begin = 0; begin < cells.size(); begin += kAtOnce) {
        const std::span<const Cell> left = cells.subspan(begin);
        if (std::ranges::max(sums) + kMost * static_cast<int>(left.size()) < least) break;
        const std::span<const Cell> now = left.first(std::min(kAtOnce, left.size()));
        if (inside) {
            for (const Cell& cell : now) {
                const std::uint8_t* const at =
                    picture + std::ptrdiff_t{cell.row} * columns_ + cell.column;
                for (std::size_t i = 0; i < kPlaces; ++i) sums[i] += at[offsets[i]];
            }
            continue;
        }
        for (std::size_t i = 0; i < kPlaces; ++i) {
            for (const Cell& cell : now) {
                int a = cell.column + places[i].column;
                int b = cell.row + places[i].row;
                // A square that begins outside may reach into the map.
                if (a < 0 && a > -reach) a = 0;
                if (b < 0 && b > -reach) b = 0;
                if (a < 0 || b < 0 || a >= columns_ || b >= rows_) continue;
                sums[i] += picture[std::ptrdiff_t{b} * columns_ + a];
            }
        }
    }
    return sums;
}

int CorrelationMap::sum(const Pattern& pattern, int x, int y, int level, int least) const {
    return sums<1>(pattern, {{{x, y}}}, level, least)[0];
}

std::array<int, 4> CorrelationMap::quarters(const Pattern& pattern, int x, int y, int level,
                                            int least) const {
    const int side = 1 << level;
    return sums<4>(pattern, {{{x, y}, {x, y + side}, {x + side, y}, {x + side, y + side}}}, level,
                   least);
}

}  // namespace hitos
