// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/line_extents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace hitos {
namespace {

constexpr double kGreatestSine = 0.1494381324735992;  // of 0.15 rad
constexpr double kGreatestDistance = 0.4;             // m
constexpr double kSameEnd = 0.3;                      // m
constexpr std::uint64_t kFewestPoints = 10;

/// A line of the map, ready for many distances.
struct Line : PreparedRecta {
    int landmark = 0;
    double from = 0.0;  ///< of the part that was seen
    double to = 0.0;

    Line(int its_landmark, const Recta& recta, const ICaracteristica& known)
        : PreparedRecta(recta), landmark(its_landmark), from(known.from_m), to(known.to_m) {}
    double away(const Point2& point) const { return std::abs(signed_distance(point)); }
    /// How far beyond the part that was seen; 0 or less where they overlap.
    double beyond(const Point2& a, const Point2& b) const {
        const auto [low, high] = std::minmax({along(a), along(b)});
        return std::max(from - high, low - to);
    }
    /// `direction` is of length 1.
    bool has_direction(const Point2& direction) const {
        return std::abs(c * direction.x + s * direction.y) <= kGreatestSine;
    }
};

/// A part of a line, from its foot [m].
struct Interval {
    double from = 0.0;
    double to = 0.0;
    std::uint64_t points = 0;
};

std::vector<Line> lines_of(const LandmarkMap& map) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (const auto* recta = std::get_if<Recta>(&map[i].value)) {
            lines.emplace_back(static_cast<int>(i), *recta, map[i]);
        }
    }
    return lines;
}

/// The lines of a map by direction: a map has many, and a stretch lies along few of them.
class Directions {
  public:
    explicit Directions(std::span<const Line> lines) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!std::isfinite(lines[i].c)) continue;  // it has no direction
            const std::ptrdiff_t middle = bin_of({-lines[i].s, lines[i].c});
            for (std::ptrdiff_t bin = middle - kReach; bin <= middle + kReach; ++bin) {
                bins_[static_cast<std::size_t>((bin + kBins) % kBins)].push_back(i);
            }
        }
    }

    /// Every line that has the direction, and few others, in the order of the lines.
    std::span<const std::size_t> near(const Point2& direction) const {
        if (!std::isfinite(direction.x) || !std::isfinite(direction.y)) return {};
        return bins_[static_cast<std::size_t>(bin_of(direction))];
    }

  private:
    static constexpr std::ptrdiff_t kBins = 64;  // of half a turn
    /// kGreatestSine, in bins, and one for where in its bin a direction lies.
    static constexpr std::ptrdiff_t kReach = 5;

    static std::ptrdiff_t bin_of(const Point2& direction) {
        const double turns = std::atan2(direction.y, direction.x) / kPi + 1.0;  // half ones
        return static_cast<std::ptrdiff_t>(turns * static_cast<double>(kBins)) % kBins;
    }

    std::array<std::vector<std::size_t>, kBins> bins_;
};

/// Where parts end that see the same end. Poses scatter, so that the outermost of many ends lies
/// beyond it by the greatest of their errors; others stop short of it, where something hides the
/// rest. Two thirds of the way out both cancel best in the simulated worlds. `ends` grow outwards;
/// not empty.
double common_end(std::vector<double> ends) {
    const double outermost = *std::ranges::max_element(ends);
    std::erase_if(ends, [&](double end) { return end < outermost - kSameEnd; });
    const auto middle = ends.begin() + static_cast<std::ptrdiff_t>(ends.size() * 2 / 3);
    std::ranges::nth_element(ends, middle);
    return *middle;
}

/// The part that all of them make together, which are less than the opening apart.
Interval together(std::span<const Interval> parts) {
    std::vector<double> from;
    std::vector<double> to;
    Interval whole;
    for (const Interval& part : parts) {
        from.push_back(-part.from);
        to.push_back(part.to);
        whole.points += part.points;
    }
    whole.from = -common_end(std::move(from));
    whole.to = common_end(std::move(to));
    return whole;
}

