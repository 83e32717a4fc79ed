#include "correlation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <queue>

namespace hitos {
namespace {

constexpr int kReach = 2;  // of the blur [cells]
/// Value of a cell by its offset from a point's: a Gaussian of 1.2 cells, the point's own place in
/// its cell unknown.
constexpr std::array<std::array<std::uint8_t, kReach + 1>, kReach + 1> kBlur{
    {{255, 230, 130}, {230, 200, 110}, {130, 110, 60}}};

/// A square of positions at one angle, with the bound of its score.
struct Square {
    int sum;
    int angle;
    int x;
    int y;
    int level;

    /// The least of the queue; of equal sums finer squares come first, then by place, so that the
    /// order never depends on how the queue is built.
    friend bool operator<(const Square& a, const Square& b) {
        if (a.sum != b.sum) return a.sum < b.sum;
        if (a.level != b.level) return a.level > b.level;
        if (a.angle != b.angle) return a.angle > b.angle;
        if (a.x != b.x) return a.x > b.x;
        return a.y > b.y;
    }
};

}  // namespace

CorrelationMap::CorrelationMap(std::span<const MapPoint> points, const Point2& centre,
                               double half_m, int levels)
    : side_(static_cast<int>(2.0 * half_m / kCell) + 1),
      x0_(centre.x - half_m),
      y0_(centre.y - half_m),
      pictures_(static_cast<std::size_t>(levels) + 1) {
    blur(points);
    coarsen();
}

int CorrelationMap::column(double x) const {
    return static_cast<int>(std::floor(std::clamp((x - x0_) / kCell, -1e6, 1e6)));
}

int CorrelationMap::row(double y) const {
    return static_cast<int>(std::floor(std::clamp((y - y0_) / kCell, -1e6, 1e6)));
}

void CorrelationMap::blur(std::span<const MapPoint> points) {
    std::vector<std::uint8_t>& finest = pictures_.front();
    finest.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0);
    for (const MapPoint& point : points) {
        const int a = column(static_cast<double>(point.x));
        const int b = row(static_cast<double>(point.y));
        if (a < kReach || b < kReach || a >= side_ - kReach || b >= side_ - kReach) continue;
        for (int v = -kReach; v <= kReach; ++v) {
            for (int u = -kReach; u <= kReach; ++u) {
                std::uint8_t& cell =
                    finest[static_cast<std::size_t>(b + v) * static_cast<std::size_t>(side_) +
                           static_cast<std::size_t>(a + u)];
                cell = std::max(cell, kBlur[static_cast<std::size_t>(std::abs(u))]
                                           [static_cast<std::size_t>(std::abs(v))]);
            }
        }
    }
}

void CorrelationMap::coarsen() {
    const auto side = static_cast<std::size_t>(side_);
    std::vector<std::uint8_t> wide(side * side);
    for (std::size_t level = 1; level < pictures_.size(); ++level) {
        const std::vector<std::uint8_t>& fine = pictures_[level - 1];
        std::vector<std::uint8_t>& coarse = pictures_[level];
        const std::size_t half = std::size_t{1} << (level - 1);
        coarse.resize(side * side);
        for (std::size_t y = 0; y < side; ++y) {
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t i = y * side + x;
                wide[i] = x + half < side ? std::max(fine[i], fine[i + half]) : fine[i];
            }
        }
        for (std::size_t y = 0; y < side; ++y) {
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t i = y * side + x;
                coarse[i] = y + half < side ? std::max(wide[i], wide[i + half * side]) : wide[i];
            }
        }
    }
}

int CorrelationMap::sum(std::span<const Cell> cells, int x, int y, int level) const {
    const std::vector<std::uint8_t>& picture = pictures_[static_cast<std::size_t>(level)];
    const int reach = 1 << level;
    int sum = 0;
    for (const Cell& cell : cells) {
        int a = cell.column + x;
        int b = cell.row + y;
        // A square that begins outside may reach into the map.
        if (a < 0 && a > -reach) a = 0;
        if (b < 0 && b > -reach) b = 0;
        if (a < 0 || b < 0 || a >= side_ || b >= side_) continue;
        sum += picture[static_cast<std::size_t>(b) * static_cast<std::size_t>(side_) +
                       static_cast<std::size_t>(a)];
    }
    return sum;
}

std::optional<Correlation> correlate(std::span<const SurfacePoint> points,
                                     const CorrelationMap& map, const Pose& centre,
                                     const SearchWindow& window, double least_score) {
    constexpr int kMostOpened = 20000;
    if (points.empty()) return std::nullopt;
    double far = 1.0;
    for (const SurfacePoint& p : points) {
        far = std::max(far, std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)));
    }
    // The furthest points that matter move about a cell from angle to angle.
    const double angle_step =
        std::clamp(1.2 * CorrelationMap::kCell / std::min(far, 10.0), 0.012, 0.03);
    const int angles = static_cast<int>(std::ceil(window.heading_rad / angle_step));
    const int reach = static_cast<int>(std::ceil(window.position_m / CorrelationMap::kCell));

    std::vector<std::vector<CorrelationMap::Cell>> turned(static_cast<std::size_t>(2 * angles + 1));
    for (int angle = -angles; angle <= angles; ++angle) {
        const double c = std::cos(centre.theta + angle * angle_step);
        const double s = std::sin(centre.theta + angle * angle_step);
        auto& cells = turned[static_cast<std::size_t>(angle + angles)];
        cells.reserve(points.size());
        for (const SurfacePoint& p : points) {
            const double x = static_cast<double>(p.x);
            const double y = static_cast<double>(p.y);
            cells.push_back(
                {map.column(centre.x + c * x - s * y), map.row(centre.y + s * x + c * y)});
        }
    }
    const auto count = static_cast<double>(points.size());
    const auto least = static_cast<int>(least_score * 255.0 * count);
    std::priority_queue<Square> open;
    const auto offer = [&](int angle, int x, int y, int level) {
        if (x > reach || y > reach) return;  // squares at the window's edge reach beyond it
        const int sum = map.sum(turned[static_cast<std::size_t>(angle + angles)], x, y, level);
        if (sum >= least) open.push({sum, angle, x, y, level});
    };
    const int width = 1 << map.levels();
    for (int angle = -angles; angle <= angles; ++angle) {
        for (int x = -reach; x <= reach; x += width) {
            for (int y = -reach; y <= reach; y += width) offer(angle, x, y, map.levels());
        }
    }
    for (int opened = 0; !open.empty() && opened < kMostOpened; ++opened) {
        const Square best = open.top();
        open.pop();
        if (best.level == 0) {
            return Correlation{{centre.x + best.x * CorrelationMap::kCell,
                                centre.y + best.y * CorrelationMap::kCell,
                                wrap_angle(centre.theta + best.angle * angle_step)},
                               best.sum / 255.0 / count};
        }
        const int half = 1 << (best.level - 1);
        for (const int x : {best.x, best.x + half}) {
            for (const int y : {best.y, best.y + half}) offer(best.angle, x, y, best.level - 1);
        }
    }
    return std::nullopt;
}

}  // namespace hitos
