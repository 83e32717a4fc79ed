#include "hitos/services/line_extents.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

constexpr double kGreatestAngle = 0.15;    // rad
constexpr double kGreatestDistance = 0.4;  // m
constexpr double kGreatestGap = 1.0;       // m

double along(const Recta& line, const Point2& point) {
    return point.y * std::cos(line.theta) - point.x * std::sin(line.theta);
}

Point2 at(const Recta& line, double t) {
    const double c = std::cos(line.theta);
    const double s = std::sin(line.theta);
    return {line.rho * c - t * s, line.rho * s + t * c};
}

double angle_between(const Recta& a, const Recta& b) {
    const double turn = std::abs(wrap_angle(a.theta - b.theta));
    return std::min(turn, kPi - turn);
}

/// How far the ends of a stretch lie from a line; infinite where they are of different directions.
double distance(const Recta& line, const Recta& direction, const Point2& a, const Point2& b) {
    if (angle_between(line, direction) > kGreatestAngle) return HUGE_VAL;
    return std::max(std::abs(signed_distance(line, a)), std::abs(signed_distance(line, b)));
}

}  // namespace

void LineExtents::note(const SlamFilter& filter, const Observation& observation) {
    const Pose pose = filter.best_pose();
    for (const Association& association : filter.associations()) {
        if (association.kind != FeatureKind::recta) continue;
        if (association.outcome == Association::Outcome::ignored) continue;
        const DetectedLine& seen = observation.lines[association.observed];
        if (seen.count < 2) continue;
        add(transform(pose, seen.recta), transform(pose, observation.support[seen.first]),
            transform(pose, observation.support[seen.first + seen.count - 1]));
    }
}

void LineExtents::add(const Recta& line, const Point2& a, const Point2& b) {
    for (Stretch& stretch : stretches_) {
        if (distance(stretch.line, line, a, b) > kGreatestDistance) continue;
        const auto [from, to] = std::minmax({along(stretch.line, a), along(stretch.line, b)});
        if (from > stretch.to + kGreatestGap || to < stretch.from - kGreatestGap) continue;
        stretch.from = std::min(stretch.from, from);
        stretch.to = std::max(stretch.to, to);
        return;
    }
    const auto [from, to] = std::minmax({along(line, a), along(line, b)});
    stretches_.push_back({line, from, to});
}

std::vector<LineExtent> LineExtents::of(const LandmarkMap& map) const {
    struct Line {
        int landmark;
        Recta recta;
        double c;  // of theta
        double s;
        double away(const Point2& point) const {
            return std::abs(recta.rho - c * point.x - s * point.y);
        }
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const auto* recta = std::get_if<Recta>(&map[i].value);
        if (recta == nullptr) continue;
        lines.push_back(
            {static_cast<int>(i), *recta, std::cos(recta->theta), std::sin(recta->theta)});
    }
    std::vector<LineExtent> extents;
    for (const Stretch& stretch : stretches_) {
        LineExtent extent{-1, at(stretch.line, stretch.from), at(stretch.line, stretch.to)};
        double nearest = kGreatestDistance;
        for (const Line& line : lines) {
            const double away = std::max(line.away(extent.a), line.away(extent.b));
            if (away >= nearest || angle_between(line.recta, stretch.line) > kGreatestAngle) {
                continue;
            }
            nearest = away;
            extent.landmark = line.landmark;
        }
        if (extent.landmark >= 0) extents.push_back(extent);
    }
    return extents;
}

}  // namespace hitos