/// Joins what overlaps or is less than the opening apart, then leaves out what has few points.
std::vector<Interval> joined(std::vector<Interval> parts) {
    std::vector<Interval> whole;
    if (parts.empty()) return whole;
    std::ranges::sort(parts, {},
                      [](const Interval& part) { return std::pair(part.from, part.to); });
    std::size_t first = 0;
    double reach = parts.front().to;
    for (std::size_t i = 1; i <= parts.size(); ++i) {
        if (i < parts.size() && parts[i].from <= reach + LineExtents::kOpening) {
            reach = std::max(reach, parts[i].to);
            continue;
        }
        whole.push_back(together({&parts[first], i - first}));
        if (i == parts.size()) break;
        first = i;
        reach = parts[i].to;
    }
    std::erase_if(whole, [](const Interval& part) { return part.points < kFewestPoints; });
    if (whole.empty()) whole.push_back(together(parts));
    return whole;
}

}  // namespace

void LineExtents::note(const SlamFilter& filter, const Observation& observation) {
    for (const Association& association : filter.associations()) {
        if (association.kind != FeatureKind::line) continue;
        if (association.outcome == Association::Outcome::ignored) continue;
        const DetectedLine& seen = observation.lines[association.observed];
        if (seen.count < 2) continue;
        const Point2* const points = &observation.support[seen.first];
        // Not from the first to the last point: where the scan's seam lies on a wall they are
        // neighbours.
        const Point2 along{-std::sin(seen.recta.theta), std::cos(seen.recta.theta)};
        std::uint32_t first = 0;
        for (std::uint32_t i = 1; i <= seen.count; ++i) {
            if (i < seen.count) {
                const double dx = points[i].x - points[i - 1].x;
                const double dy = points[i].y - points[i - 1].y;
                if (dx * dx + dy * dy <= kOpening * kOpening) continue;
            }
            stretches_.push_back({points[first], points[i - 1], along, scans_, i - first});
            first = i;
        }
    }
    ++scans_;
}

void LineExtents::clear() {
    stretches_.clear();
    scans_ = 0;
}

std::vector<LineExtent> LineExtents::of(const LandmarkMap& map, const Trajectory& path) const {
    const std::vector<Line> lines = lines_of(map);
    const Directions directions(lines);
    std::vector<std::vector<Interval>> parts(lines.size());
    for (const Stretch& stretch : stretches_) {
        if (stretch.scan >= path.size()) break;
        const Pose& pose = path[stretch.scan].pose;
        const double c = std::cos(pose.theta);
        const double s = std::sin(pose.theta);
        const auto turned = [&](const Point2& p) {
            return Point2{c * p.x - s * p.y, s * p.x + c * p.y};
        };
        const auto moved = [&](const Point2& p) {
            const Point2 q = turned(p);
            return Point2{pose.x + q.x, pose.y + q.y};
        };
        const Point2 a = moved(stretch.a);
        const Point2 b = moved(stretch.b);
        const Point2 along = turned(stretch.along);
        std::size_t nearest = lines.size();
        double least = kGreatestDistance;
        for (const std::size_t i : directions.near(along)) {
            if (!lines[i].has_direction(along)) continue;
            const double away =
                std::max({lines[i].away(a), lines[i].away(b), lines[i].beyond(a, b)});
            if (!(away < least)) continue;
            least = away;
            nearest = i;
        }
        if (nearest == lines.size()) continue;
        const auto [from, to] = std::minmax({lines[nearest].along(a), lines[nearest].along(b)});
        // A log may hold numbers that make no pose; NaN has no place in an order.
        if (!std::isfinite(from) || !std::isfinite(to)) continue;
        parts[nearest].push_back({from, to, stretch.points});
    }
    std::vector<LineExtent> extents;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const Interval& part : joined(std::move(parts[i]))) {
            extents.push_back(
                {lines[i].landmark, lines[i].at(part.from), lines[i].at(part.to), part.points});
        }
    }
    return extents;
}

}  // namespace hitos
