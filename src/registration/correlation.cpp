// SPDX-License-Identifier: GPL-3.0-or-later
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

namespace {

/// Of the squares of a window those that come near some positions.
class Mask {
  public:
    static constexpr int kFinest = 3;  // level

    /// All of the window where there are no positions.
    Mask(const Pose& centre, int reach, int levels, std::span<const Point2> positions,
         double within_m) {
        if (positions.empty()) return;
        const double side = CorrelationMap::kCell * (1 << kFinest);
        const auto cells = [&](double m) { return static_cast<int>(std::floor(m / side)); };
        columns_ = ((2 * reach) >> kFinest) + 1;
        levels_.assign(static_cast<std::size_t>(std::max(1, levels - kFinest + 1)), {});
        levels_.front().assign(
            static_cast<std::size_t>(columns_) * static_cast<std::size_t>(columns_), false);
        const double low = reach * CorrelationMap::kCell;
        for (const Point2& at : positions) {
            const double x = at.x - centre.x + low;
            const double y = at.y - centre.y + low;
            for (int i = std::max(0, cells(x - within_m));
                 i <= std::min(columns_ - 1, cells(x + within_m)); ++i) {
                for (int j = std::max(0, cells(y - within_m));
                     j <= std::min(columns_ - 1, cells(y + within_m)); ++j) {
                    levels_.front()[place(i, j, 0)] = true;
                }
            }
        }
        for (std::size_t level = 1; level < levels_.size(); ++level) {
            const int side_cells = width(level);
            levels_[level].assign(
                static_cast<std::size_t>(side_cells) * static_cast<std::size_t>(side_cells), false);
            for (int i = 0; i < width(level - 1); ++i) {
                for (int j = 0; j < width(level - 1); ++j) {
                    if (levels_[level - 1][place(i, j, level - 1)])
                        levels_[level][place(i / 2, j / 2, level)] = true;
                }
            }
        }
    }

    /// Whether a square, its corner counted from the window's, may hold a place.
    bool holds(int x, int y, int level) const {
        if (levels_.empty()) return true;
        const int above = std::max(0, level - kFinest);
        const int shift = above + kFinest;
        return levels_[static_cast<std::size_t>(above)]
                      [place(x >> shift, y >> shift, static_cast<std::size_t>(above))];
    }

  private:
    int width(std::size_t level) const { return ((columns_ - 1) >> level) + 1; }
    std::size_t place(int i, int j, std::size_t level) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(width(level)) +
               static_cast<std::size_t>(j);
    }

    int columns_ = 0;
    std::vector<std::vector<bool>> levels_;  // from kFinest on
};

