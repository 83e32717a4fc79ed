// The maps of all particles: landmarks by kind, in leaves that maps share until written.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "models/landmark_kinds.hpp"

namespace hitos {

/// The landmarks of one kind in all maps.
template <class S>
struct LandmarkTable {
    typename S::Columns::Pool pool;
    std::vector<LandmarkRow> rows;  // of every map
};

/// All maps of a filter. Different workers may write different maps at the same time.
class MapStore {
  public:
    using Handle = std::uint32_t;
    /// What a worker needs to write maps: a cache for each kind.
    struct alignas(64) Worker : std::array<LeafCache, LandmarkKinds::kSize> {};

    /// A new, empty map.
    Handle create() {
        for_each_kind([&]<class S>() { table<S>().rows.emplace_back(); });
        return static_cast<Handle>(maps() - 1);
    }
    std::size_t maps() const { return std::get<0>(tables_).rows.size(); }

    /// Map `to` becomes what map `from` is, at a cost of its leaves' number.
    void copy(Handle from, Handle to, Worker& worker) {
        for_each_kind([&]<class S>() {
            auto& [pool, rows] = table<S>();
            LeafCache& cache = worker[LandmarkKinds::place<S>()];
            rows[to].leaves.reserve(rows[from].leaves.size());  // what may fail comes first
            for (const std::uint32_t leaf : rows[from].leaves) pool.share(leaf, cache);
            for (const std::uint32_t leaf : rows[to].leaves) pool.drop(leaf, cache);
            rows[to].leaves.assign(rows[from].leaves.begin(), rows[from].leaves.end());
            rows[to].size = rows[from].size;
        });
    }
    void copy(Handle from, Handle to) { copy(from, to, own_); }

    template <Sensor S>
    typename S::Columns landmarks(Handle handle, Worker& worker) {
        auto& [pool, rows] = table<S>();
        return {pool, rows[handle], worker[LandmarkKinds::place<S>()]};
    }
    template <Sensor S>
    typename S::Columns landmarks(Handle handle) {
        return landmarks<S>(handle, own_);
    }
    /// For reading only: the view of a const store cannot be told from another's.
    template <Sensor S>
    const typename S::Columns landmarks(Handle handle) const {     // NOLINT(*-const-return-type)
        return const_cast<MapStore&>(*this).landmarks<S>(handle);  // NOLINT(*-const-cast)
    }
    /// Landmarks of all kinds in a map.
    std::size_t size(Handle handle) const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() { sum += landmarks<S>(handle).size(); });
        return sum;
    }
    /// Leaves of all maps, and those that are ready to become some.
    std::size_t leaves() const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() { sum += table<S>().pool.leaves(); });
        return sum;
    }
    std::size_t bytes() const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() {
            sum += table<S>().pool.bytes();
            for (const LandmarkRow& row : table<S>().rows) {
                sum += sizeof(row) + row.leaves.size() * sizeof(std::uint32_t);
            }
        });
        return sum;
    }

  private:
    template <Sensor S>
    LandmarkTable<S>& table() {
        return std::get<LandmarkTable<S>>(tables_);
    }
    template <Sensor S>
    const LandmarkTable<S>& table() const {
        return std::get<LandmarkTable<S>>(tables_);
    }

    LandmarkKinds::Tuple<LandmarkTable> tables_;
    Worker own_;  // of those who work alone
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
