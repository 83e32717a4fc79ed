// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_map.hpp"

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>

namespace hitos {
namespace {

constexpr double kBucket = 0.3;  // [m]
constexpr double kPerM = 1.0 / kBucket;

/// The bucket that a coordinate lies in, -1 before the first of `count`, `count` behind the last.
int bucket(double offset, int count) {
    // Truncation rounds down where nothing is negative.
    return static_cast<int>(std::clamp(offset * kPerM + 1.0, 0.0, count + 1.0)) - 1;
}

}  // namespace

void PointMap::begin(const Point2& centre, double half_m) {
    centre_ = centre;
    half_m_ = half_m;
    added_.clear();
    bounds_ = {};
}

void PointMap::add(std::span<const SurfacePoint> points, const Pose& pose, std::uint32_t source) {
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    const double x0 = pose.x - centre_.x;
    const double y0 = pose.y - centre_.y;
    for (const SurfacePoint& p : points) {
        const auto x = static_cast<double>(p.x);
        const auto y = static_cast<double>(p.y);
        const double placed_x = x0 + c * x - s * y;
        const double placed_y = y0 + s * x + c * y;
        if (!(std::abs(placed_x) <= half_m_ && std::abs(placed_y) <= half_m_)) continue;
        const auto nx = static_cast<double>(p.nx);
        const auto ny = static_cast<double>(p.ny);
        MapPoint placed;
        placed.x = static_cast<float>(placed_x);
        placed.y = static_cast<float>(placed_y);
        placed.nx = static_cast<float>(c * nx - s * ny);
        placed.ny = static_cast<float>(s * nx + c * ny);
        placed.source = source;
        added_.push_back(placed);
        bounds_.hold({static_cast<double>(placed.x), static_cast<double>(placed.y)});
    }
}

void PointMap::build() {
    x0_ = bounds_.low.x;
    y0_ = bounds_.low.y;
    columns_ = static_cast<int>((bounds_.high.x - bounds_.low.x) * kPerM) + 1;
    rows_ = static_cast<int>((bounds_.high.y - bounds_.low.y) * kPerM) + 1;
    const auto buckets = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    starts_.assign(buckets + 2, 0);
    places_.resize(added_.size());
    for (std::size_t i = 0; i < added_.size(); ++i) {
        const auto column = static_cast<int>((static_cast<double>(added_[i].x) - x0_) * kPerM);
        const auto row = static_cast<int>((static_cast<double>(added_[i].y) - y0_) * kPerM);
        places_[i] = static_cast<std::uint32_t>(row * columns_ + column);
        ++starts_[places_[i] + 2];
    }
    // One place further than needed: filling moves each start on to where it belongs.
    for (std::size_t b = 2; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
    points_.resize(added_.size());
    xs_.resize(added_.size());
    ys_.resize(added_.size());
    for (std::size_t i = 0; i < added_.size(); ++i) {
        const std::uint32_t at = starts_[places_[i] + 1]++;
        points_[at] = added_[i];
        xs_[at] = added_[i].x;
        ys_[at] = added_[i].y;
    }
}

void PointMap::search_row(int row, int first_column, int last_column, float x, float y,
                          Nearest& best) const {
    const auto line = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    // The buckets of a row lie one after the other.
    const std::size_t begin = starts_[line + static_cast<std::size_t>(first_column)];
    const std::size_t end = starts_[line + static_cast<std::size_t>(last_column) + 1];
    const auto distance2 = [&](std::size_t i) {
        const float dx = xs_[i] - x;
        const float dy = ys_[i] - y;
        return dx * dx + dy * dy;
    };
    // The least first, four by four, then whose it is.
    float least = best.d2;
    std::size_t i = begin;
#if defined(__x86_64__)
    const __m128 x4 = _mm_set1_ps(x);
    const __m128 y4 = _mm_set1_ps(y);
    const auto four = [&](std::size_t first) {
        const __m128 dx = _mm_sub_ps(_mm_loadu_ps(xs_.data() + first), x4);
        const __m128 dy = _mm_sub_ps(_mm_loadu_ps(ys_.data() + first), y4);
        return _mm_add_ps(_mm_mul_ps(dx, dx), _mm_mul_ps(dy, dy));
    };
    __m128 least4 = _mm_set1_ps(least);
    for (; i + 4 <= end; i += 4) least4 = _mm_min_ps(four(i), least4);
    least4 = _mm_min_ps(least4, _mm_movehl_ps(least4, least4));
    least4 = _mm_min_ss(least4, _mm_shuffle_ps(least4, least4, 1));
    least = _mm_cvtss_f32(least4);
#endif
    for (; i < end; ++i) least = std::min(least, distance2(i));
    if (!(least < best.d2)) return;
    i = begin;
#if defined(__x86_64__)
    const __m128 sought = _mm_set1_ps(least);
    while (i + 4 <= end && _mm_movemask_ps(_mm_cmpeq_ps(four(i), sought)) == 0) i += 4;
#endif
    while (distance2(i) != least) ++i;
    best = {least, points_.data() + i};
}

const MapPoint* PointMap::nearest(double x, double y, double radius_m, double* distance2_m2) const {
    const double u = x - x0_;
    const double v = y - y0_;
    int first_column = std::max(bucket(u - radius_m, columns_), 0);
    int last_column = std::min(bucket(u + radius_m, columns_), columns_ - 1);
    const int first_row = std::max(bucket(v - radius_m, rows_), 0);
    const int last_row = std::min(bucket(v + radius_m, rows_), rows_ - 1);
    if (first_column > last_column || first_row > last_row) return nullptr;

    const auto fx = static_cast<float>(x);
    const auto fy = static_cast<float>(y);
    Nearest best{static_cast<float>(radius_m * radius_m), nullptr};
    // Columns that are further than what was found say nothing, but for rounding.
    const auto narrow = [&] {
        constexpr double kRounding = 1e-3;  // [m]
        if (best.point == nullptr) return;
        const double near = std::sqrt(static_cast<double>(best.d2)) + kRounding;
        first_column = std::max(first_column, bucket(u - near, columns_));
        last_column = std::min(last_column, bucket(u + near, columns_));
    };
    // From the middle bucket and row out, as long as rows are nearer than what was found. Of points
    // as near the first one in the middle row is taken, whatever the order of looking.
    const int middle = std::clamp(bucket(v, rows_), first_row, last_row);
    const int column = std::clamp(bucket(u, columns_), first_column, last_column);
    search_row(middle, column, column, fx, fy, best);
    narrow();
    if (first_column < column) {
        Nearest left = best;
        if (best.point != nullptr)
            left.d2 = std::nextafter(best.d2, std::numeric_limits<float>::infinity());
        left.point = nullptr;
        search_row(middle, first_column, column - 1, fx, fy, left);
        if (left.point != nullptr) best = left;
    }
    if (column < last_column) search_row(middle, column + 1, last_column, fx, fy, best);
    narrow();
    for (int row = middle + 1; row <= last_row; ++row) {
        const double gap = row * kBucket - v;
        if (gap > 0.0 && gap * gap > static_cast<double>(best.d2)) break;
        search_row(row, first_column, last_column, fx, fy, best);
    }
    for (int row = middle - 1; row >= first_row; --row) {
        const double gap = v - (row + 1) * kBucket;
        if (gap > 0.0 && gap * gap > static_cast<double>(best.d2)) break;
        search_row(row, first_column, last_column, fx, fy, best);
    }
    if (best.point != nullptr && distance2_m2 != nullptr) {
        *distance2_m2 = static_cast<double>(best.d2);
    }
    return best.point;
}

}  // namespace hitos
