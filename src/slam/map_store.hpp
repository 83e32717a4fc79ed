// The maps of all particles: landmarks by kind in columns, maps shared until written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "hitos/base/memory_need.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {

/// The landmarks of one kind in all maps, one block of equal capacity after the other in a single
/// piece of memory: thousands of small maps in memory of their own cost more in cache and page
/// misses than in arithmetic.
template <class S>
class LandmarkTable {
  public:
    using View = typename S::Columns;

    View operator[](std::size_t block) {
        return {values_.data() + block * View::kColumns * capacity_,
                records_.data() + block * capacity_, &sizes_[block], capacity_};
    }

    /// For reading only: the view of a const table cannot be told from another's.
    const View operator[](std::size_t block) const {      // NOLINT(readability-const-return-type)
        return const_cast<LandmarkTable&>(*this)[block];  // NOLINT(*-const-cast)
    }

    std::size_t size(std::size_t block) const { return sizes_[block]; }
    std::size_t blocks() const { return sizes_.size(); }

    void add_block() {
        sizes_.push_back(0);
        values_.resize(sizes_.size() * View::kColumns * capacity_);
        records_.resize(sizes_.size() * capacity_);
    }
    void clear(std::size_t block) { sizes_[block] = 0; }
    std::size_t bytes() const {
        return values_.size() * sizeof(double) + records_.size() * sizeof(LandmarkRecord);
    }

    void copy(std::size_t from, std::size_t to) {
        View source = (*this)[from];
        View target = (*this)[to];
        sizes_[to] = sizes_[from];
        for (std::size_t c = 0; c < View::kColumns; ++c) {
            std::copy_n(source.column(static_cast<int>(c)), source.size(),
                        target.column(static_cast<int>(c)));
        }
        if (source.size() > 0) {
            std::copy_n(&source.record(0), source.size(), &target.record(0));
        }
    }

    /// Room for `extra` more landmarks in every block. Invalidates views.
    void reserve_more(std::size_t extra) {
        std::size_t largest = 0;
        for (const std::uint32_t size : sizes_) largest = std::max<std::size_t>(largest, size);
        if (largest + extra <= capacity_) return;
        LandmarkTable larger;
        larger.capacity_ = std::max(largest + extra, capacity_ + capacity_ / 2 + 8);
        larger.sizes_ = sizes_;
        require_memory(bytes() + sizes_.size() * larger.capacity_ * kBytesEach);
        larger.values_.resize(sizes_.size() * View::kColumns * larger.capacity_);
        larger.records_.resize(sizes_.size() * larger.capacity_);
        for (std::size_t block = 0; block < sizes_.size(); ++block) {
            View source = (*this)[block];
            View target = larger[block];
            for (int c = 0; c < static_cast<int>(View::kColumns); ++c) {
                std::copy_n(source.column(c), source.size(), target.column(c));
            }
            std::copy_n(records_.data() + block * capacity_, source.size(),
                        larger.records_.data() + block * larger.capacity_);
        }
        *this = std::move(larger);
    }

  private:
    static constexpr std::size_t kBytesEach =
        View::kColumns * sizeof(double) + sizeof(LandmarkRecord);  ///< of a landmark

    std::vector<double> values_;
    std::vector<LandmarkRecord> records_;
    std::vector<std::uint32_t> sizes_;
    std::size_t capacity_ = 0;
};

/// All maps of a filter. Resampling copies handles; before maps are written, detach() finds the
/// handles that share a block and says which copies are due. The copies themselves touch only
/// blocks that nobody else uses, so they can be made in parallel.
class MapStore {
  public:
    using Handle = std::uint32_t;

    /// A new, empty map.
    Handle create() {
        const Handle handle = take();
        for_each_table([&](auto& table) { table.clear(handle); });
        return handle;
    }
    void share(Handle handle) { ++references_[handle]; }
    void release(Handle handle) {
        if (--references_[handle] == 0) free_.push_back(handle);
    }

    /// Makes `handle` the only reference to its block. Where it was shared, gives it a block of
    /// its own and returns the handle whose content must be copied there (copy()) before any
    /// block is written; else returns the handle itself.
    Handle detach(Handle& handle) {
        if (references_[handle] == 1) return handle;
        const Handle source = handle;
        --references_[source];
        handle = take();
        return source;
    }
    void copy(Handle from, Handle to) {
        for_each_table([&](auto& table) { table.copy(from, to); });
    }

    /// Room for that many more landmarks of a kind in every map, so that parallel writers need
    /// none.
    template <Sensor S>
    void reserve_more(std::size_t extra) {
        table<S>().reserve_more(extra);
    }

    template <Sensor S>
    typename S::Columns landmarks(Handle handle) {
        return table<S>()[handle];
    }
    template <Sensor S>
    const typename S::Columns landmarks(Handle handle) const {  // NOLINT(*-const-return-type)
        return std::get<LandmarkTable<S>>(tables_)[handle];
    }
    /// Landmarks of all kinds in a map.
    std::size_t size(Handle handle) const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() { sum += landmarks<S>(handle).size(); });
        return sum;
    }
    std::size_t blocks() const { return references_.size(); }
    std::size_t bytes() const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() { sum += std::get<LandmarkTable<S>>(tables_).bytes(); });
        return sum;
    }

  private:
    Handle take() {
        if (free_.empty()) {
            for_each_table([](auto& table) { table.add_block(); });
            references_.push_back(1);
            return static_cast<Handle>(references_.size() - 1);
        }
        const Handle handle = free_.back();
        free_.pop_back();
        references_[handle] = 1;
        return handle;
    }

    template <Sensor S>
    LandmarkTable<S>& table() {
        return std::get<LandmarkTable<S>>(tables_);
    }
    template <class Body>
    void for_each_table(const Body& body) {
        for_each_kind([&]<class S>() { body(table<S>()); });
    }

    LandmarkKinds::Tuple<LandmarkTable> tables_;
    std::vector<std::uint32_t> references_;
    std::vector<Handle> free_;
};

/// One particle's map, for reading.
class ParticleMap {
  public:
    ParticleMap(const MapStore& maps, MapStore::Handle handle) : maps_(maps), handle_(handle) {}
    template <Sensor S>
    const typename S::Columns landmarks() const {  // NOLINT(*-const-return-type)
        return maps_.landmarks<S>(handle_);
    }

  private:
    const MapStore& maps_;
    MapStore::Handle handle_;
};

}  // namespace hitos
