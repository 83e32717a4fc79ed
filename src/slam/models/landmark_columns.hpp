// Landmarks of one kind in columns.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "hitos/base/vectorised.hpp"
#include "landmark_leaf.hpp"

namespace hitos {

/// The landmarks of one kind in one map: the leaves that they stand in, and their number.
struct LandmarkRow {
    std::vector<std::uint32_t> leaves;
    std::uint32_t size = 0;
};

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

/// A view of a map's landmarks of one kind. What is written goes into leaves of the map's own:
/// those that it shares with others are copied first.
template <class S, int Extra>
class LandmarkColumns : public LandmarkQuantities<Extra> {
  public:
    using LandmarkQuantities<Extra>::kState0;
    using LandmarkQuantities<Extra>::kState1;
    using LandmarkQuantities<Extra>::kP00;
    using LandmarkQuantities<Extra>::kP01;
    using LandmarkQuantities<Extra>::kP11;
    using LandmarkQuantities<Extra>::kColumns;
    using Pool = LeafPool<kColumns>;
    using Leaf = typename Pool::Leaf;
    static constexpr std::uint32_t kGone = UINT32_MAX;
    static constexpr std::size_t kLeaf = Leaf::kLandmarks;

    LandmarkColumns(Pool& pool, LandmarkRow& row, LeafCache& cache)
        : pool_(&pool), row_(&row), cache_(&cache) {}

    std::size_t size() const { return row_->size; }
    std::size_t leaves() const { return row_->leaves.size(); }
    const Leaf& leaf(std::size_t place) const { return (*pool_)[row_->leaves[place]]; }
    /// The leaf of a landmark, to write.
    Leaf& own_leaf_of(std::size_t i) { return pool_->own(row_->leaves[i / kLeaf], *cache_); }

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
    typename S::Lane lane(std::size_t i) const {
        return S::Lane::load(leaf(i / kLeaf).values.data() + i % kLeaf, kLeaf);
    }
    void put(std::size_t i, const typename S::Lane& lane) {
        lane.store(own_leaf_of(i).values.data() + i % kLeaf, kLeaf);
    }

    /// Leaves that are looked at together: a bit for each landmark is a word.
    static constexpr std::size_t kAtOnce = 8;
    using LeafValues = std::array<const double*, kAtOnce>;
    /// The values of the leaves from the one at `first` on; how many there are is the result.
    std::size_t values_of(std::size_t first, LeafValues& values) const {
        const std::size_t count = std::min(kAtOnce, leaves() - first);
        for (std::size_t k = 0; k < count; ++k) values[k] = leaf(first + k).values.data();
        return count;
    }
    /// Asks memory for the first leaves, which will soon be looked at.
    void prefetch() const {
        constexpr std::size_t kLine = 64 / sizeof(double);
        const std::size_t count = std::min(kAtOnce, leaves());
        for (std::size_t k = 0; k < count; ++k) {
            const double* const values = leaf(k).values.data();
            for (std::size_t i = 0; i < S::Lane::kSize * kLeaf; i += kLine) {
                __builtin_prefetch(values + i);
            }
        }
    }
    /// The bits of the landmarks that there are in `count` leaves from the one at `first` on.
    std::uint64_t bits_of(std::size_t first, std::size_t count) const {
        const std::size_t landmarks = std::min(count * kLeaf, size() - first * kLeaf);
        return ~std::uint64_t{0} >> (64 - landmarks);
    }
    /// Quick rejection: of each landmark of these leaves a bit, 0 where it cannot be what was
    /// observed. The bits of places without a landmark mean nothing.
    HITOS_INLINE static std::uint64_t near_in(const LeafValues& values, std::size_t count,
                                              LanePose pose, NearQuery query) {
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
    /// The same of the leaves from the one at `first` on, without what there is not.
    std::uint64_t near_from(std::size_t first, const Pose& pose,
                            const PreparedObservation& observed) const {
        LeafValues values{};
        const std::size_t count = values_of(first, values);
        std::uint64_t near = 0;
        vectorised([&]() HITOS_INLINED {
            near = near_in(values, count, lane_of(pose), near_query(observed));
        });
        return near & bits_of(first, count);
    }

    /// Adds a landmark without values; returns its index.
    std::size_t append() {
        // Counted last: where memory ends, the map is as it was.
        const std::size_t index = row_->size;
        if (index / kLeaf >= row_->leaves.size()) {
            row_->leaves.emplace_back();
            try {
                row_->leaves.back() = pool_->take(*cache_);
            } catch (...) {
                row_->leaves.pop_back();
                throw;
            }
        }
        record(index) = {};
        ++row_->size;
        return index;
    }

    /// Landmark `to` becomes what landmark `from` is.
    void copy(std::size_t from, std::size_t to) {
        Leaf& target = own_leaf_of(to);
        const Leaf& source = leaf(from / kLeaf);
        for (std::size_t c = 0; c < kColumns; ++c) {
            target.column(c)[to % kLeaf] = source.column(c)[from % kLeaf];
        }
        target.records[to % kLeaf] = source.records[from % kLeaf];
    }
    /// Takes out what `goes(i)` names; the others keep their order. `places` gets where each is
    /// then, kGone of those that are gone. False where none is.
    template <class Goes>
    bool take_out(const Goes& goes, std::vector<std::uint32_t>& places) {
        places.clear();
        std::uint32_t next = 0;
        for (std::uint32_t i = 0; i < size(); ++i) {
            const bool gone = goes(i);
            places.push_back(gone ? kGone : next);
            if (gone) continue;
            if (next != i) copy(i, next);
            ++next;
        }
        if (next == size()) return false;
        cut(next);
        return true;
    }
    /// Only the first `size` landmarks stay.
    void cut(std::size_t size) {
        row_->size = static_cast<std::uint32_t>(size);
        while (row_->leaves.size() * kLeaf >= size + kLeaf) {
            pool_->drop(row_->leaves.back(), *cache_);
            row_->leaves.pop_back();
        }
    }

  private:
    Pool* pool_;
    LandmarkRow* row_;
    LeafCache* cache_;
};

}  // namespace hitos
