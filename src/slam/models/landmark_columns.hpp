// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks of one kind in columns.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/base/vectorised.hpp"
#include "landmark_leaf.hpp"

namespace hitos {

/// What keeps the landmarks of a kind: state, covariance, and `Extra` quantities.
template <int Extra>
struct LandmarkQuantities {
    static constexpr int kState0 = 0;
    static constexpr int kState1 = 1;
    static constexpr int kP00 = 2;
    static constexpr int kP01 = 3;
    static constexpr int kP11 = 4;
    static constexpr int kExtra = 5;
    static constexpr std::size_t kColumns = kExtra + Extra;
};

/// Leaves to be looked at together: a bit for each landmark is a word.
template <std::size_t kColumns>
struct LeafGroup {
    static constexpr std::size_t kMost = 8;
    std::array<const double*, kMost> values{};
    std::array<std::uint32_t, kMost> first{};  ///< landmark of each
    std::uint64_t there = 0;                   ///< the bits of the landmarks that there are
    std::size_t count = 0;

    /// The landmark of a bit.
    std::uint32_t landmark(std::size_t bit) const {
        return first[bit / 8] + static_cast<std::uint32_t>(bit % 8);
    }
};

/// A view of a map's landmarks of one kind. What is written goes into leaves of the map's own:
/// those that it shares with others are copied first. Maps of more than a few landmarks have an
/// index, so that what is near is found at a cost of what is near.
template <class S, int Extra>
class LandmarkColumns : public LandmarkQuantities<Extra> {
  public:
    using LandmarkQuantities<Extra>::kState0;
    using LandmarkQuantities<Extra>::kState1;
    using LandmarkQuantities<Extra>::kP00;
    using LandmarkQuantities<Extra>::kP01;
    using LandmarkQuantities<Extra>::kP11;
    using LandmarkQuantities<Extra>::kColumns;
    using Pools = LandmarkPools<kColumns>;
    using Caches = typename Pools::Caches;
    using Leaf = typename Pools::Leaf;
    using Group = LeafGroup<kColumns>;
    static constexpr std::uint32_t kGone = UINT32_MAX;
    static constexpr std::size_t kLeaf = Leaf::kLandmarks;
    static constexpr std::size_t kWithoutIndex = 192;  ///< landmarks that are looked at all

    LandmarkColumns(Pools& pools, LandmarkRow& row, std::vector<std::uint32_t>& pages,
                    Caches& caches)
        : list_(pools, row, pages, caches), row_(&row) {}

    std::size_t size() const { return row_->size; }
    std::size_t leaves() const { return row_->leaf_count(); }
    const Leaf& leaf(std::size_t place) const { return list_.leaf(place); }
    /// The leaf of a landmark, to write. Who writes another state tells so by moved().
    Leaf& own_leaf_of(std::size_t i) { return list_.own(i / kLeaf); }

    double value(int column, std::size_t i) const {
        return leaf(i / kLeaf).column(static_cast<std::size_t>(column))[i % kLeaf];
    }
    LandmarkRecord& record(std::size_t i) { return own_leaf_of(i).records[i % kLeaf]; }
    const LandmarkRecord& record(std::size_t i) const { return leaf(i / kLeaf).records[i % kLeaf]; }

    typename S::Landmark mean(std::size_t i) const {
        return S::from_state({value(kState0, i), value(kState1, i)});
    }
    Matrix2 covariance(std::size_t i) const {
        Matrix2 p;
        p << value(kP00, i), value(kP01, i), value(kP01, i), value(kP11, i);
        return p;
    }
    LandmarkEstimate<S> get(std::size_t i) const { return {mean(i), covariance(i)}; }
    void set(std::size_t i, const LandmarkEstimate<S>& estimate) {
        const Vector2 state = S::to_state(estimate.mean);
        const Matrix2& p = estimate.covariance;
        put(i, S::Lane::of({state(0), state(1)}, {p(0, 0), p(0, 1), p(1, 1)}));
    }
    /// All that the filter reckons with of a landmark.
    typename S::Lane lane(std::size_t i) const { return S::Lane::load(first_of(i), kLeaf); }
    /// Where it begins in its leaf.
    const double* first_of(std::size_t i) const {
        return leaf(i / kLeaf).values.data() + i % kLeaf;
    }
    void put(std::size_t i, const typename S::Lane& lane) {
        lane.store(own_leaf_of(i).values.data() + i % kLeaf, kLeaf);
        if (indexed()) {
            enter(i, S::index_point(lane));
        } else if (size() > kWithoutIndex && i + 1 == size()) {
            make_index();
        }
    }

