// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_matcher.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/pose_graph.hpp"
#include "hitos/registration/pose_graph_solver.hpp"

namespace hitos {
namespace {

constexpr double kLoosePointWeight = 0.1;  // of a point without surface
constexpr double kLoosePointHalf2 = 0.01;  // [m^2]
constexpr int kManyPoints = 240;           // above, every second one guides the fit

/// Sums of one linearisation, entry by entry: the compiler keeps them in registers.
struct Sums {
    double h00 = 0.0, h01 = 0.0, h02 = 0.0, h11 = 0.0, h12 = 0.0, h22 = 0.0;
    double b0 = 0.0, b1 = 0.0, b2 = 0.0;

    void add(double jx, double jy, double jt, double error, double weight) {
        const double wx = weight * jx;
        const double wy = weight * jy;
        const double wt = weight * jt;
        h00 += wx * jx;
        h01 += wx * jy;
        h02 += wx * jt;
        h11 += wy * jy;
        h12 += wy * jt;
        h22 += wt * jt;
        b0 += wx * error;
        b1 += wy * error;
        b2 += wt * error;
    }
    void add_to(Linearization& l, double factor) const {
        Eigen::Matrix3d h;
        h << h00, h01, h02, h01, h11, h12, h02, h12, h22;
        l.h += factor * h;
        l.b += factor * Eigen::Vector3d(b0, b1, b2);
    }
};

/// A point of the scan: where it is from the robot on, in the world's axes, and from the map's
/// centre on; with the point of the map that is nearest.
struct Match {
    double dx, dy;
    double x, y;
    const SurfacePoint& seen;
    const MapPoint& map;
};

/// Adds what a match says; false where it says nothing.
bool add_match(const Match& m, double c, double s, const MatchStage& stage, Sums& sums) {
    const double ex = m.x - static_cast<double>(m.map.x);
    const double ey = m.y - static_cast<double>(m.map.y);
    if (m.map.has_normal()) {
        const auto nx = static_cast<double>(m.map.nx);
        const auto ny = static_cast<double>(m.map.ny);
        if (stage.same_side && m.seen.has_normal()) {
            const auto sx = static_cast<double>(m.seen.nx);
            const auto sy = static_cast<double>(m.seen.ny);
            if ((c * sx - s * sy) * nx + (s * sx + c * sy) * ny < 0.5) return false;
        }
        const double error = ex * nx + ey * ny;
        const double half2 = stage.half_weight_m * stage.half_weight_m;
        sums.add(nx, ny, ny * m.dx - nx * m.dy, error, 1.0 / (1.0 + error * error / half2));
        return true;
    }
    if (m.seen.has_normal()) return false;
    const double weight = kLoosePointWeight / (1.0 + (ex * ex + ey * ey) / kLoosePointHalf2);
    sums.add(1.0, 0.0, -m.dy, ex, weight);
    sums.add(0.0, 1.0, m.dx, ey, weight);
    return true;
}

MatchStage stage_of(int iteration) {
    if (iteration < ScanMatcher::kWideSteps) return {0.7, 0.15, false};
    if (iteration < 8) return {0.4, 0.08, true};
    return kFineStage;
}

}  // namespace

double match_score(std::span<const SurfacePoint> scan, const PointMap& map, const Pose& pose,
                   int stride) {
    constexpr double kTwoVariances = 2.0 * 0.08 * 0.08;  // [m^2]
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    const double x0 = pose.x - map.centre().x;
    const double y0 = pose.y - map.centre().y;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < scan.size(); i += static_cast<std::size_t>(stride)) {
        const auto px = static_cast<double>(scan[i].x);
        const auto py = static_cast<double>(scan[i].y);
        double d2 = 0.0;
        if (map.nearest(x0 + c * px - s * py, y0 + s * px + c * py, 0.3, &d2) != nullptr) {
            sum += std::exp(-d2 / kTwoVariances);
        }
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

Linearization ScanMatcher::linearize(std::span<const SurfacePoint> scan, const PointMap& map,
                                     const Pose& pose, const MatchStage& stage, int stride,
                                     std::vector<Linearization>* by_source) const {
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    const double x0 = pose.x - map.centre().x;
    const double y0 = pose.y - map.centre().y;
    Linearization sum;
    Sums sums;
    for (std::size_t i = 0; i < scan.size(); i += static_cast<std::size_t>(stride)) {
        const auto px = static_cast<double>(scan[i].x);
        const auto py = static_cast<double>(scan[i].y);
        const double dx = c * px - s * py;
        const double dy = s * px + c * py;
        const double x = x0 + dx;
        const double y = y0 + dy;
        const MapPoint* const nearest = map.nearest(x, y, stage.radius_m);
        if (nearest == nullptr) continue;
        const Match match{dx, dy, x, y, scan[i], *nearest};
        if (by_source == nullptr) {
            if (add_match(match, c, s, stage, sums)) ++sum.matches;
            continue;
        }
        Sums one;
        if (!add_match(match, c, s, stage, one)) continue;
        ++sum.matches;
        one.add_to(sum, stride);
        Linearization& source = (*by_source)[nearest->source];
        one.add_to(source, 1.0);
        ++source.matches;
    }
    sums.add_to(sum, stride);
    sum.matches *= stride;
    return sum;
}

Pose ScanMatcher::fit(std::span<const SurfacePoint> scan, const PointMap& map, const Pose& start,
                      const PosePrior& prior, int iterations, int first) const {
    constexpr double kSettled = 5e-4;  // [m] and [rad], together
    constexpr double kNearlySettled = 2e-3;
    const int stride = scan.size() > kManyPoints ? 2 : 1;
    Pose pose = start;
    for (int iteration = first; iteration < iterations; ++iteration) {
        const Linearization l = linearize(scan, map, pose, stage_of(iteration), stride);
        if (l.matches < kLeastMatches) break;
        const Eigen::Vector3d away(pose.x - prior.mean.x, pose.y - prior.mean.y,
                                   wrap_angle(pose.theta - prior.mean.theta));
        const Eigen::Vector3d pull = prior.information * away;
        const double weight = prior.robust ? robust_weight(away.dot(pull)) : 1.0;
        const Eigen::Matrix3d h = information_ * l.h + weight * prior.information;
        const Eigen::Vector3d step = -h.ldlt().solve(information_ * l.b + weight * pull);
        if (!step.allFinite()) break;
        pose = shifted(pose, step);
        const double size = step.cwiseAbs().sum();
        if (iteration >= 8 && size < kSettled) break;
        if (iteration == kWideSteps - 1 && size < kNearlySettled)
            iteration = 7;  // the fine stage is next
    }
    return pose;
}

}  // namespace hitos
