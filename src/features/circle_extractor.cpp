// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_extractor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hitos {
namespace {

constexpr double kLeastRadius = 1e-3;  // [m]

/// Where the laser is, in the frame of the points.
Point2 laser_of(const Scan& scan) {
    return {scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y};
}

/// Sums over the equations of Gauss-Newton, for (range, bearing, radius).
struct Equations {
    Eigen::Matrix3d weights = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sides = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& gradient, double residual, double sigma) {
        weights += gradient * gradient.transpose() / (sigma * sigma);
        sides -= gradient * (residual / (sigma * sigma));
    }
};

}  // namespace

std::optional<FittedCircle> fit_circle(std::span<const SeenPoint> seen,
                                       const CircleErrors& errors) {
    constexpr int kSteps = 12;
    constexpr double kStill = 1e-7;  // [m]
    const double from = seen.front().bearing_rad;
    const double covered = wrap_angle(seen.back().bearing_rad - from);
    const double step = errors.step_rad;
    const double sigma_edge = step / std::sqrt(12.0);  // of anywhere within a step
    if (covered < 0.0 || covered + step >= kPi) return std::nullopt;
    double nearest = std::numeric_limits<double>::infinity();
    for (const SeenPoint& one : seen) nearest = std::min(nearest, one.range_m);
    // range = nearest + radius, radius = range sin(half the angle). Bearings are counted from the
    // first ray, so that none is wrapped.
    const double sine = std::sin(0.5 * (covered + step));
    double radius = std::max(nearest * sine / (1.0 - sine), kLeastRadius);
    double range = nearest + radius;
    double bearing = 0.5 * covered;
    Equations equations;
    double spread = 0.0;  // of the points about the circle, over sigma, squared
    for (int i = 0; i < kSteps; ++i) {
        equations = {};
        spread = 0.0;
        const double c = std::cos(bearing);
        const double s = std::sin(bearing);
        for (const SeenPoint& one : seen) {
            const double angle = wrap_angle(one.bearing_rad - from);
            const double x = one.range_m * std::cos(angle) - range * c;
            const double y = one.range_m * std::sin(angle) - range * s;
            const double away = std::max(std::hypot(x, y), kLeastRadius);
            const double residual = away - radius;
            equations.add({-(x * c + y * s) / away, (x * s - y * c) * range / away, -1.0}, residual,
                          errors.range_sigma_m);
            spread += residual * residual / (errors.range_sigma_m * errors.range_sigma_m);
        }
        const double half_sine = radius / range;
        const double half_angle = std::asin(half_sine);
        const double slope = 1.0 / (range * std::sqrt(1.0 - half_sine * half_sine));
        for (const double side : {-1.0, 1.0}) {
            const double edge = side < 0.0 ? -0.5 * step : covered + 0.5 * step;
            const double residual = bearing + side * half_angle - edge;
            equations.add({-side * half_sine * slope, 1.0, side * slope}, residual, sigma_edge);
        }
        const Eigen::Vector3d move = equations.weights.inverse() * equations.sides;
        if (!move.allFinite()) return std::nullopt;
        range += move(0);
        bearing += move(1);
        radius = std::max(radius + move(2), kLeastRadius);
        if (!(range > radius)) return std::nullopt;
        if (std::abs(move(0)) + range * std::abs(move(1)) + std::abs(move(2)) < kStill) break;
    }
    const auto n = static_cast<double>(seen.size());
    if (spread > n + 4.0 * std::sqrt(2.0 * n)) return std::nullopt;
    const Eigen::Matrix3d covariance = equations.weights.inverse();
    return FittedCircle{range, wrap_angle(from + bearing), radius,
                        covariance.topLeftCorner<2, 2>()};
}

/// Fills the ring.
void CircleExtractor::look(const Scan& scan) {
    const Point2 laser = laser_of(scan);
    ring_.clear();
    for (std::uint32_t i = 0; i < scan.points.size(); ++i) {
        const Point2 ray{scan.points[i].x - laser.x, scan.points[i].y - laser.y};
        ring_.push_back({std::atan2(ray.y, ray.x), std::hypot(ray.x, ray.y), i});
    }
    closed_ = scan.fan.closed();
    double turned = 0.0;  // which way; what is small says it best
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < ring_.size(); ++i) {
        const double step = wrap_angle(ring_[i + 1].bearing_rad - ring_[i].bearing_rad);
        // Of half a turn over which nothing was met nobody can say which way it went.
        turned += std::copysign(kPi - std::abs(step), step);
        if (step != 0.0) steps.push_back(std::abs(step));
    }
    // A laser that sits upside down sweeps the other way, whatever its angles say.
    if (turned < 0.0) std::ranges::reverse(ring_);
    step_rad_ = std::abs(scan.fan.step_rad());
    if (step_rad_ > 0.0 || steps.empty()) return;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, middle);
    step_rad_ = *middle;
}

/// To the next point of the ring [rad]; several steps where rays between met nothing.
double CircleExtractor::turn_to_next(std::size_t i) const {
    return wrap_angle(ring_[(i + 1) % ring_.size()].bearing_rad - ring_[i].bearing_rad);
}

/// Whether a point and the next one may be of one thing.
bool CircleExtractor::joins_next(std::size_t i) const {
    const std::size_t next = (i + 1) % ring_.size();
    if (next == 0 && !closed_) return false;
    const double turn = turn_to_next(i);
    if (turn < 0.0) return false;
    const double nearer = std::min(ring_[i].range_m, ring_[next].range_m);
    return std::abs(ring_[i].range_m - ring_[next].range_m) <= params_.gap_m &&
           nearer * std::max(0.0, turn - step_rad_) <= params_.gap_m;
}

