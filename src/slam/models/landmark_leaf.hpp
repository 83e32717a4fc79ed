// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks in leaves of eight, shared by maps until written.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "landmark_index.hpp"
#include "sensor.hpp"
#include "shared_pool.hpp"

namespace hitos {

/// Eight landmarks of one kind: a column of doubles for each quantity, which is one vector register
/// of the widest sort.
template <std::size_t kColumns>
struct LandmarkLeaf {
    static constexpr std::size_t kLandmarks = 8;

    alignas(64) std::array<double, kColumns * kLandmarks> values;
    std::array<LandmarkRecord, kLandmarks> records;
    /// Where they stood when they were entered into the index, and how far from there they may be
    /// without being entered again; of maps that have one.
    struct Entered {
        float u = 0.0F;
        float v = 0.0F;
        float shift = 0.0F;
    };
    std::array<Entered, kLandmarks> entered;

    double* column(std::size_t index) { return values.data() + index * kLandmarks; }
    const double* column(std::size_t index) const { return values.data() + index * kLandmarks; }
};

/// Leaves in groups, so that long maps share lists of leaves too.
struct LeafPage {
    static constexpr std::size_t kLeaves = 16;
    std::array<std::uint32_t, kLeaves> leaves;
    std::uint32_t count = 0;
};

/// The landmarks of one kind in one map: the first leaves that they stand in, further ones in
/// pages, and what finds those that are near.
struct alignas(64) LandmarkRow {
    static constexpr std::size_t kOwn = 13;  // which makes it one line of the cache

    std::uint32_t size = 0;  ///< landmarks
    std::uint32_t index = LandmarkIndex::kNone;
    std::uint32_t entries = 0;  ///< of the index
    std::array<std::uint32_t, kOwn> leaves;

    std::size_t leaf_count() const { return (size + 7) / 8; }
    std::size_t own_leaves() const { return std::min(leaf_count(), kOwn); }
};
static_assert(sizeof(LandmarkRow) == 64);

/// What the maps' rows of one kind are made of.
template <std::size_t kColumns>
struct LandmarkPools {
    using Leaf = LandmarkLeaf<kColumns>;
    /// What a worker needs to write.
    struct Caches {
        PoolCache leaves;
        PoolCache pages;
        PoolCache nodes;

        void alone(bool whether) {
            for (PoolCache* cache : {&leaves, &pages, &nodes}) cache->alone = whether;
        }
    };

    SharedPool<Leaf> leaves;
    SharedPool<LeafPage> pages;
    SharedPool<IndexNode> nodes;
    std::size_t columns = kColumns;  ///< that are in use: what is behind them is not copied

    std::size_t bytes() const { return leaves.bytes() + pages.bytes() + nodes.bytes(); }
    /// Becomes a copy of what maps hold of the other's; `rows` and their `behind`, the pages, are
    /// made to name it.
    void assign_held(const LandmarkPools& other, std::span<LandmarkRow> rows,
                     std::span<std::vector<std::uint32_t>> behind) {
        columns = other.columns;
        const std::vector<std::uint32_t> leaf = leaves.assign_held(other.leaves);
        const std::vector<std::uint32_t> page = pages.assign_held(other.pages);
        const std::vector<std::uint32_t> node = nodes.assign_held(other.nodes);
        const auto rename = [](std::span<std::uint32_t> ids, std::span<const std::uint32_t> now) {
            for (std::uint32_t& id : ids) id = now[id];
        };
        for (LandmarkRow& row : rows) {
            rename(std::span(row.leaves).first(row.own_leaves()), leaf);
            if (row.index != LandmarkIndex::kNone) row.index = node[row.index];
        }
        for (std::vector<std::uint32_t>& ids : behind) rename(ids, page);
        for (std::uint32_t id = 0; id < pages.size(); ++id)
            rename(std::span(pages[id].leaves).first(pages[id].count), leaf);
        for (std::uint32_t id = 0; id < nodes.size(); ++id) {
            if (nodes[id].level == 0) continue;  // its entries are landmarks
            for (std::size_t i = 0; i < nodes[id].count; ++i)
                nodes[id].entries[i].id = node[nodes[id].entries[i].id];
        }
    }
};

/// A row with the pages behind its own leaves.
template <std::size_t kColumns>
class LeafList {
  public:
    using Pools = LandmarkPools<kColumns>;
    using Caches = typename Pools::Caches;
    using Leaf = typename Pools::Leaf;
    using Pages = std::vector<std::uint32_t>;

    LeafList(Pools& pools, LandmarkRow& row, Pages& pages, Caches& caches)
        : pools_(&pools), row_(&row), pages_(&pages), caches_(&caches) {}

