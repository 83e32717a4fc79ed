// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "hitos/capture/closed_scan.hpp"

namespace hitos {
namespace {

constexpr double kLeastRange = 0.05;  // [m]; what is nearer is the robot
constexpr std::uint32_t kManyRays = 250;
constexpr double kHalfWindow = 3.0 * kPi / 180.0;
constexpr int kLeastNeighbours = 3;       // to each side
constexpr double kFarNeighbour = 0.5;     // [m], beyond the least number
constexpr int kLeastPoints = 4;           // of a surface
constexpr double kLongerThanThick = 6.0;  // variance along the surface over that across it

/// Ranges of neighbours that differ by more belong to two surfaces.
double jump(double range) {
    return 0.3 + 0.05 * range;
}

/// Standard deviation across a surface that a plane wall may have.
double thickness(double range) {
    return 0.03 + 0.005 * range;
}

/// First and second moments of points about one of them.
struct Moments {
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    int count = 0;

    void add(double u, double v) {
        x += u;
        y += v;
        xx += u * u;
        yy += v * v;
        xy += u * v;
        ++count;
    }
};

/// The angle between neighbouring rays as the points show it, where the fan is not known.
double seen_step(const Scan& scan) {
    double sum = 0.0;
    std::size_t steps = 0;
    for (std::size_t i = 1; i < scan.points.size(); ++i) {
        const Point2& a = scan.points[i - 1];
        const Point2& b = scan.points[i];
        sum += std::abs(wrap_angle(std::atan2(b.y, b.x) - std::atan2(a.y, a.x)));
        ++steps;
    }
    return steps > 0 ? sum / static_cast<double>(steps) : 0.0;
}

class SurfaceFinder {
  public:
    SurfaceFinder(const Scan& scan, double range_m) : scan_(scan), range_m_(range_m) {
        const double step = scan.fan.count > 1 ? std::abs(scan.fan.step_rad()) : seen_step(scan);
        half_ = kLeastNeighbours;
        if (step > 0.0) {
            half_ = std::max(half_,
                             static_cast<int>(std::lround(std::min(kHalfWindow / step, 1000.0))));
        }
        ranges_.reserve(scan.points.size());
        const Pose& laser = scan.fan.pose_robot_laser;
        for (const Point2& p : scan.points) {
            ranges_.push_back(std::hypot(p.x - laser.x, p.y - laser.y));
        }
    }

    bool usable(std::size_t i) const {
        return ranges_[i] > kLeastRange && ranges_[i] < range_m_ &&
               std::isfinite(scan_.points[i].x) && std::isfinite(scan_.points[i].y);
    }

    /// Of point i in the run [begin, end).
    SurfacePoint at(std::size_t i, std::size_t begin, std::size_t end) const {
        const Point2& p = scan_.points[i];
        SurfacePoint point{static_cast<float>(p.x), static_cast<float>(p.y)};
        Moments moments;
        moments.add(0.0, 0.0);
        collect(i, begin, end, -1, moments);
        collect(i, begin, end, +1, moments);
        if (moments.count >= kLeastPoints) set_normal(moments, ranges_[i], point);
        return point;
    }

  private:
    void collect(std::size_t i, std::size_t begin, std::size_t end, std::ptrdiff_t side,
                 Moments& moments) const {
        const double limit = jump(ranges_[i]);
        std::size_t previous = i;
        for (int q = 1; q <= half_; ++q) {
            const auto j = static_cast<std::ptrdiff_t>(i) + side * q;
            if (j < static_cast<std::ptrdiff_t>(begin) || j >= static_cast<std::ptrdiff_t>(end)) {
                return;
            }
            const auto next = static_cast<std::size_t>(j);
            if (!usable(next) || std::abs(ranges_[next] - ranges_[previous]) > limit) return;
            const double u = scan_.points[next].x - scan_.points[i].x;
            const double v = scan_.points[next].y - scan_.points[i].y;
            if (q > kLeastNeighbours && u * u + v * v > kFarNeighbour * kFarNeighbour) return;
            moments.add(u, v);
            previous = next;
        }
    }

    void set_normal(const Moments& m, double range, SurfacePoint& point) const {
        const double mx = m.x / m.count;
        const double my = m.y / m.count;
        const double xx = m.xx / m.count - mx * mx;
        const double yy = m.yy / m.count - my * my;
        const double xy = m.xy / m.count - mx * my;
        // The eigenvalues and, for the lesser one, the eigenvector of the scatter.
        const double half = 0.5 * (xx + yy);
        const double root = std::hypot(0.5 * (xx - yy), xy);
        const double across = half - root;
        const double along = half + root;
        if (!(across < thickness(range) * thickness(range) && along > kLongerThanThick * across)) {
            return;
        }
        const double angle = 0.5 * std::atan2(-2.0 * xy, yy - xx);
        double c = std::cos(angle);
        double s = std::sin(angle);
        const Pose& laser = scan_.fan.pose_robot_laser;
        if (c * (static_cast<double>(point.x) - laser.x) +
                s * (static_cast<double>(point.y) - laser.y) >
            0.0) {
            c = -c;
            s = -s;
        }
        point.nx = static_cast<float>(c);
        point.ny = static_cast<float>(s);
    }

    const Scan& scan_;
    double range_m_;
    int half_ = kLeastNeighbours;  // of the window of neighbours [rays]
    std::vector<double> ranges_;   // from the laser [m]
};

}  // namespace

void find_surface_points(const Scan& as_logged, double range_m, std::vector<SurfacePoint>& points) {
    points.clear();
    Scan room;
    const Scan& scan = cut_open(as_logged, room);
    const SurfaceFinder finder(scan, range_m);
    const std::size_t rays = scan.fan.count > 0 ? scan.fan.count : scan.points.size();
    const std::uint32_t stride = rays > kManyRays ? 2 : 1;
    for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
        const std::size_t begin = scan.run_starts[run];
        const std::size_t end = scan.run_end(run);
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t ray =
                scan.rays.empty() ? static_cast<std::uint32_t>(i) : scan.rays[i];
            if (ray % stride == 0 && finder.usable(i)) points.push_back(finder.at(i, begin, end));
        }
    }
}

}  // namespace hitos
