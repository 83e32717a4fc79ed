// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmarks of a map are near what was observed: a tree of bounds, shared by maps until
// written (boxes that bound boxes: Guttman, 1984, "R-trees").
#pragma once

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "lanes.hpp"
#include "shared_pool.hpp"

namespace hitos {

/// Where the index has a landmark: a point of the plane, what its estimate is spread by, and how
/// far the point may shift before it is entered again [m].
struct IndexPoint {
    double u;
    double v;
    double spread0;
    double spread1;
    double shift;
};

/// Where the points lie of all landmarks that an observation may be of: within `radius` of (u, v)
/// [m], and by_spread0 spread0 + by_spread1 spread1 farther.
struct NearRegion {
    double u;
    double v;
    double radius;
    double by_spread0;
    double by_spread1;
};

/// How far from what is expected an observation can be: Mahalanobis distances, and these times the
/// standard deviations of its components.
struct NearReach {
    double distance;
    double z0;
    double z1;

    static NearReach of(const NearQuery& seen) {
        // Of an R without a determinant there is no end of it; what is that times nothing is 0.
        const double distance = std::sqrt(std::max(std::min(seen.slack, 1e30), 0.0));
        return {distance, distance * std::sqrt(std::max(seen.r00, 0.0)),
                distance * std::sqrt(std::max(seen.r11, 0.0))};
    }
};

/// What stands at a place of the index: a landmark with the box that its point stays in, or a node
/// with the box of all its points.
struct IndexEntry {
    alignas(16) std::array<float, 4> low;  ///< least u and v [m], and the greatest, negative
    float spread0 = 0.0F;                  ///< the greatest of the landmarks
    float spread1 = 0.0F;
    std::uint32_t id = 0;

    static IndexEntry of(std::uint32_t landmark, const IndexPoint& point) {
        constexpr float kAnywhere = std::numeric_limits<float>::infinity();
        const auto outwards = [](double least) {
            return std::isfinite(least) ? static_cast<float>(least) : -kAnywhere;
        };
        // No number is spread without end; what is that times nothing is a number.
        constexpr double kEndless = 1e30;
        const auto spread = [](double of) {
            return static_cast<float>(of < kEndless ? of : kEndless);
        };
        return {{outwards(point.u - point.shift), outwards(point.v - point.shift),
                 outwards(-point.u - point.shift), outwards(-point.v - point.shift)},
                spread(point.spread0),
                spread(point.spread1),
                landmark};
    }
    void join(const IndexEntry& other) {
        for (std::size_t i = 0; i < low.size(); ++i) low[i] = std::min(low[i], other.low[i]);
        spread0 = std::max(spread0, other.spread0);
        spread1 = std::max(spread1, other.spread1);
    }
    float half_girth() const { return -((low[0] + low[2]) + (low[1] + low[3])); }
};

/// Where to look: a box, wider by a multiple of what landmarks are spread.
struct IndexRegion {
    alignas(16) std::array<float, 4> high;  ///< greatest u and v [m], and the least, negative
    float by_spread0 = 0.0F;
    float by_spread1 = 0.0F;

