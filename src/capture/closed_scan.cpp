// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/closed_scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace hitos {
namespace {

/// Between equals, as ranges in whole millimetres often are, the bearing decides: in metres per
/// radian, far below what is measured and far above rounding.
constexpr double kTie = 1e-9;
/// To each side of a point that may be a corner.
constexpr double kWindow = 5.0 * kPi / 180.0;

bool first_is_neighbour_of_last(const Scan& scan) {
    return scan.rays.front() == 0 && scan.rays.back() + 1 == scan.fan.count;
}

/// How far a point lies from the line through two others [m].
double deviation(const Point2& p, const Point2& a, const Point2& b) {
    const double length = distance(a, b);
    if (length == 0.0) return distance(a, p);
    return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

/// The points of a closed scan counter-clockwise, as places round a ring.
class Ring {
  public:
    explicit Ring(const Scan& scan)
        : scan_(scan), size_(scan.points.size()), clockwise_(scan.fan.step_rad() < 0.0) {}

    /// The place in the scan of what comes at a place of the ring.
    std::size_t in_scan(std::size_t place) const {
        place %= size_;
        return clockwise_ ? size_ - 1 - place : place;
    }

    /// Places before which a run of neighbours ends.
    std::vector<std::size_t> breaks() const {
        std::vector<std::size_t> places;
        for (const std::uint32_t start : scan_.run_starts) {
            if (start == 0 && first_is_neighbour_of_last(scan_)) continue;
            places.push_back(clockwise_ ? (size_ - start) % size_ : start);
        }
        std::sort(places.begin(), places.end());
        return places;
    }

    std::size_t widest(const std::vector<std::size_t>& breaks) const {
        return *std::max_element(breaks.begin(), breaks.end(), [&](std::size_t a, std::size_t b) {
            return distance(point(a + size_ - 1), point(a)) + tie(a) <
                   distance(point(b + size_ - 1), point(b)) + tie(b);
        });
    }

    /// The place behind the point that stands out most, or before it where that lies nearer to the
    /// next one: at the end of a wall it stays with its wall.
    std::size_t sharpest() const {
        if (size_ < 5) return 0;
        const auto window = std::clamp<std::size_t>(
            static_cast<std::size_t>(std::lround(kWindow / std::abs(scan_.fan.step_rad()))), 2,
            (size_ - 1) / 2);
        const auto farthest = [&](std::size_t from, std::size_t to, const auto& out_of_line) {
            std::size_t at = from;
            double most = -1.0;
            for (std::size_t i = from; i < to; ++i) {
                const double out = out_of_line(i) + tie(i);
                if (out > most) {
                    most = out;
                    at = i;
                }
            }
            return at;
        };
        const std::size_t near = farthest(size_, 2 * size_, [&](std::size_t i) {
            return deviation(point(i), point(i - window), point(i + window));
        });
        // Every point near the end of a wall is far from a line that leads to another wall: the
        // end itself is the farthest from the line over it.
        const std::size_t at = farthest(near - window, near + window + 1, [&](std::size_t i) {
            return deviation(point(i), point(near - window), point(near + window));
        });
        const bool with_next =
            distance(point(at), point(at + 1)) < distance(point(at - 1), point(at)) - kTie;
        return (with_next ? at : at + 1) % size_;
    }

  private:
    const Point2& point(std::size_t place) const { return scan_.points[in_scan(place)]; }
    double tie(std::size_t place) const {
        const Pose& laser = scan_.fan.pose_robot_laser;
        return kTie * std::atan2(point(place).y - laser.y, point(place).x - laser.x);
    }

    const Scan& scan_;
    std::size_t size_;
    bool clockwise_;
};

}  // namespace

bool goes_all_round(const Scan& scan) {
    return scan.fan.closed() && scan.run_starts.size() == 1 &&
           scan.rays.size() == scan.points.size() && first_is_neighbour_of_last(scan);
}

const Scan& cut_open(const Scan& scan, Scan& room) {
    const std::size_t size = scan.points.size();
    if (!scan.fan.closed() || size == 0 || scan.rays.size() != size) return scan;
    const Ring ring(scan);
    std::vector<std::size_t> breaks = ring.breaks();
    const std::size_t start = breaks.empty() ? ring.sharpest() : ring.widest(breaks);

    room.time_s = scan.time_s;
    room.line = scan.line;
    room.carries_odometry = scan.carries_odometry;
    const std::uint32_t first_ray = scan.rays[ring.in_scan(start)];
    const std::uint32_t count = scan.fan.count;
    const bool clockwise = scan.fan.step_rad() < 0.0;
    room.fan = scan.fan;
    room.fan.min_angle_rad = scan.fan.angle_rad(first_ray);
    room.fan.max_angle_rad =
        room.fan.min_angle_rad + std::abs(scan.fan.max_angle_rad - scan.fan.min_angle_rad);
    room.points.clear();
    room.rays.clear();
    for (std::size_t place = start; place < start + size; ++place) {
        const std::size_t i = ring.in_scan(place);
        room.points.push_back(scan.points[i]);
        const std::uint32_t ray = scan.rays[i];
        room.rays.push_back((clockwise ? first_ray + count - ray : ray + count - first_ray) %
                            count);
    }
    room.run_starts.assign(1, 0);
    std::rotate(breaks.begin(), std::lower_bound(breaks.begin(), breaks.end(), start),
                breaks.end());
    for (const std::size_t place : breaks) {
        if (place == start) continue;
        room.run_starts.push_back(static_cast<std::uint32_t>((place + size - start) % size));
    }
    return room;
}

}  // namespace hitos
