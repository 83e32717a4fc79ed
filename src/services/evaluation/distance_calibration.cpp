// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the distances between walls are as sure as the filter says.
#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "calibration.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/slam/slam_filter.hpp"
#include "nearest_landmark.hpp"

namespace hitos {
namespace {

constexpr double kParallel = 1e-3;  // true walls [rad]

/// How far a line lies from a point along a direction [m], and by how much more for a change of
/// its rho and theta.
struct Offset {
    double along_m = 0.0;
    Eigen::RowVector2d by;
};

/// Nothing of a line whose normal is further off the direction than a wall's may be.
std::optional<Offset> offset_of(const Recta& line, const Point2& from, double direction) {
    const double across = std::cos(line.theta - direction);
    if (std::abs(across) < std::cos(kGreatestTurn)) return std::nullopt;
    const double c = std::cos(line.theta);
    const double s = std::sin(line.theta);
    const double along = (line.rho - (from.x * c + from.y * s)) / across;
    const double turned = from.x * s - from.y * c + along * std::sin(line.theta - direction);
    return Offset{along, {1.0 / across, turned / across}};
}

const Recta& line_of(const LandmarkMap& map, std::size_t place) {
    return std::get<Recta>(map[place].value);
}

/// Two lines of a map, by their places, and the true walls that they are.
struct WallPair {
    std::size_t a = 0;
    std::size_t b = 0;
    double direction = 0.0;  ///< of the walls' normal [rad]
    Point2 midway;           ///< where the distance is measured
    double true_m = 0.0;     ///< with its sign, from a to b
};

bool parallel(const LandmarkMap& map, std::size_t a, std::size_t b) {
    const bool lines = map[a].kind() == FeatureKind::line && map[b].kind() == FeatureKind::line;
    return lines && std::abs(std::sin(line_of(map, a).theta - line_of(map, b).theta)) <= kParallel;
}

/// Of every line of the reference the wall beside it that is parallel to it, on the side to which
/// the normal of the first of all these points; nothing where there is none.
std::vector<std::optional<std::size_t>> next_walls(const LandmarkMap& reference) {
    std::vector<std::optional<std::size_t>> next(reference.size());
    for (std::size_t a = 0; a < reference.size(); ++a) {
        if (reference[a].kind() != FeatureKind::line) continue;
        std::size_t first = 0;
        while (!parallel(reference, first, a)) ++first;
        const double direction = line_of(reference, first).theta;
        const double here = offset_of(line_of(reference, a), {}, direction)->along_m;
        double least = 0.0;
        for (std::size_t b = 0; b < reference.size(); ++b) {
            if (!parallel(reference, a, b)) continue;
            const double away = offset_of(line_of(reference, b), {}, direction)->along_m - here;
            if (away < kLeastDistance || (next[a] && away >= least)) continue;
            next[a] = b;
            least = away;
        }
    }
    return next;
}

/// Where each line of the map was seen, midway; nothing where it was not.
std::vector<std::optional<Point2>> middles(std::size_t landmarks,
                                           std::span<const LineExtent> extents) {
    std::vector<std::optional<Point2>> places(landmarks);
    std::vector<std::uint64_t> points(landmarks, 0);
    for (const LineExtent& extent : extents) {
        const auto at = static_cast<std::size_t>(extent.landmark);
        if (places[at] && extent.points <= points[at]) continue;
        points[at] = extent.points;
        places[at] = Point2{(extent.a.x + extent.b.x) / 2.0, (extent.a.y + extent.b.y) / 2.0};
    }
    return places;
}

std::vector<WallPair> wall_pairs(const LandmarkMap& map, std::span<const LineExtent> extents,
                                 const LandmarkMap& reference) {
    const NearestLandmark nearest(reference);
    const std::vector<std::optional<std::size_t>> next = next_walls(reference);
    const std::vector<std::optional<Point2>> seen = middles(map.size(), extents);
    std::vector<std::optional<std::size_t>> truths(map.size());
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (map[i].kind() == FeatureKind::line && seen[i]) truths[i] = nearest.of(map[i], false);
    }
    std::vector<WallPair> pairs;
    for (std::size_t a = 0; a < map.size(); ++a) {
        if (!truths[a] || !next[*truths[a]]) continue;
        for (std::size_t b = 0; b < map.size(); ++b) {
            if (truths[b] != next[*truths[a]]) continue;
            const Recta& wall = line_of(reference, *truths[a]);
            const Point2 midway{(seen[a]->x + seen[b]->x) / 2.0, (seen[a]->y + seen[b]->y) / 2.0};
            const auto from = offset_of(wall, midway, wall.theta);
            const auto to = offset_of(line_of(reference, *truths[b]), midway, wall.theta);
            pairs.push_back({a, b, wall.theta, midway, to->along_m - from->along_m});
        }
    }
    return pairs;
}

/// Of a normal variable, about the true value.
struct Moments {
    double mean = 0.0;
    double square = 0.0;
    double weight = 0.0;

    void add(double error, double variance, double by) {
        mean += by * error;
        square += by * (variance + error * error);
        weight += by;
    }
    void count(Coverage& coverage) const {
        if (weight <= 0.0) return;
        const double error = mean / weight;
        const double variance = square / weight - error * error;
        if (variance > 0.0) coverage.add(error * error / variance);
    }
};

}  // namespace

void count_distances(Coverage& coverage, const SlamFilter& filter,
                     std::span<const LineExtent> extents, const LandmarkMap& reference) {
    const LandmarkMap best = filter.best_map();
    const std::vector<WallPair> pairs = wall_pairs(best, extents, reference);
    std::vector<Moments> moments(pairs.size());
    if (const Eigen::MatrixXd joint = filter.joint_covariance(); joint.size() > 0) {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const WallPair& pair = pairs[i];
            const auto from = offset_of(line_of(best, pair.a), pair.midway, pair.direction);
            const auto to = offset_of(line_of(best, pair.b), pair.midway, pair.direction);
            if (!from || !to) continue;
            const auto place = [](std::size_t landmark) {
                return 3 + 2 * static_cast<Eigen::Index>(landmark);
            };
            const auto block = [&](std::size_t row, std::size_t column) -> Eigen::Matrix2d {
                return joint.block<2, 2>(place(row), place(column));
            };
            const double variance = (from->by * block(pair.a, pair.a) * from->by.transpose() +
                                     to->by * block(pair.b, pair.b) * to->by.transpose() -
                                     2.0 * from->by * block(pair.a, pair.b) * to->by.transpose())
                                        .value();
            moments[i].add(to->along_m - from->along_m - pair.true_m, variance, 1.0);
        }
    } else if (filter.hypotheses().size() > 1) {
        for_each_hypothesis(filter, best, [&](const HypothesisMap& one) {
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                const WallPair& pair = pairs[i];
                if (!one.places[pair.a] || !one.places[pair.b]) continue;
                const ICaracteristica& a = one.map[*one.places[pair.a]];
                const ICaracteristica& b = one.map[*one.places[pair.b]];
                const auto from = offset_of(std::get<Recta>(a.value), pair.midway, pair.direction);
                const auto to = offset_of(std::get<Recta>(b.value), pair.midway, pair.direction);
                if (!from || !to) continue;
                const double variance = (from->by * a.covariance * from->by.transpose() +
                                         to->by * b.covariance * to->by.transpose())
                                            .value();
                moments[i].add(to->along_m - from->along_m - pair.true_m, variance, one.weight);
            }
        });
    }
    for (const Moments& one : moments) one.count(coverage);
}

}  // namespace hitos