    static IndexRegion nowhere() {
        constexpr float kNever = -std::numeric_limits<float>::infinity();
        return {{kNever, kNever, kNever, kNever}};
    }
    static IndexRegion of(const NearRegion& region) {
        // What float loses of places is far below this share of them.
        const double rounding = 1e-6 * (std::abs(region.u) + std::abs(region.v)) + 0.01;
        const auto reach = static_cast<float>(region.radius + rounding);
        const auto u = static_cast<float>(region.u);
        const auto v = static_cast<float>(region.v);
        return {{u + reach, v + reach, reach - u, reach - v},
                static_cast<float>(region.by_spread0),
                static_cast<float>(region.by_spread1)};
    }
    bool endless() const { return high[0] == std::numeric_limits<float>::infinity(); }
    /// Both and what lies between.
    void join(const IndexRegion& other) {
        for (std::size_t i = 0; i < high.size(); ++i) high[i] = std::max(high[i], other.high[i]);
        by_spread0 = std::max(by_spread0, other.by_spread0);
        by_spread1 = std::max(by_spread1, other.by_spread1);
    }
    bool meets(const IndexEntry& entry) const {
        const float reach = by_spread0 * entry.spread0 + by_spread1 * entry.spread1;
#if defined(__x86_64__)
        const __m128 least = _mm_sub_ps(_mm_load_ps(entry.low.data()), _mm_set1_ps(reach));
        return _mm_movemask_ps(_mm_cmple_ps(least, _mm_load_ps(high.data()))) == 15;
#else
        bool all = true;
        for (std::size_t i = 0; i < 4; ++i) all = all && entry.low[i] - reach <= high[i];
        return all;
#endif
    }
};

struct IndexNode {
    static constexpr std::size_t kMost = 16;
    std::uint32_t level = 0;  ///< 0: its entries are landmarks
    std::uint32_t count = 0;
    std::array<IndexEntry, kMost> entries;
};

/// The index of one map, which `root` stands for. One without a root knows nothing.
class LandmarkIndex {
  public:
    using Pool = SharedPool<IndexNode>;
    using Id = Pool::Id;
    static constexpr Id kNone = UINT32_MAX;

    LandmarkIndex(Pool& pool, Id& root, PoolCache& cache)
        : pool_(pool), root_(root), cache_(cache) {}

    /// A landmark may be entered more than once: it is in one of its boxes.
    void insert(const IndexEntry& entry) {
        if (root_ == kNone) root_ = fresh(0);
        const Id sibling = insert(root_, entry);
        if (sibling == kNone) return;
        const Id top = fresh(pool_[root_].level + 1);
        IndexNode& node = pool_[top];
        node.entries[0] = bounds(root_);
        node.entries[1] = bounds(sibling);
        node.count = 2;
        root_ = top;
    }
    /// Landmarks have other numbers, or are gone where that is `gone`. Returns how many entries are
    /// left.
    std::uint32_t renumber(std::span<const std::uint32_t> places, std::uint32_t gone) {
        if (root_ == kNone) return 0;
        if (changes(pool_[root_], places)) renumber(root_, places, gone);
        const std::uint32_t left = entries_of(pool_[root_]);
        if (left == 0) clear();
        return left;
    }
    /// Calls body(IndexEntry) for all landmarks whose boxes the region meets, in no order.
    template <class Body>
    void each_in(const IndexRegion& region, const Body& body) const {
        if (root_ != kNone) each_in(pool_[root_], region, body);
    }
    void clear() {
        if (root_ != kNone) drop(std::exchange(root_, kNone));
    }

