// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>

namespace hitos {
namespace {

constexpr double kLeastSine = 0.2;  // of two directions that cross well enough, 12 degrees

struct Crossing {
    Point2 at;
    double on_other = 0.0;  ///< along the other wall from its a, in the unit of its points
};

std::optional<Crossing> crossing(const Straight& one, const Straight& other) {
    const Point2 d{one.b.x - one.a.x, one.b.y - one.a.y};
    const Point2 e{other.b.x - other.a.x, other.b.y - other.a.y};
    const double lengths = std::hypot(d.x, d.y) * std::hypot(e.x, e.y);
    const double determinant = d.x * e.y - d.y * e.x;
    if (!(std::abs(determinant) > kLeastSine * lengths)) return std::nullopt;
    const Point2 gap{other.a.x - one.a.x, other.a.y - one.a.y};
    const double s = (gap.x * e.y - gap.y * e.x) / determinant;
    const double t = (gap.x * d.y - gap.y * d.x) / determinant;
    return Crossing{{one.a.x + s * d.x, one.a.y + s * d.y}, t * std::hypot(e.x, e.y)};
}

struct Meeting {
    double distance = 0.0;
    std::size_t one = 0;    ///< end number: twice that of the wall, one more for its b
    std::size_t other = 0;  ///< likewise
    Point2 at;
};

}  // namespace

void join_corners(std::vector<Straight>& walls, double reach) {
    const std::vector<Straight> before = walls;
    const auto end_of = [](std::vector<Straight>& of, std::size_t end) -> Point2& {
        return end % 2 == 0 ? of[end / 2].a : of[end / 2].b;
    };
    const auto was = [&](std::size_t end) {
        return end % 2 == 0 ? before[end / 2].a : before[end / 2].b;
    };
    // A short wall would be turned by more than it is known to.
    const auto limit = [&](std::size_t end) {
        return std::min(reach, distance(before[end / 2].a, before[end / 2].b) / 3.0);
    };
    // Ends by their first coordinate, so that only near ones are compared.
    std::vector<std::size_t> ends(2 * walls.size());
    for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = i;
    std::ranges::stable_sort(ends, {}, [&](std::size_t end) { return was(end).x; });
    std::vector<Meeting> meetings;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t k = i + 1; k < ends.size(); ++k) {
            const Point2 a = was(ends[i]);
            const Point2 b = was(ends[k]);
            if (b.x - a.x > 2.0 * reach) break;
            if (ends[i] / 2 == ends[k] / 2) continue;
            const auto cross = crossing(before[ends[i] / 2], before[ends[k] / 2]);
            const Point2 at = cross ? cross->at : Point2{(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
            if (distance(a, at) > limit(ends[i]) || distance(b, at) > limit(ends[k])) continue;
            if (!cross && distance(a, b) > reach) continue;
            meetings.push_back({distance(a, at) + distance(b, at), std::min(ends[i], ends[k]),
                                std::max(ends[i], ends[k]), at});
        }
    }
    std::ranges::sort(meetings, {}, [](const Meeting& meeting) {
        return std::tuple(meeting.distance, meeting.one, meeting.other);
    });
    std::vector<bool> joined(ends.size(), false);
    for (const Meeting& meeting : meetings) {
        if (joined[meeting.one] || joined[meeting.other]) continue;
        joined[meeting.one] = joined[meeting.other] = true;
        end_of(walls, meeting.one) = end_of(walls, meeting.other) = meeting.at;
    }
    for (std::size_t end = 0; end < ends.size(); ++end) {
        if (joined[end]) continue;
        double nearest = limit(end);
        const Point2 from = was(end);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            if (i == end / 2) continue;
            const auto cross = crossing(before[end / 2], before[i]);
            if (!cross || cross->on_other < -reach ||
                cross->on_other > distance(before[i].a, before[i].b) + reach)
                continue;
            const double away = distance(from, cross->at);
            if (away > nearest) continue;
            nearest = away;
            end_of(walls, end) = cross->at;
        }
    }
}

}  // namespace hitos
