// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlation.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace hitos {
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

/// A square of positions at one angle, counted from the window's first ones, with the bound of its
/// score; one number, by which a heap is ordered quickest.
class Square {
  public:
    static constexpr int kPlaceBits = 13;
    static constexpr int kAngleBits = 10;
    static constexpr int kLevelBits = 3;
    static constexpr int kSumBits = 64 - kLevelBits - kAngleBits - 2 * kPlaceBits;

    Square(int sum, int level, int angle, int x, int y) : number_(static_cast<std::uint64_t>(sum)) {
        put(level, kLevelBits);
        put(angle, kAngleBits);
        put(x, kPlaceBits);
        put(y, kPlaceBits);
    }
    int sum() const { return static_cast<int>(number_ >> (64 - kSumBits)); }
    int level() const { return part(kAngleBits + 2 * kPlaceBits, kLevelBits); }
    int angle() const { return part(2 * kPlaceBits, kAngleBits); }
    int x() const { return part(kPlaceBits, kPlaceBits); }
    int y() const { return part(0, kPlaceBits); }

    /// By sum; of equal ones finer squares are the greater, then those of lower place, so that the
    /// order never depends on how a heap is built.
    friend bool operator<(Square a, Square b) { return a.number_ < b.number_; }

  private:
    static constexpr std::uint64_t ones(int bits) { return (std::uint64_t{1} << bits) - 1; }
    void put(int value, int bits) {
        number_ = (number_ << bits) | (ones(bits) - static_cast<std::uint64_t>(value));
    }
    int part(int shift, int bits) const {
        return static_cast<int>(ones(bits) - ((number_ >> shift) & ones(bits)));
    }

    std::uint64_t number_;
};

/// Squares whose sums only fall: what is put in has no greater sum than what was taken out last.
/// Quicker than one heap, which in a wide window has no room in the cache.
class FallingSquares {
  public:
    /// Of sums up to `most`.
    explicit FallingSquares(int most) {
        constexpr int kHeaps = 1 << 8;
        while (most >> shift_ >= kHeaps) ++shift_;
        heaps_.resize(static_cast<std::size_t>(most >> shift_) + 1);
    }

    void push(const Square& square) {
        const auto place = static_cast<std::size_t>(square.sum() >> shift_);
        assert(place < heaps_.size());
        heaps_[place].push_back(square);
        if (place + 1 == heaps_.size()) std::push_heap(heaps_.back().begin(), heaps_.back().end());
    }
    /// The greatest; null where there is none.
    const Square* top() {
        if (heaps_.empty()) return nullptr;
        while (heaps_.back().empty()) {
            heaps_.pop_back();
            if (heaps_.empty()) return nullptr;
            std::make_heap(heaps_.back().begin(), heaps_.back().end());
        }
        return heaps_.back().data();
    }
    /// Of what is not empty.
    void pop() {
        std::pop_heap(heaps_.back().begin(), heaps_.back().end());
        heaps_.back().pop_back();
    }