    const Leaf& leaf(std::size_t place) const { return pools_->leaves[id(place)]; }
    /// The leaf, to write: of this list alone, or a copy that is.
    Leaf& own(std::size_t place) {
        std::uint32_t& id = own_id(place);
        auto& leaves = pools_->leaves;
        if (!leaves.shared(id, caches_->leaves)) return leaves[id];
        const std::uint32_t copy = leaves.take(caches_->leaves);
        const Leaf& from = leaves[id];
        Leaf& leaf = leaves[copy];
        std::copy_n(from.values.begin(), pools_->columns * Leaf::kLandmarks, leaf.values.begin());
        leaf.records = from.records;
        if (row_->index != LandmarkIndex::kNone) leaf.entered = from.entered;
        drop_leaf(std::exchange(id, copy));
        leaves.prefetch_next(caches_->leaves, sizeof(double) * pools_->columns * Leaf::kLandmarks);
        return leaf;
    }
    /// Adds an empty leaf behind `count` ones.
    void add(std::size_t count) {
        const std::uint32_t id = pools_->leaves.take(caches_->leaves);
        pools_->leaves[id].values.fill(0.0);
        try {
            if (count < LandmarkRow::kOwn) {
                row_->leaves[count] = id;
            } else {
                add_behind(count - LandmarkRow::kOwn, id);
            }
        } catch (...) {
            drop_leaf(id);
            throw;
        }
    }
    /// Drops all leaves but the first `left` of `count`.
    void cut(std::size_t count, std::size_t left) {
        const std::size_t behind = left - std::min(left, LandmarkRow::kOwn);
        const std::size_t pages = (behind + LeafPage::kLeaves - 1) / LeafPage::kLeaves;
        const std::size_t rest = behind % LeafPage::kLeaves;
        // What may fail comes first.
        if (rest > 0 && pools_->pages[(*pages_)[pages - 1]].count > rest) {
            LeafPage& page = own_page((*pages_)[pages - 1]);
            while (page.count > rest) drop_leaf(page.leaves[--page.count]);
        }
        while (pages_->size() > pages) {
            drop_page(pages_->back());
            pages_->pop_back();
        }
        for (std::size_t i = left; i < std::min(count, LandmarkRow::kOwn); ++i) {
            drop_leaf(row_->leaves[i]);
        }
    }
    /// That are in use.
    std::size_t columns() const { return pools_->columns; }
    LandmarkIndex index() const { return {pools_->nodes, row_->index, caches_->nodes}; }

    /// Holds what the row is made of once more, for another that is the same.
    void share() {
        for (std::size_t i = 0; i < row_->own_leaves(); ++i)
            pools_->leaves.share(row_->leaves[i], caches_->leaves);
        for (const std::uint32_t page : *pages_) pools_->pages.share(page, caches_->pages);
        if (row_->index != LandmarkIndex::kNone) pools_->nodes.share(row_->index, caches_->nodes);
    }
    /// Holds nothing any more.
    void drop() {
        index().clear();
        cut(row_->leaf_count(), 0);
        row_->size = row_->entries = 0;
    }

  private:
    std::uint32_t id(std::size_t place) const {
        if (place < LandmarkRow::kOwn) return row_->leaves[place];
        const std::size_t behind = place - LandmarkRow::kOwn;
        return pools_->pages[(*pages_)[behind / LeafPage::kLeaves]]
            .leaves[behind % LeafPage::kLeaves];
    }
    std::uint32_t& own_id(std::size_t place) {
        if (place < LandmarkRow::kOwn) return row_->leaves[place];
        const std::size_t behind = place - LandmarkRow::kOwn;
        return own_page((*pages_)[behind / LeafPage::kLeaves]).leaves[behind % LeafPage::kLeaves];
    }
    LeafPage& own_page(std::uint32_t& id) {
        auto& pages = pools_->pages;
        if (!pages.shared(id, caches_->pages)) return pages[id];
        const std::uint32_t copy = pages.take(caches_->pages);
        LeafPage& page = pages[copy] = pages[id];
        for (std::size_t i = 0; i < page.count; ++i) {
            pools_->leaves.share(page.leaves[i], caches_->leaves);
        }
        drop_page(std::exchange(id, copy));
        return page;
    }
    void add_behind(std::size_t behind, std::uint32_t leaf) {
        if (behind % LeafPage::kLeaves == 0) {
            pages_->reserve(pages_->size() + 1);
            const std::uint32_t page = pools_->pages.take(caches_->pages);
            pools_->pages[page].count = 0;
            pages_->push_back(page);
        }
        LeafPage& page = own_page(pages_->back());
        page.leaves[page.count++] = leaf;
    }
    void drop_leaf(std::uint32_t id) {
        if (pools_->leaves.let_go(id, caches_->leaves)) {
            pools_->leaves.put_back(id, caches_->leaves);
        }
    }
    void drop_page(std::uint32_t id) {
        if (!pools_->pages.let_go(id, caches_->pages)) return;
        const LeafPage& page = pools_->pages[id];
        for (std::size_t i = 0; i < page.count; ++i) drop_leaf(page.leaves[i]);
        pools_->pages.put_back(id, caches_->pages);
    }

    Pools* pools_;
    LandmarkRow* row_;
    Pages* pages_;
    Caches* caches_;
};

}  // namespace hitos