/// Squares of places, best first.
class BestFirst {
  public:
    BestFirst(std::span<const SurfacePoint> points, const CorrelationMap& map, const Pose& centre,
              const SearchWindow& window, double least_score,
              std::span<const Point2> positions = {}, double within_m = 0.0)
        : map_(map),
          centre_(centre),
          count_(static_cast<double>(points.size())),
          reach_(static_cast<int>(std::ceil(window.position_m / CorrelationMap::kCell))),
          mask_(centre, reach_, map.levels(), positions, within_m) {
        double far = 1.0;
        for (const SurfacePoint& p : points) {
            far = std::max(far, std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)));
        }
        // The furthest points that matter move about a cell from angle to angle.
        angle_step_ = std::clamp(1.2 * CorrelationMap::kCell / std::min(far, 10.0), 0.012, 0.03);
        angles_ = static_cast<int>(std::ceil(window.heading_rad / angle_step_));
        least_ = static_cast<int>(least_score * kMost * count_);
        turn(points);
        const int width = 1 << map.levels();
        for (int x = -reach_; x <= reach_; x += width) {
            for (int y = -reach_; y <= reach_; y += width) {
                if (!mask_.holds(x + reach_, y + reach_, map.levels())) continue;
                for (int angle = -angles_; angle <= angles_; ++angle) {
                    offer(angle, x, y, map.levels());
                }
            }
        }
    }

    /// The next single place whose score is `least` at least, after at most `most` squares opened
    /// in all; squares of which `passed` is true are left out.
    template <class Passed>
    std::optional<Correlation> next(int most, double least, const Passed& passed) {
        for (; !open_.empty() && opened_ < most; ++opened_) {
            const Square best = open_.top();
            if (score(best) < least) break;
            open_.pop();
            if (passed(best)) continue;
            if (best.level == 0) return Correlation{pose(best, 0.0), score(best)};
            const int half = 1 << (best.level - 1);
            for (const int x : {best.x, best.x + half}) {
                for (const int y : {best.y, best.y + half}) offer(best.angle, x, y, best.level - 1);
            }
        }
        return std::nullopt;
    }

    /// Whether there may be further places of such a score.
    bool more(double least) const { return !open_.empty() && score(open_.top()) >= least; }
    /// Of a place of a square, `cells` from its corner.
    Pose pose(const Square& square, double cells) const {
        return {centre_.x + (square.x + cells) * CorrelationMap::kCell,
                centre_.y + (square.y + cells) * CorrelationMap::kCell,
                wrap_angle(centre_.theta + square.angle * angle_step_)};
    }

  private:
    double score(const Square& square) const { return square.sum / (kMost * count_); }

    void turn(std::span<const SurfacePoint> points) {
        turned_.resize(2 * static_cast<std::size_t>(angles_) + 1);
        for (int angle = -angles_; angle <= angles_; ++angle) {
            const double c = std::cos(centre_.theta + angle * angle_step_);
            const double s = std::sin(centre_.theta + angle * angle_step_);
            const int place = angle + angles_;
            auto& cells = turned_[static_cast<std::size_t>(place)];
            cells.reserve(points.size());
            for (const SurfacePoint& p : points) {
                const auto x = static_cast<double>(p.x);
                const auto y = static_cast<double>(p.y);
                cells.push_back(map_.cell(centre_.x + c * x - s * y, centre_.y + s * x + c * y));
            }
        }
    }
    void offer(int angle, int x, int y, int level) {
        if (x > reach_ || y > reach_) return;  // squares at the window's edge reach beyond it
        if (!mask_.holds(x + reach_, y + reach_, level)) return;
        const int place = angle + angles_;
        const int sum = map_.sum(turned_[static_cast<std::size_t>(place)], x, y, level, least_);
        if (sum >= least_) open_.push({sum, angle, x, y, level});
    }

    const CorrelationMap& map_;
    Pose centre_;
    double count_;
    int reach_;
    Mask mask_;
    double angle_step_ = 0.0;
    int angles_ = 0;
    int least_ = 0;
    int opened_ = 0;
    std::vector<std::vector<CorrelationMap::Cell>> turned_;
    std::priority_queue<Square> open_;
};

}  // namespace

std::optional<Correlation> correlate(std::span<const SurfacePoint> points,
                                     const CorrelationMap& map, const Pose& centre,
                                     const SearchWindow& window, double least_score) {
    constexpr int kMostOpened = 20000;
    if (points.empty()) return std::nullopt;
    return BestFirst(points, map, centre, window, least_score)
        .next(kMostOpened, least_score, [](const Square&) { return false; });
}

BestPlaces best_places(std::span<const SurfacePoint> points, const CorrelationMap& map,
                       std::span<const Point2> positions, const PlacesWanted& wanted) {
    constexpr int kMostOpened = 300000;
    constexpr double kApart = 2.0;      // [m]
    constexpr double kApartTurn = 0.5;  // [rad]
    if (points.empty() || positions.empty()) return {};
    Bounds bounds;
    for (const Point2& at : positions) bounds.hold(at);
    const Pose centre{0.5 * (bounds.low.x + bounds.high.x), 0.5 * (bounds.low.y + bounds.high.y),
                      0.0};
    const double half_m =
        0.5 * std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
    BestFirst search(points, map, centre, {half_m + wanted.within_m, kPi}, wanted.least_score,
                     positions, wanted.within_m);
    BestPlaces found;
    std::vector<Correlation>& places = found.places;
    const auto beside_one = [&](const Square& square) {
        const double half = 0.5 * ((1 << square.level) - 1);
        const Pose middle = search.pose(square, half);
        return std::ranges::any_of(places, [&](const Correlation& place) {
            return std::hypot(middle.x - place.pose.x, middle.y - place.pose.y) +
                           1.5 * half * CorrelationMap::kCell <
                       kApart &&
                   std::abs(wrap_angle(middle.theta - place.pose.theta)) < kApartTurn;
        });
    };
    double least = wanted.least_score;
    while (places.size() < wanted.most) {
        const auto place = search.next(kMostOpened, least, beside_one);
        if (!place) {
            found.all = !search.more(least);
            break;
        }
        places.push_back(*place);
        least = std::max(least, wanted.share * places.front().score);
    }
    return found;
}

}  // namespace hitos
