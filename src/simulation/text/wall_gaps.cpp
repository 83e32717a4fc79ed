// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "hitos/simulation/text/snapping.hpp"

namespace hitos {
namespace {

constexpr double kAlong = 0.01;  // m; so near is along
constexpr double kSame = 1e-6;   // m; so near is one point

bool near(const Point2& a, const Point2& b) {
    return distance(a, b) <= kSame;
}

/// Distances along the wall p q at which the stretch a b covers it.
std::optional<std::pair<double, double>> covered(const Point2& p, const Point2& q, const Point2& a,
                                                 const Point2& b) {
    const double length = distance(p, q);
    const Point2 along{(q.x - p.x) / length, (q.y - p.y) / length};
    const auto way = [&](const Point2& c) { return (c.x - p.x) * along.x + (c.y - p.y) * along.y; };
    const auto off = [&](const Point2& c) {
        return std::abs((c.y - p.y) * along.x - (c.x - p.x) * along.y);
    };
    if (off(a) > kAlong || off(b) > kAlong) return std::nullopt;
    const auto [low, high] = std::minmax({way(a), way(b)});
    const double from = std::max(low, 0.0);
    const double to = std::min(high, length);
    if (to - from <= kSame) return std::nullopt;
    return std::pair(from <= kSame ? 0.0 : from, to >= length - kSame ? length : to);
}

/// The stretch's own end where that is meant, so that wall and door meet to the last bit.
Point2 at(const Point2& p, const Point2& q, double way, const Point2& a, const Point2& b) {
    const double length = distance(p, q);
    const Point2 point{p.x + (q.x - p.x) * way / length, p.y + (q.y - p.y) * way / length};
    if (distance(point, a) <= kAlong) return a;
    return distance(point, b) <= kAlong ? b : point;
}

std::vector<Polyline> cut(const Polyline& wall, const Point2& a, const Point2& b) {
    std::vector<Polyline> pieces = {{wall.front()}};
    bool whole = true;
    for (std::size_t i = 1; i < wall.size(); ++i) {
        const auto gap = covered(wall[i - 1], wall[i], a, b);
        if (gap) {
            whole = false;
            if (gap->first > 0.0) {
                pieces.back().push_back(at(wall[i - 1], wall[i], gap->first, a, b));
            }
            pieces.emplace_back();
            const bool to_the_end = gap->second >= distance(wall[i - 1], wall[i]);
            if (!to_the_end) pieces.back().push_back(at(wall[i - 1], wall[i], gap->second, a, b));
        }
        pieces.back().push_back(wall[i]);
    }
    if (whole) return {wall};
    if (wall.front() == wall.back() && pieces.size() > 1) {  // it goes on over its end
        Polyline& last = pieces.back();
        last.insert(last.end(), pieces.front().begin() + 1, pieces.front().end());
        pieces.front() = std::move(last);
        pieces.pop_back();
    }
    std::erase_if(pieces, [](const Polyline& piece) { return piece.size() < 2; });
    return pieces;
}

/// Whether b lies between a and c, in their line.
bool straight(const Point2& a, const Point2& b, const Point2& c) {
    const double length = distance(a, c);
    if (length <= kSame) return false;
    const Point2 along{(c.x - a.x) / length, (c.y - a.y) / length};
    const double way = (b.x - a.x) * along.x + (b.y - a.y) * along.y;
    const double off = (b.y - a.y) * along.x - (b.x - a.x) * along.y;
    return std::abs(off) <= kAlong && way > 0.0 && way < length;
}

/// Leads away from the wall's last point.
bool goes_on(const Polyline& wall, const Point2& to) {
    return straight(wall[wall.size() - 2], wall.back(), to);
}

/// The wall turned so that it ends at the point; nothing where it does not.
std::optional<Polyline> ending_at(const Polyline& wall, const Point2& point) {
    if (near(wall.back(), point)) return wall;
    if (!near(wall.front(), point)) return std::nullopt;
    return Polyline(wall.rbegin(), wall.rend());
}

}  // namespace

std::vector<Polyline> without_stretch(const std::vector<Polyline>& walls, const Point2& a,
                                      const Point2& b) {
    std::vector<Polyline> rest;
    for (const Polyline& wall : walls) {
        std::vector<Polyline> pieces = cut(wall, a, b);
        std::ranges::move(pieces, std::back_inserter(rest));
    }
    return rest;
}

std::vector<Polyline> with_stretch(const std::vector<Polyline>& walls, const Point2& a,
                                   const Point2& b) {
    for (std::size_t i = 0; i < walls.size(); ++i) {
        auto to_a = ending_at(walls[i], a);
        if (!to_a) continue;
        const bool from_a = goes_on(*to_a, b);
        if (near(to_a->front(), b)) {  // round a room
            const Polyline back(to_a->rbegin(), to_a->rend());
            const bool from_b = goes_on(back, a);
            if (!from_a && !from_b) continue;
            // Where the wall goes straight on it has no point.
            if (from_a) to_a->pop_back();
            if (from_b) to_a->erase(to_a->begin());
            to_a->push_back(to_a->front());
            std::vector<Polyline> all = walls;
            all[i] = std::move(*to_a);
            return all;
        }
        for (std::size_t j = 0; j < walls.size(); ++j) {
            const auto to_b = j == i ? std::nullopt : ending_at(walls[j], b);
            if (!to_b) continue;
            const bool from_b = goes_on(*to_b, a);
            if (!from_a && !from_b) continue;
            if (from_a) to_a->pop_back();
            to_a->insert(to_a->end(), to_b->rbegin() + (from_b ? 1 : 0), to_b->rend());
            std::vector<Polyline> all = walls;
            all[i] = std::move(*to_a);
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(j));
            return all;
        }
    }
    return walls;
}

}  // namespace hitos