  private:
    int shift_ = 0;
    std::vector<std::vector<Square>> heaps_;  // by sum; all but the last one are in no order
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
          mask_(centre, reach_, map.levels(), positions, within_m),
          open_(CorrelationMap::kMost * static_cast<int>(points.size())) {
        double far = 1.0;
        for (const SurfacePoint& p : points) {
            far = std::max(far, std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)));
        }
        // The furthest points that matter move about a cell from angle to angle.
        angle_step_ = std::clamp(1.2 * CorrelationMap::kCell / std::min(far, 10.0), 0.012, 0.03);
        angles_ = static_cast<int>(std::ceil(window.heading_rad / angle_step_));
        least_ = static_cast<int>(least_score * CorrelationMap::kMost * count_);
        assert(2 * reach_ < 1 << Square::kPlaceBits && 2 * angles_ < 1 << Square::kAngleBits &&
               map.levels() < 1 << Square::kLevelBits &&
               points.size() < (std::size_t{1} << Square::kSumBits) / CorrelationMap::kMost);
        turn(points);
    }

    /// Puts all squares of the coarsest level, one by one.
    void begin() {
        const int width = 1 << map_.levels();
        for (int x = 0; x <= 2 * reach_; x += width) {
            for (int y = 0; y <= 2 * reach_; y += width) {
                for (int angle = 0; angle <= 2 * angles_; ++angle) {
                    const int sum =
                        map_.sum(turned(angle), x - reach_, y - reach_, map_.levels(), least_);
                    if (sum >= least_) open_.push({sum, map_.levels(), angle, x, y});
                }
            }
        }
    }
    /// The same of those that the mask holds, some at a time.
    void begin(const SquareLattice& lattice) {
        const int level = map_.levels();
        const int last = (2 * reach_) >> level;
        constexpr int kAcross = SquareLattice::kAcross;
        for (int j = 0; j <= last; ++j) {
            for (int first = 0; first <= last; first += kAcross) {
                std::vector<int> held;  // of these, counted from the first
                for (int i = first; i <= std::min(last, first + kAcross - 1); ++i) {
                    if (mask_.holds(i << level, j << level, level)) held.push_back(i - first);
                }
                if (!held.empty()) put(lattice, first << level, j << level, held);
            }
        }
    }

    /// The next single place whose score is `least` at least, after at most `most` squares opened
    /// in all; squares of which `passed` is true are left out.
    template <class Passed>
    std::optional<Correlation> next(int most, double least, const Passed& passed) {
        for (; open_.top() != nullptr && opened_ < most; ++opened_) {
            const Square best = *open_.top();
            if (score(best) < least) break;
            open_.pop();
            if (passed(best)) continue;
            if (best.level() == 0) return Correlation{pose(best, 0.0), score(best)};
            open(best);
        }
        return std::nullopt;
    }

    /// Whether there may be further places of such a score.
    bool more(double least) { return open_.top() != nullptr && score(*open_.top()) >= least; }
    /// Of a place of a square, `cells` from its corner.
    Pose pose(const Square& square, double cells) const {
        return {centre_.x + (square.x() - reach_ + cells) * CorrelationMap::kCell,
                centre_.y + (square.y() - reach_ + cells) * CorrelationMap::kCell,
                wrap_angle(centre_.theta + (square.angle() - angles_) * angle_step_)};
    }

  private:
    double score(const Square& square) const {
        return square.sum() / (CorrelationMap::kMost * count_);
    }

    void turn(std::span<const SurfacePoint> points) {
        turned_.reserve(2 * static_cast<std::size_t>(angles_) + 1);
        for (int angle = -angles_; angle <= angles_; ++angle) {
            const double c = std::cos(centre_.theta + angle * angle_step_);
            const double s = std::sin(centre_.theta + angle * angle_step_);
            std::vector<CorrelationMap::Cell> cells;
            cells.reserve(points.size());
            for (const SurfacePoint& p : points) {
                const auto x = static_cast<double>(p.x);
                const auto y = static_cast<double>(p.y);
                cells.push_back(map_.cell(centre_.x + c * x - s * y, centre_.y + s * x + c * y));
            }
            turned_.emplace_back(std::move(cells));
        }
    }
    const CorrelationMap::Pattern& turned(int angle) const {
        return turned_[static_cast<std::size_t>(angle)];
    }
    void put(const SquareLattice& lattice, int x, int y, const std::vector<int>& held) {
        const int level = map_.levels();
        for (int angle = 0; angle <= 2 * angles_; ++angle) {
            const SquareLattice::Sums bounds =
                lattice.bounds(turned(angle), x - reach_, y - reach_);
            for (const int i : held) {
                const int bound = bounds[static_cast<std::size_t>(i)];
                if (bound >= least_) open_.push({bound, level, angle, x + (i << level), y});
            }
        }
    }
    /// Puts its quarters in its place.
    void open(const Square& square) {
        const int level = square.level() - 1;
        const std::array<int, 4> sums = map_.quarters(turned(square.angle()), square.x() - reach_,
                                                      square.y() - reach_, level, least_);
        for (int i = 0; i < 4; ++i) {
            const int x = square.x() + ((i >> 1) << level);
            const int y = square.y() + ((i & 1) << level);
            const int sum = sums[static_cast<std::size_t>(i)];
            // Squares at the window's edge reach beyond it.
            if (sum < least_ || x > 2 * reach_ || y > 2 * reach_ || !mask_.holds(x, y, level))
                continue;
            open_.push({sum, level, square.angle(), x, y});
        }
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
    std::vector<CorrelationMap::Pattern> turned_;
    FallingSquares open_;
};

}  // namespace

std::optional<Correlation> correlate(std::span<const SurfacePoint> points,
                                     const CorrelationMap& map, const Pose& centre,
                                     const SearchWindow& window, double least_score) {
    constexpr int kMostOpened = 20000;
    if (points.empty()) return std::nullopt;
    BestFirst search(points, map, centre, window, least_score);
    search.begin();
    return search.next(kMostOpened, least_score, [](const Square&) { return false; });
}

BestPlaces best_places(std::span<const SurfacePoint> points, const CorrelationMap& map,
                       const SquareLattice& lattice, std::span<const Point2> positions,
                       const PlacesWanted& wanted) {
    constexpr int kMostOpened = 200000;
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
    search.begin(lattice);
    BestPlaces found;
    std::vector<Correlation>& places = found.places;
    const auto beside_one = [&](const Square& square) {
        const double half = 0.5 * ((1 << square.level()) - 1);
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