/// Whether beside the end of a cluster the laser looked past it: nothing hides a part of it, and
/// nothing else is as near as a bush's other twigs, or the wall that it is the end of.
bool CircleExtractor::clear_beside(const SeenPoint& end, std::size_t from, bool left,
                                   const Scan& scan) const {
    const auto size = static_cast<std::ptrdiff_t>(ring_.size());
    const auto at = [&](std::ptrdiff_t i) { return ring_[static_cast<std::size_t>(i % size)]; };
    const Point2& p = scan.points[end.point];
    for (std::ptrdiff_t k = 1; k < size; ++k) {
        const auto i = static_cast<std::ptrdiff_t>(from) + (left ? k : size - k);
        const bool beyond_end = left ? i >= size : i < size;
        if (!closed_ && beyond_end) {
            // No point there: the rays beside it met nothing, unless there are none.
            if (k > 1) return true;
            if (scan.fan.count < 2 || scan.rays.size() != scan.points.size()) return false;
            const std::uint32_t ray = scan.rays[end.point];
            return ray > 0 && ray + 1 < scan.fan.count;
        }
        const SeenPoint beside = at(i);
        const double turn = left ? wrap_angle(beside.bearing_rad - end.bearing_rad)
                                 : wrap_angle(end.bearing_rad - beside.bearing_rad);
        if (turn < 0.0 || end.range_m * (turn - step_rad_) > params_.gap_m) return true;
        if (turn < 1.5 * step_rad_ && beside.range_m < end.range_m) return false;
        if (distance(p, scan.points[beside.point]) <= params_.gap_m) return false;
    }
    return true;
}

bool CircleExtractor::stands_alone(std::size_t first, std::size_t count, const Scan& scan) const {
    const std::size_t last = (first + count - 1) % ring_.size();
    return clear_beside(ring_[first], first, false, scan) &&
           clear_beside(ring_[last], last, true, scan);
}

void CircleExtractor::find(const Scan& scan) {
    circles_.clear();
    taken_.assign(scan.points.size(), false);
    look(scan);
    const std::size_t size = ring_.size();
    if (size < 2 || step_rad_ == 0.0) return;
    std::size_t start = 0;
    while (start < size && joins_next((start + size - 1) % size)) ++start;
    if (start == size) return;  // one wall all round
    std::size_t count = 1;
    for (std::size_t at = start; at < start + size; at += count) {
        for (count = 1; at + count < start + size && joins_next((at + count - 1) % size);) ++count;
        const std::size_t first = at % size;
        if (count < static_cast<std::size_t>(params_.min_points)) continue;
        const double wide = ring_[first].range_m * static_cast<double>(count - 1) * step_rad_;
        if (wide > 3.0 * params_.max_radius_m) continue;  // a wall: nothing to try
        cluster_.clear();
        for (std::size_t i = 0; i < count; ++i) cluster_.push_back(ring_[(first + i) % size]);
        const auto circle = fit_circle(cluster_, {sigma_m_, step_rad_});
        if (!circle || circle->radius_m > params_.max_radius_m ||
            !stands_alone(first, count, scan)) {
            continue;
        }
        circles_.push_back(*circle);
        for (const SeenPoint& one : cluster_) taken_[one.point] = true;
    }
}

const Scan& CircleExtractor::without_circles(const Scan& scan) {
    if (circles_.empty()) return scan;
    left_ = scan;
    left_.points.clear();
    left_.rays.clear();
    left_.times_s.clear();
    left_.run_starts.clear();
    for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
        bool open = false;
        for (std::uint32_t i = scan.run_starts[run]; i < scan.run_end(run); ++i) {
            if (taken_[i]) {
                open = false;
                continue;
            }
            if (!open) left_.run_starts.push_back(static_cast<std::uint32_t>(left_.points.size()));
            open = true;
            left_.points.push_back(scan.points[i]);
            if (!scan.rays.empty()) left_.rays.push_back(scan.rays[i]);
            if (!scan.times_s.empty()) left_.times_s.push_back(scan.times_s[i]);
        }
    }
    return left_;
}

void CircleExtractor::extract(const Scan& scan, Observation& out) {
    find(scan);
    rest_->extract(without_circles(scan), out);
    const Point2 laser = laser_of(scan);
    out.corners.insert(out.corners.begin(), circles_.size(), {});
    out.corner_covariances.insert(out.corner_covariances.begin(), circles_.size(),
                                  Eigen::Matrix2d::Zero());
    if (!out.identities.empty())
        out.identities.insert(out.identities.begin(), circles_.size(), LandmarkSighting::kNameless);
    for (std::size_t i = 0; i < circles_.size(); ++i) {
        const FittedCircle& circle = circles_[i];
        const double c = std::cos(circle.bearing_rad);
        const double s = std::sin(circle.bearing_rad);
        out.corners[i] = {laser.x + circle.range_m * c, laser.y + circle.range_m * s};
        out.circle_radii_m.push_back(circle.radius_m);
        Eigen::Matrix2d to_xy;
        to_xy << c, -s * circle.range_m, s, c * circle.range_m;
        // No surer than one range, and trunks are no circles.
        Eigen::Matrix2d polar = circle.covariance;
        const double least = sigma_m_ * sigma_m_;
        const double across = circle.range_m * circle.range_m;
        polar(0, 0) = std::max(polar(0, 0), least);
        polar(1, 1) = std::max(polar(1, 1), least / across);
        out.corner_covariances[i] = to_xy * polar * to_xy.transpose() +
                                    common_sigma_m_ * common_sigma_m_ * Eigen::Matrix2d::Identity();
    }
}

}  // namespace hitos
