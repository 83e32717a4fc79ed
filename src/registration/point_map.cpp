// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_map.hpp"

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace hitos {
namespace {

// Places and normals two by two, as the processor has them: the same operations in the same order
// as one by one.
using TwoFloats = float __attribute__((vector_size(8)));
using FourFloats = float __attribute__((vector_size(16)));
using TwoInts = int __attribute__((vector_size(8)));
using Two = double __attribute__((vector_size(16)));

constexpr double kBucket = 0.3;  // [m]
constexpr double kPerM = 1.0 / kBucket;

/// The bucket that a coordinate lies in, -1 before the first of `count`, `count` behind the last.
int bucket(double offset, int count) {
    // Truncation rounds down where nothing is negative.
    return static_cast<int>(std::clamp(offset * kPerM + 1.0, 0.0, count + 1.0)) - 1;
}

}  // namespace

void PointMap::begin(const Point2& centre, double half_m) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    centre_ = centre;
    half_m_ = half_m;
    added_.clear();
    low_ = {kFar, kFar};
    high_ = {-kFar, -kFar};
}

void PointMap::add(std::span<const SurfacePoint> points, const Pose& pose, std::uint32_t source) {
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    const Two from_x{c, s};  // of what lies along x, and along y
    const Two from_y{-s, c};
    const Two at{pose.x - centre_.x, pose.y - centre_.y};
    // Every point is put behind the ones that are in, and stays there where it is in too.
    std::size_t end = added_.size();
    added_.resize(end + points.size());
    FourFloats low{low_.x, low_.y};
    FourFloats high{high_.x, high_.y};
    for (const SurfacePoint& p : points) {
        const Two placed =
            at + from_x * static_cast<double>(p.x) + from_y * static_cast<double>(p.y);
        const Two normal = from_x * static_cast<double>(p.nx) + from_y * static_cast<double>(p.ny);
        const TwoFloats place = __builtin_convertvector(placed, TwoFloats);
        const TwoFloats facing = __builtin_convertvector(normal, TwoFloats);
        const FourFloats all{place[0], place[1], facing[0], facing[1]};
        static_cast<SurfacePoint&>(added_[end]) = std::bit_cast<SurfacePoint>(all);
        added_[end].source = source;
        if (!(std::abs(placed[0]) <= half_m_ && std::abs(placed[1]) <= half_m_)) continue;
        ++end;
        low = all < low ? all : low;
        high = all > high ? all : high;
    }
    added_.resize(end);
    low_ = {low[0], low[1]};
    high_ = {high[0], high[1]};
}

void PointMap::build() {
    if (added_.empty()) low_ = high_ = {0.0F, 0.0F};
    x0_ = static_cast<double>(low_.x);
    y0_ = static_cast<double>(low_.y);
    columns_ = static_cast<int>((static_cast<double>(high_.x) - x0_) * kPerM) + 1;
    rows_ = static_cast<int>((static_cast<double>(high_.y) - y0_) * kPerM) + 1;
    const auto buckets = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    starts_.assign(buckets + 1, 0);
    places_.resize(added_.size());
    const Two corner{x0_, y0_};
    for (std::size_t i = 0; i < added_.size(); ++i) {
        const Two from_corner =
            Two{static_cast<double>(added_[i].x), static_cast<double>(added_[i].y)} - corner;
        const TwoInts at = __builtin_convertvector(from_corner * kPerM, TwoInts);
        const auto bucket = static_cast<std::uint32_t>(at[1] * columns_ + at[0]);
        places_[i] = {bucket, starts_[bucket]++};
    }
    std::exclusive_scan(starts_.begin(), starts_.end(), starts_.begin(), std::uint32_t{0});
    order_.resize(added_.size());
    xs_.resize(added_.size());
    ys_.resize(added_.size());
    for (std::size_t i = 0; i < added_.size(); ++i) {
        const std::uint32_t at = starts_[places_[i].bucket] + places_[i].in_bucket;
        order_[at] = static_cast<std::uint32_t>(i);
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
    best = {least, &point(i)};
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