    bool indexed() const { return row_->index != LandmarkIndex::kNone; }
    /// After an update, which only makes an estimate surer: enters the landmark into the index
    /// again where it has left its box.
    void moved(std::size_t i) {
        if (!indexed()) return;
        const IndexPoint point = S::index_point(lane(i));
        const auto& [u, v, shift] = leaf(i / kLeaf).entered[i % kLeaf];
        const double farther = std::max(std::abs(point.u - static_cast<double>(u)),
                                        std::abs(point.v - static_cast<double>(v)));
        const bool inside = farther <= static_cast<double>(shift);
        if (!inside) enter(i, point);
    }
    /// Before all landmarks change; cut() makes another.
    void forget_index() {
        list_.index().clear();
        row_->entries = 0;
    }

    /// Asks memory for the first leaves, which will soon be looked at.
    void prefetch() const {
        if (indexed()) return;  // which of them will be is not known yet
        constexpr std::size_t kLine = 64 / sizeof(double);
        const std::size_t count = std::min(Group::kMost, leaves());
        for (std::size_t k = 0; k < count; ++k) {
            const double* const values = leaf(k).values.data();
            for (std::size_t i = 0; i < S::Lane::kSize * kLeaf; i += kLine) {
                __builtin_prefetch(values + i);
            }
        }
    }
    /// The leaves from the one at `first` on.
    Group group_from(std::size_t first) const {
        Group group;
        const std::size_t end = std::min(first + Group::kMost, leaves());
        for (std::size_t place = first; place < end; ++place) add_to(group, place);
        return group;
    }
    /// Calls body(Group) for all leaves.
    template <class Body>
    void each_group(const Body& body) const {
        for (std::size_t first = 0; first < leaves(); first += Group::kMost) {
            body(group_from(first));
        }
    }
    /// What the index has in the region.
    void find(const IndexRegion& region, std::vector<IndexEntry>& found) const {
        found.clear();
        list_.index().each_in(region, [&](const IndexEntry& entry) { found.push_back(entry); });
    }
    /// Quick rejection: of each landmark of these leaves a bit, 0 where it cannot be what was
    /// observed. The bits of places without a landmark mean nothing.
    HITOS_INLINE static std::uint64_t near_in(const std::array<const double*, Group::kMost>& values,
                                              std::size_t count, LanePose pose, NearQuery query) {
        std::uint64_t near = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const double* const leaf = values[k];
            alignas(64) double margins[kLeaf];  // NOLINT(*-avoid-c-arrays): one register
            HITOS_LANES
            for (std::size_t lane = 0; lane < kLeaf; ++lane) {
                margins[lane] = S::margin(S::Lane::load(leaf + lane, kLeaf), pose, query);
            }
            near |= positive_of_eight(margins) << (k * kLeaf);
        }
        return near;
    }
    /// The same, without what there is not.
    static std::uint64_t near_in(const Group& group, const Pose& pose,
                                 const PreparedObservation& observed) {
        std::uint64_t near = 0;
        vectorised([&]() HITOS_INLINED {
            near = near_in(group.values, group.count, lane_of(pose), near_query(observed));
        });
        return near & group.there;
    }
    /// Calls body(landmark) for all that may be what was observed, in their order.
    template <class Body>
    void each_near(const Pose& pose, const PreparedObservation& observed, const Body& body) const {
        const NearQuery query = near_query(observed);
        const LanePose from = lane_of(pose);
        IndexRegion region = IndexRegion::nowhere();
        if (indexed()) region = IndexRegion::of(S::region(query, from, NearReach::of(query)));
        if (!indexed() || region.endless()) {
            each_group([&](const Group& group) {
                std::uint64_t bits = near_in(group, pose, observed);
                for (; bits != 0; bits &= bits - 1) {
                    body(group.landmark(static_cast<std::size_t>(std::countr_zero(bits))));
                }
            });
            return;
        }
        thread_local std::vector<IndexEntry> found;
        thread_local std::vector<std::uint32_t> near;  // `body` must not ask again
        find(region, found);
        near.clear();
        for (const IndexEntry& entry : found) {
            if (S::margin(lane(entry.id), from, query) > 0.0) near.push_back(entry.id);
        }
        std::ranges::sort(near);
        near.erase(std::unique(near.begin(), near.end()), near.end());
        for (const std::uint32_t i : near) body(i);
    }

