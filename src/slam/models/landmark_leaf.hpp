// Landmarks in leaves of eight, shared by maps until written.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "hitos/base/memory_need.hpp"
#include "sensor.hpp"

namespace hitos {

/// Eight landmarks of one kind: a column of doubles for each quantity, which is one vector register
/// of the widest sort.
template <std::size_t kColumns>
struct LandmarkLeaf {
    static constexpr std::size_t kLandmarks = 8;

    alignas(64) std::array<double, kColumns * kLandmarks> values;
    std::array<LandmarkRecord, kLandmarks> records;

    double* column(std::size_t index) { return values.data() + index * kLandmarks; }
    const double* column(std::size_t index) const { return values.data() + index * kLandmarks; }
};

/// Where one worker takes new leaves from and leaves those that nobody has any more, so that
/// workers need not wait for each other.
struct LeafCache {
    std::vector<std::uint32_t> free;
    bool alone = true;  ///< whether no other worker is at work
};

/// The leaves of all maps, with the number of maps that hold each. A leaf that several hold is
/// never written. Workers with caches of their own may take, share and drop leaves at the same
/// time.
template <std::size_t kColumns>
class LeafPool {
  public:
    using Id = std::uint32_t;
    using Leaf = LandmarkLeaf<kColumns>;

    LeafPool() = default;
    LeafPool(const LeafPool& other) : free_(other.free_), next_(other.next_) {
        std::size_t left = next_;
        for (std::size_t i = 0; left > 0; ++i) {
            const std::size_t used = std::min(left, size_of(i));
            const Chunk& from = other.chunks_.at(i);
            add_chunk(i);
            std::copy_n(from.leaves.get(), used, chunks_.at(i).leaves.get());
            chunks_.at(i).references = from.references;
            left -= used;
        }
    }
    LeafPool& operator=(const LeafPool& other) {
        LeafPool copy(other);
        chunks_.swap(copy.chunks_);
        free_.swap(copy.free_);
        next_ = copy.next_;
        return *this;
    }
    ~LeafPool() = default;

    Leaf& operator[](Id id) {
        const Place place(id);
        return chunks_[place.chunk].leaves[place.offset];
    }
    const Leaf& operator[](Id id) const {
        const Place place(id);
        return chunks_[place.chunk].leaves[place.offset];
    }

    /// An empty leaf for one map.
    Id take(LeafCache& cache) {
        const Id id = place(cache);
        (*this)[id].values.fill(0.0);
        return id;
    }
    void share(Id id, const LeafCache& cache) {
        std::uint32_t& count = references(id);
        if (cache.alone) {
            ++count;
        } else {
            std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
        }
    }
    void drop(Id id, LeafCache& cache) noexcept {
        std::uint32_t& count = references(id);
        // Who holds it last must see what the others have done with it.
        const std::uint32_t left =
            cache.alone ? --count
                        : std::atomic_ref(count).fetch_sub(1, std::memory_order_acq_rel) - 1;
        if (left != 0) return;
        try {
            cache.free.push_back(id);
            if (cache.free.size() > kMostFree) give_back(cache);
        } catch (...) {  // no memory to note it: it is used no more, which is all
        }
    }
    /// Makes `id` a leaf that only one map holds: itself, or a copy.
    Leaf& own(Id& id, LeafCache& cache) {
        const Place at(id);
        Chunk& chunk = chunks_[at.chunk];
        std::uint32_t& count = chunk.references[at.offset];
        const std::uint32_t holders =
            cache.alone ? count : std::atomic_ref(count).load(std::memory_order_acquire);
        Leaf& here = chunk.leaves[at.offset];
        if (holders == 1) return here;
        const Id copy = place(cache);
        Leaf& leaf = (*this)[copy];
        leaf = here;
        drop(std::exchange(id, copy), cache);
        return leaf;
    }

    std::size_t bytes() const {
        std::size_t leaves = 0;
        for (std::size_t i = 0; i < kChunks && chunks_.at(i).leaves; ++i) leaves += size_of(i);
        return leaves * (sizeof(Leaf) + sizeof(std::uint32_t));
    }
    /// Leaves of maps, and those that are ready to become some.
    std::size_t leaves() const { return next_; }

  private:
    static constexpr std::size_t kBatch = 16;     ///< leaves that a cache takes at once
    static constexpr std::size_t kMostFree = 64;  ///< and has at most
    // Chunks never move; each is twice as large as the one before.
    static constexpr std::size_t kFirst = 64;
    static constexpr std::size_t kChunks = 24;
    struct Freed {
        std::size_t count = 0;
        void operator()(Leaf* leaves) const { std::allocator<Leaf>().deallocate(leaves, count); }
    };
    using Leaves = std::unique_ptr<Leaf[], Freed>;  // NOLINT(*-avoid-c-arrays)
    struct Chunk {
        Leaves leaves;
        std::vector<std::uint32_t> references;
    };
    static std::size_t size_of(std::size_t chunk) { return kFirst << chunk; }
    struct Place {
        explicit Place(std::size_t id) {
            const auto power = static_cast<std::size_t>(std::bit_width(id + kFirst)) - 1;
            chunk = power - (static_cast<std::size_t>(std::bit_width(kFirst)) - 1);
            offset = id + kFirst - (std::size_t{1} << power);
        }
        std::size_t chunk;
        std::size_t offset;
    };

    std::uint32_t& references(Id id) {
        const Place place(id);
        return chunks_[place.chunk].references[place.offset];
    }

    /// One of the cache's, which only one map holds then.
    Id place(LeafCache& cache) {
        if (cache.free.empty()) fill(cache);
        const Id id = cache.free.back();
        cache.free.pop_back();
        references(id) = 1;
        return id;
    }
    void fill(LeafCache& cache) {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < kBatch; ++i) {
            if (!free_.empty()) {
                cache.free.push_back(free_.back());
                free_.pop_back();
                continue;
            }
            if (const Place place(next_); place.offset == 0) add_chunk(place.chunk);
            cache.free.push_back(static_cast<Id>(next_++));
        }
    }
    void give_back(LeafCache& cache) {
        const std::lock_guard lock(mutex_);
        const auto kept = cache.free.begin() + kMostFree / 2;
        free_.insert(free_.end(), kept, cache.free.end());
        cache.free.erase(kept, cache.free.end());
    }
    void add_chunk(std::size_t i) {
        const std::size_t count = size_of(i);
        const std::size_t bytes = count * (sizeof(Leaf) + sizeof(std::uint32_t));
        require_memory(bytes + bytes / 4);  // those before, and the first of these
        if (i >= kChunks) throw MemoryShortage(bytes);
        // Without values, so that the system gives the memory when they are taken.
        chunks_.at(i) = {Leaves(std::allocator<Leaf>().allocate(count), Freed{count}),
                         std::vector<std::uint32_t>(count)};
    }

    std::array<Chunk, kChunks> chunks_;
    std::vector<Id> free_;
    std::size_t next_ = 0;  ///< leaf that was never used
    std::mutex mutex_;
};

}  // namespace hitos