  private:
    Id fresh(std::uint32_t level) {
        const Id id = pool_.take(cache_);
        pool_[id].level = level;
        pool_[id].count = 0;
        return id;
    }
    IndexNode& own(Id& id) {
        if (!pool_.shared(id, cache_)) return pool_[id];
        const Id copy = pool_.take(cache_);
        const IndexNode& from = pool_[id];
        IndexNode& node = pool_[copy];
        node.level = from.level;
        node.count = from.count;
        std::copy_n(from.entries.begin(), from.count, node.entries.begin());
        if (node.level > 0) {
            for (std::size_t i = 0; i < node.count; ++i) pool_.share(node.entries[i].id, cache_);
        }
        drop(std::exchange(id, copy));
        return node;
    }
    /// Whether any landmark below has another number.
    bool changes(const IndexNode& node, std::span<const std::uint32_t> places) const {
        return std::any_of(node.entries.begin(), node.entries.begin() + node.count,
                           [&](const IndexEntry& entry) {
                               return node.level == 0 ? places[entry.id] != entry.id
                                                      : changes(pool_[entry.id], places);
                           });
    }
    std::uint32_t entries_of(const IndexNode& node) const {
        if (node.level == 0) return node.count;
        std::uint32_t sum = 0;
        for (std::size_t i = 0; i < node.count; ++i) sum += entries_of(pool_[node.entries[i].id]);
        return sum;
    }
    /// Of a node in which something changes.
    void renumber(Id& at, std::span<const std::uint32_t> places, std::uint32_t gone) {
        IndexNode& node = own(at);
        std::uint32_t left = 0;
        for (std::size_t i = 0; i < node.count; ++i) {
            IndexEntry entry = node.entries[i];
            if (node.level == 0) {
                entry.id = places[entry.id];
                if (entry.id == gone) continue;
            } else if (changes(pool_[entry.id], places)) {
                renumber(node.entries[i].id, places, gone);
                if (pool_[node.entries[i].id].count == 0) {
                    drop(node.entries[i].id);
                    continue;
                }
                entry = bounds(node.entries[i].id);
            }
            node.entries[left++] = entry;
        }
        node.count = left;
    }
    void drop(Id id) {
        if (!pool_.let_go(id, cache_)) return;
        const IndexNode& node = pool_[id];
        if (node.level > 0) {
            for (std::size_t i = 0; i < node.count; ++i) drop(node.entries[i].id);
        }
        pool_.put_back(id, cache_);
    }
    IndexEntry bounds(Id id) const {
        const IndexNode& node = pool_[id];
        IndexEntry all = node.entries[0];
        for (std::size_t i = 1; i < node.count; ++i) all.join(node.entries[i]);
        all.id = id;
        return all;
    }
    /// What had to go into a node of its own, kNone where nothing.
    Id insert(Id& at, const IndexEntry& entry) {
        IndexNode& node = own(at);
        if (node.level == 0) return add(node, entry);
        IndexEntry& nearest = node.entries[place_for(entry, node)];
        const Id sibling = insert(nearest.id, entry);
        if (sibling == kNone) {
            nearest.join(entry);
            return kNone;
        }
        nearest = bounds(nearest.id);
        try {
            return add(node, bounds(sibling));
        } catch (...) {
            drop(sibling);
            throw;
        }
    }
    /// The entry whose box grows least, the smaller one of two.
    static std::size_t place_for(const IndexEntry& entry, const IndexNode& node) {
        std::size_t best = 0;
        std::pair<float, float> least{std::numeric_limits<float>::infinity(), 0.0F};
        for (std::size_t i = 0; i < node.count; ++i) {
            IndexEntry joined = node.entries[i];
            joined.join(entry);
            const float before = node.entries[i].half_girth();
            const std::pair growth{joined.half_girth() - before, before};
            if (growth < least) {
                least = growth;
                best = i;
            }
        }
        return best;
    }
    Id add(IndexNode& node, const IndexEntry& entry) {
        if (node.count < IndexNode::kMost) {
            node.entries[node.count++] = entry;
            return kNone;
        }
        const Id other = fresh(node.level);  // chunks do not move: `node` stays
        std::array<IndexEntry, IndexNode::kMost + 1> all;
        std::copy_n(node.entries.begin(), IndexNode::kMost, all.begin());
        all.back() = entry;
        // In the middle of the direction in which they reach farther.
        IndexEntry whole = entry;
        for (const IndexEntry& one : all) whole.join(one);
        const std::size_t axis = whole.low[0] + whole.low[2] <= whole.low[1] + whole.low[3] ? 0 : 1;
        std::ranges::sort(all, {}, [&](const IndexEntry& one) {
            const float middle = one.low[axis] - one.low[axis + 2];
            return std::pair(std::isnan(middle) ? 0.0F : middle, one.id);
        });
        constexpr std::size_t kHalf = all.size() / 2;
        IndexNode& right = pool_[other];
        std::copy_n(all.begin(), kHalf, node.entries.begin());
        std::copy(all.begin() + kHalf, all.end(), right.entries.begin());
        node.count = kHalf;
        right.count = static_cast<std::uint32_t>(all.size() - kHalf);
        return other;
    }
    template <class Body>
    void each_in(const IndexNode& node, const IndexRegion& region, const Body& body) const {
        for (std::size_t i = 0; i < node.count; ++i) {
            const IndexEntry& entry = node.entries[i];
            if (!region.meets(entry)) continue;
            if (node.level == 0) {
                body(entry);
            } else {
                each_in(pool_[entry.id], region, body);
            }
        }
    }

    Pool& pool_;
    Id& root_;
    PoolCache& cache_;
};

}  // namespace hitos