    /// The landmark of that identity; nothing where there is none.
    std::optional<std::uint32_t> identified(std::int32_t identity) const {
        for (std::uint32_t i = 0; i < size(); ++i) {
            if (record(i).identity == identity) return i;
        }
        return std::nullopt;
    }

    /// Adds a landmark without values; returns its index.
    std::size_t append() {
        // Counted last: where memory ends, the map is as it was.
        const std::size_t index = row_->size;
        if (index % kLeaf == 0) list_.add(index / kLeaf);
        record(index) = {};
        ++row_->size;
        return index;
    }
    /// Takes out what `goes(i)` names; the others keep their order. `places` gets where each is
    /// then, kGone of those that are gone. False where none is.
    template <class Goes>
    bool take_out(const Goes& goes, std::vector<std::uint32_t>& places) {
        places.clear();
        std::uint32_t next = 0;
        try {
            for (std::uint32_t i = 0; i < size(); ++i) {
                const bool gone = goes(i);
                places.push_back(gone ? kGone : next);
                if (gone) continue;
                if (next != i) copy(i, next);
                ++next;
            }
            if (next == size()) return false;
            row_->entries = list_.index().renumber(places, kGone);
        } catch (...) {  // it would name others than those that are there
            forget_index();
            throw;
        }
        shorten(next);
        return true;
    }
    /// Only the first `size` landmarks stay.
    void cut(std::size_t size) {
        const bool all = size == row_->size;
        shorten(size);
        if (!all || !indexed()) make_index();
    }

  private:
    void shorten(std::size_t size) {
        list_.cut(leaves(), (size + kLeaf - 1) / kLeaf);
        row_->size = static_cast<std::uint32_t>(size);
    }
    void add_to(Group& group, std::size_t place) const {
        const std::size_t first = place * kLeaf;
        const std::size_t landmarks = std::min(kLeaf, size() - first);
        group.values[group.count] = leaf(place).values.data();
        group.first[group.count] = static_cast<std::uint32_t>(first);
        group.there |= ((std::uint64_t{1} << landmarks) - 1) << (group.count * kLeaf);
        ++group.count;
    }
    void make_index() {
        forget_index();
        if (size() <= kWithoutIndex) return;
        for (std::size_t i = 0; i < size(); ++i) enter(i, S::index_point(lane(i)));
    }
    void enter(std::size_t i, const IndexPoint& point) {
        try {
            list_.index().insert(IndexEntry::of(static_cast<std::uint32_t>(i), point));
            own_leaf_of(i).entered[i % kLeaf] = {static_cast<float>(point.u),
                                                 static_cast<float>(point.v),
                                                 static_cast<float>(0.99 * point.shift)};
        } catch (...) {  // half of it would be worse than none
            forget_index();
            throw;
        }
        if (++row_->entries > 2 * size() + kWithoutIndex) tidy_index();
    }
    /// Leaves of each landmark only the box that it was entered with last, with the spread that it
    /// has now. Writes no leaf: they stay shared.
    void tidy_index() {
        forget_index();
        for (std::size_t i = 0; i < size(); ++i) {
            IndexPoint point = S::index_point(lane(i));
            const auto& [u, v, shift] = leaf(i / kLeaf).entered[i % kLeaf];
            point.u = static_cast<double>(u);
            point.v = static_cast<double>(v);
            point.shift = 1.02 * static_cast<double>(shift);
            list_.index().insert(IndexEntry::of(static_cast<std::uint32_t>(i), point));
        }
        row_->entries = row_->size;
    }
    /// Landmark `to` becomes what landmark `from` is.
    void copy(std::size_t from, std::size_t to) {
        Leaf& target = own_leaf_of(to);
        const Leaf& source = leaf(from / kLeaf);
        for (std::size_t c = 0; c < list_.columns(); ++c) {
            target.column(c)[to % kLeaf] = source.column(c)[from % kLeaf];
        }
        target.records[to % kLeaf] = source.records[from % kLeaf];
        target.entered[to % kLeaf] = source.entered[from % kLeaf];
    }

    LeafList<kColumns> list_;
    LandmarkRow* row_;
};

}  // namespace hitos
