#include "correlation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <queue>
#include <utility>

namespace hitos {
namespace {

constexpr int kReach = 2;   // of the blur [cells]
constexpr int kMost = 255;  // of a cell
/// Value of a cell by its offset from a point's: a Gaussian of 1.2 cells, the point's own place in
/// its cell unknown.
constexpr std::array<std::array<std::uint8_t, kReach + 1>, kReach + 1> kBlur{
    {{kMost, 230, 130}, {230, 200, 110}, {130, 110, 60}}};

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

CorrelationMap::CorrelationMap(const PointMap& map, double half_m, int levels) {
    blur(map, half_m);
    for (int level = 1; level <= levels; ++level) {
        pictures_.push_back(coarser(pictures_.back(), std::size_t{1} << (level - 1)));
    }
}

CorrelationMap::Cell CorrelationMap::cell(double x, double y) const {
    const auto number = [](double offset) {
        return static_cast<int>(std::floor(std::clamp(offset / kCell, -1e6, 1e6)));
    };
    return {number(x - x0_), number(y - y0_)};
}

void CorrelationMap::blur(const PointMap& map, double half_m) {
    Bounds bounds;  // no greater than the points: most places are long and thin
    const auto inside = [half_m](const MapPoint& p) {
        return std::abs(static_cast<double>(p.x)) <= half_m &&
               std::abs(static_cast<double>(p.y)) <= half_m;
    };
    for (const MapPoint& p : map.points()) {
        if (inside(p)) bounds.hold({static_cast<double>(p.x), static_cast<double>(p.y)});
    }
    // Cells count from the centre, whatever the bounds.
    const double first_column = std::floor(bounds.low.x / kCell) - kReach;
    const double first_row = std::floor(bounds.low.y / kCell) - kReach;
    columns_ = static_cast<int>(std::floor(bounds.high.x / kCell) - first_column) + kReach + 1;
    rows_ = static_cast<int>(std::floor(bounds.high.y / kCell) - first_row) + kReach + 1;
    x0_ = map.centre().x + first_column * kCell;
    y0_ = map.centre().y + first_row * kCell;
    Picture finest(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const MapPoint& p : map.points()) {
        if (!inside(p)) continue;
        const auto a =
            static_cast<int>(std::floor(static_cast<double>(p.x) / kCell) - first_column);
        const auto b = static_cast<int>(std::floor(static_cast<double>(p.y) / kCell) - first_row);
        for (int v = -kReach; v <= kReach; ++v) {
            const auto line = static_cast<std::size_t>(b + v) * static_cast<std::size_t>(columns_);
            for (int u = -kReach; u <= kReach; ++u) {
                std::uint8_t& value = finest[line + static_cast<std::size_t>(a + u)];
                value = std::max(value, kBlur[static_cast<std::size_t>(std::abs(u))]
                                             [static_cast<std::size_t>(std::abs(v))]);
            }
        }
    }
    pictures_.push_back(std::move(finest));
}

/// Running maxima over squares of twice the size; whole rows at a time, which the compiler makes
/// vectors of.
CorrelationMap::Picture CorrelationMap::coarser(const Picture& fine, std::size_t half) const {
    const auto columns = static_cast<std::size_t>(columns_);
    const auto rows = static_cast<std::size_t>(rows_);
    Picture coarse = fine;
    for (std::size_t y = 0; y < rows; ++y) {
        const std::uint8_t* const from = fine.data() + y * columns;
        std::uint8_t* const to = coarse.data() + y * columns;
        for (std::size_t x = 0; x + half < columns; ++x) to[x] = std::max(from[x], from[x + half]);
    }
    // From the first row on: the rows ahead are still those of the first pass.
    for (std::size_t y = 0; y + half < rows; ++y) {
        std::uint8_t* const to = coarse.data() + y * columns;
        const std::uint8_t* const ahead = to + half * columns;
        for (std::size_t x = 0; x < columns; ++x) to[x] = std::max(to[x], ahead[x]);
    }
    return coarse;
}

int CorrelationMap::sum(std::span<const Cell> cells, int x, int y, int level, int least) const {
    constexpr std::size_t kAtOnce = 64;  // cells between two looks at what can still be reached
    const std::vector<std::uint8_t>& picture = pictures_[static_cast<std::size_t>(level)];
    const int reach = 1 << level;
    int sum = 0;
    for (std::size_t begin = 0; begin < cells.size(); begin += kAtOnce) {
        const std::span<const Cell> left = cells.subspan(begin);
        if (sum + kMost * static_cast<int>(left.size()) < least) break;
        for (const Cell& cell : left.first(std::min(kAtOnce, left.size()))) {
            int a = cell.column + x;
            int b = cell.row + y;
            // A square that begins outside may reach into the map.
            if (a < 0 && a > -reach) a = 0;
            if (b < 0 && b > -reach) b = 0;
            if (a < 0 || b < 0 || a >= columns_ || b >= rows_) continue;
            sum += picture[static_cast<std::size_t>(b) * static_cast<std::size_t>(columns_) +
                           static_cast<std::size_t>(a)];
        }
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

    std::vector<std::vector<CorrelationMap::Cell>> turned(2 * static_cast<std::size_t>(angles) + 1);
    for (int angle = -angles; angle <= angles; ++angle) {
        const double c = std::cos(centre.theta + angle * angle_step);
        const double s = std::sin(centre.theta + angle * angle_step);
        const int place = angle + angles;
        auto& cells = turned[static_cast<std::size_t>(place)];
        cells.reserve(points.size());
        for (const SurfacePoint& p : points) {
            const auto x = static_cast<double>(p.x);
            const auto y = static_cast<double>(p.y);
            cells.push_back(map.cell(centre.x + c * x - s * y, centre.y + s * x + c * y));
        }
    }
    const auto count = static_cast<double>(points.size());
    const auto least = static_cast<int>(least_score * kMost * count);
    std::priority_queue<Square> open;
    const auto offer = [&](int angle, int x, int y, int level) {
        if (x > reach || y > reach) return;  // squares at the window's edge reach beyond it
        const int place = angle + angles;
        const int sum = map.sum(turned[static_cast<std::size_t>(place)], x, y, level, least);
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
                               best.sum / (kMost * count)};
        }
        const int half = 1 << (best.level - 1);
        for (const int x : {best.x, best.x + half}) {
            for (const int y : {best.y, best.y + half}) offer(best.angle, x, y, best.level - 1);
        }
    }
    return std::nullopt;
}

}  // namespace hitos
