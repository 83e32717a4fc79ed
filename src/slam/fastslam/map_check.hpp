// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the maps of all particles are sound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "models/map_store.hpp"
#include "models/sound.hpp"

namespace hitos {

/// The landmarks of one kind in all maps, with the stocks of all who write them: every leaf, page
/// and node of an index counts those that hold it, is free or held and not both; maps have the
/// leaves that their landmarks need; boxes of an index hold what is below them, and each landmark
/// lies in one that names it.
template <Sensor S>
class MapCheck {
  public:
    using Caches = typename LandmarkTable<S>::Caches;

    MapCheck(LandmarkTable<S>& table, std::span<Caches* const> caches)
        : table_(table),
          caches_(caches),
          leaves_(table.pools.leaves.size(), 0),
          pages_(table.pools.pages.size(), 0),
          nodes_(table.pools.nodes.size(), 0) {}

    /// Throws std::logic_error of what is not so.
    void run() {
        for (map_ = 0; map_ < table_.rows.size(); ++map_) {
            check_leaves();
            check_index();
        }
        check_pool(table_.pools.leaves, leaves_, &Caches::leaves, "leaf");
        check_pool(table_.pools.pages, pages_, &Caches::pages, "page");
        check_pool(table_.pools.nodes, nodes_, &Caches::nodes, "node");
    }

  private:
    using Counts = std::vector<std::uint32_t>;

    /// One more holds it. True for the first, who tells what it holds itself.
    bool hold(Counts& counts, std::uint32_t id, const char* kind) const {
        expect_sound(id < counts.size(), "map {} has {} {} of {}", map_, kind, id, counts.size());
        return ++counts[id] == 1;
    }
    void check_leaves() {
        const LandmarkRow& row = table_.rows[map_];
        const std::size_t own = row.own_leaves();
        for (std::size_t i = 0; i < own; ++i) hold(leaves_, row.leaves[i], "leaf");
        std::size_t behind = row.leaf_count() - own;
        for (const std::uint32_t id : table_.pages[map_]) {
            const bool first = hold(pages_, id, "page");
            const LeafPage& page = table_.pools.pages[id];
            const std::size_t wanted = std::min(behind, LeafPage::kLeaves);
            expect_sound(page.count == wanted && wanted > 0,
                         "map {}: page {} has {} leaves where {} are needed", map_, id, page.count,
                         wanted);
            behind -= wanted;
            for (std::size_t i = 0; first && i < wanted; ++i) hold(leaves_, page.leaves[i], "leaf");
        }
        expect_sound(behind == 0, "map {} of {} landmarks lacks {} leaves", map_, row.size, behind);
    }
    void check_index() {
        const LandmarkRow& row = table_.rows[map_];
        std::uint32_t entries = 0;
        if (row.index != LandmarkIndex::kNone) {
            found_.assign(row.size, false);
            const bool first = hold(nodes_, row.index, "node");
            entries = check_node(row.index, table_.pools.nodes[row.index].level, first);
            const auto lost = std::ranges::find(found_, false) - found_.begin();
            expect_sound(lost == row.size, "map {}: the index does not have landmark {}", map_,
                         lost);
        }
        expect_sound(entries == row.entries, "map {}: the index has {} entries, and counts {}",
                     map_, entries, row.entries);
    }
    /// Landmarks below it. `first`: of all that hold it.
    std::uint32_t check_node(std::uint32_t id, std::uint32_t level, bool first) {
        const IndexNode& node = table_.pools.nodes[id];
        expect_sound(node.level == level && node.count > 0 && node.count <= IndexNode::kMost,
                     "map {}: node {} has level {} where {} belongs, and {} entries", map_, id,
                     node.level, level, node.count);
        if (level == 0) {
            for (std::size_t i = 0; i < node.count; ++i) check_entry(node.entries[i]);
            return node.count;
        }
        std::uint32_t entries = 0;
        for (std::size_t i = 0; i < node.count; ++i) {
            const IndexEntry& entry = node.entries[i];
            expect_sound(entry.id < nodes_.size(), "map {}: node {} has node {} of {}", map_, id,
                         entry.id, nodes_.size());
            const bool first_below = first && hold(nodes_, entry.id, "node");
            entries += check_node(entry.id, level - 1, first_below);
            const IndexNode& below = table_.pools.nodes[entry.id];
            const bool holds_all =
                std::all_of(below.entries.begin(), below.entries.begin() + below.count,
                            [&](const IndexEntry& inner) { return holds(entry, inner, 0.0F); });
            expect_sound(holds_all, "map {}: the box of node {} does not hold all in it", map_,
                         entry.id);
        }
        return entries;
    }
    void check_entry(const IndexEntry& entry) {
        expect_sound(entry.id < found_.size(), "map {}: the index has landmark {} of {}", map_,
                     entry.id, found_.size());
        const typename S::Columns landmarks(table_.pools, table_.rows[map_], table_.pages[map_],
                                            *caches_.front());
        IndexPoint point = S::index_point(landmarks.lane(entry.id));
        point.shift = 0.0;
        constexpr float kRounding = 1e-5F;
        if (holds(entry, IndexEntry::of(entry.id, point), kRounding)) found_[entry.id] = true;
    }
    static bool holds(const IndexEntry& box, const IndexEntry& inner, float rounding) {
        for (std::size_t i = 0; i < box.low.size(); ++i) {
            const float least = inner.low[i];
            const float lost = std::isfinite(least) ? rounding * (1.0F + std::abs(least)) : 0.0F;
            if (box.low[i] > least + lost) return false;
        }
        return inner.spread0 <= box.spread0 * (1.0F + rounding) &&
               inner.spread1 <= box.spread1 * (1.0F + rounding);
    }
    template <class T>
    void check_pool(const SharedPool<T>& pool, const Counts& counts, PoolCache Caches::*stock,
                    const char* kind) const {
        std::vector<std::uint32_t> free = pool.free();
        for (const Caches* const caches : caches_) {
            free.insert(free.end(), (caches->*stock).free.begin(), (caches->*stock).free.end());
        }
        std::vector<int> times_free(counts.size(), 0);
        for (const std::uint32_t id : free) ++times_free.at(id);
        for (std::uint32_t id = 0; id < counts.size(); ++id) {
            expect_sound(counts[id] == pool.holders(id),
                         "maps: {} {} is held {} times, and counts {}", kind, id, counts[id],
                         pool.holders(id));
            expect_sound(times_free[id] == (counts[id] == 0 ? 1 : 0),
                         "maps: {} {} is held {} times, and free {} times", kind, id, counts[id],
                         times_free[id]);
        }
    }

    LandmarkTable<S>& table_;
    std::span<Caches* const> caches_;
    Counts leaves_, pages_, nodes_;  // how many hold each
    std::size_t map_ = 0;            // that is looked at
    std::vector<bool> found_;        // landmarks that its index has where they are
};

}  // namespace hitos
