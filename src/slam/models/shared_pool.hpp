// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of maps, shared until written.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "hitos/base/memory_need.hpp"

namespace hitos {

/// Where one worker takes new pieces from and leaves those that nobody has any more, so that
/// workers need not wait for each other.
struct PoolCache {
    std::vector<std::uint32_t> free;
    bool alone = true;  ///< whether no other worker is at work
};

/// Pieces with the number of holds on each. One that several hold is never written. Workers with
/// caches of their own may take, share and give up pieces at the same time. A piece's memory is as
/// it comes when it is taken.
template <class T>
class SharedPool {
  public:
    using Id = std::uint32_t;

    SharedPool() = default;
    SharedPool(const SharedPool&) = delete;
    SharedPool& operator=(const SharedPool&) = delete;
    ~SharedPool() = default;

    /// Becomes what the other has of pieces that somebody holds, side by side: most of a pool that
    /// has been at work for long nobody does. Returns by their former numbers those they have now.
    std::vector<Id> assign_held(const SharedPool& other) {
        std::vector<Id> numbers(other.next_, 0);
        SharedPool held;
        for (Id id = 0; id < other.next_; ++id) {
            const Place from(id);
            const Chunk& chunk = other.chunks_[from.chunk];
            if (chunk.holds[from.offset] == 0) continue;
            numbers[id] = held.fresh();
            held[numbers[id]] = chunk.pieces[from.offset];
            held.holds(numbers[id]) = chunk.holds[from.offset];
        }
        chunks_.swap(held.chunks_);
        free_.clear();
        next_ = held.next_;
        return numbers;
    }

    T& operator[](Id id) {
        const Place place(id);
        return chunks_[place.chunk].pieces[place.offset];
    }
    const T& operator[](Id id) const {
        const Place place(id);
        return chunks_[place.chunk].pieces[place.offset];
    }

    /// A piece that the caller alone holds.
    Id take(PoolCache& cache) {
        if (cache.free.empty()) fill(cache);
        const Id id = cache.free.back();
        cache.free.pop_back();
        holds(id) = 1;
        return id;
    }
    /// Asks memory for so many of the first bytes of the piece that will be taken next, to write.
    void prefetch_next(const PoolCache& cache, std::size_t bytes) {
        if (cache.free.empty()) return;
        constexpr std::size_t kLine = 64;
        const auto* const begin = reinterpret_cast<const char*>(&(*this)[cache.free.back()]);
        for (std::size_t at = 0; at < bytes; at += kLine) __builtin_prefetch(begin + at, 1);
    }
    void share(Id id, const PoolCache& cache) {
        std::uint32_t& count = holds(id);
        if (cache.alone) {
            ++count;
        } else {
            std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
        }
    }
    /// Whether others hold it too.
    bool shared(Id id, const PoolCache& cache) {
        std::uint32_t& count = holds(id);
        const std::uint32_t holders =
            cache.alone ? count : std::atomic_ref(count).load(std::memory_order_acquire);
        return holders != 1;
    }
    /// Gives a hold up. True where it was the last: then what the piece itself holds is to be given
    /// up, and the piece to be left to put_back().
    bool let_go(Id id, const PoolCache& cache) noexcept {
        std::uint32_t& count = holds(id);
        // Who holds it last must see what the others have done with it.
        return (cache.alone
                    ? --count
                    : std::atomic_ref(count).fetch_sub(1, std::memory_order_acq_rel) - 1) == 0;
    }
    void put_back(Id id, PoolCache& cache) noexcept {
        try {
            cache.free.push_back(id);
            if (cache.free.size() > kMostFree) give_back(cache);
        } catch (...) {  // no memory to note it: it is used no more, which is all
        }
    }

    /// About: pieces that were never used have no memory yet.
    std::size_t bytes() const { return next_ * kBytes; }
    /// Pieces in use, and those that are ready to be.
    std::size_t size() const { return next_; }
    /// For checks: how many hold it, and pieces that nobody holds and no worker has.
    std::uint32_t holders(Id id) const {
        const Place place(id);
        return chunks_.at(place.chunk).holds[place.offset];
    }
    const std::vector<Id>& free() const { return free_; }

  private:
    static constexpr std::size_t kBytes = sizeof(T) + sizeof(std::uint32_t);
    static constexpr std::size_t kBatch = 16;     ///< pieces that a cache takes at once
    static constexpr std::size_t kMostFree = 64;  ///< and has at most
    // Chunks never move; each is twice as large as the one before.
    static constexpr std::size_t kFirst = 64;
    static constexpr std::size_t kChunks = 24;
    struct Freed {
        std::size_t count = 0;
        void operator()(T* pieces) const { std::allocator<T>().deallocate(pieces, count); }
    };
    struct Chunk {
        std::unique_ptr<T[], Freed> pieces;  // NOLINT(*-avoid-c-arrays)
        std::vector<std::uint32_t> holds;
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

    std::uint32_t& holds(Id id) {
        const Place place(id);
        return chunks_[place.chunk].holds[place.offset];
    }
    void fill(PoolCache& cache) {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < kBatch; ++i) {
            if (!free_.empty()) {
                cache.free.push_back(free_.back());
                free_.pop_back();
                continue;
            }
            cache.free.push_back(fresh());
        }
    }
    Id fresh() {
        if (const Place place(next_); place.offset == 0) add_chunk(place.chunk);
        return static_cast<Id>(next_++);
    }
    void give_back(PoolCache& cache) {
        const std::lock_guard lock(mutex_);
        const auto kept = cache.free.begin() + kMostFree / 2;
        free_.insert(free_.end(), kept, cache.free.end());
        cache.free.erase(kept, cache.free.end());
    }
    void add_chunk(std::size_t i) {
        const std::size_t count = size_of(i);
        const std::size_t bytes = count * kBytes;
        require_memory(bytes + bytes / 4);  // those before, and the first of these
        if (i >= kChunks) throw MemoryShortage(bytes);
        // Without values, so that the system gives the memory when they are taken.
        chunks_.at(i).pieces = {std::allocator<T>().allocate(count), Freed{count}};
        chunks_.at(i).holds.resize(count);
    }

    std::array<Chunk, kChunks> chunks_;
    std::vector<Id> free_;
    std::size_t next_ = 0;  ///< piece that was never used
    std::mutex mutex_;
};

}  // namespace hitos
