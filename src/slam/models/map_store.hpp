// SPDX-License-Identifier: GPL-3.0-or-later
// The maps of all particles: landmarks by kind, in leaves that maps share until written.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "landmark_kinds.hpp"

namespace hitos {

/// The landmarks of one kind in all maps.
template <class S>
struct LandmarkTable {
    using List = LeafList<S::Columns::kColumns>;
    using Caches = typename List::Caches;

    typename S::Columns::Pools pools;
    std::vector<LandmarkRow> rows;  // of every map
    std::vector<typename List::Pages> pages;
    // Rows and pages that take the place of these when a selection ends.
    std::vector<LandmarkRow> next_rows;
    std::vector<typename List::Pages> next_pages;

    LandmarkTable() = default;
    LandmarkTable(const LandmarkTable& other) { *this = other; }
    LandmarkTable& operator=(const LandmarkTable& other) {
        if (this == &other) return *this;
        rows = other.rows;
        pages = other.pages;
        pools.assign_held(other.pools, rows, pages);
        return *this;
    }
    ~LandmarkTable() = default;

    List list(std::size_t map, Caches& caches) { return {pools, rows[map], pages[map], caches}; }
};

/// All maps of a filter. Different workers may write different maps at the same time.
class MapStore {
  public:
    using Handle = std::size_t;
    /// What a worker needs to write maps.
    class alignas(64) Worker {
      public:
        void alone(bool whether) {
            for_each_kind([&]<class S>() { caches<S>().alone(whether); });
        }
        template <Sensor S>
        auto& caches() {
            return std::get<LandmarkKinds::place<S>()>(caches_);
        }

      private:
        template <class S>
        using Of = typename LandmarkTable<S>::Caches;
        LandmarkKinds::Tuple<Of> caches_;
    };

    /// Maps whose landmarks have extents, or none.
    explicit MapStore(bool extents = true) {
        if (extents) return;
        for_each_kind([&]<class S>() { table<S>().pools.columns = S::Lane::kSize; });
    }

    /// A copy has what maps hold, and nothing in stock.
    MapStore(const MapStore& other) : tables_(other.tables_) {}
    MapStore& operator=(const MapStore& other) {
        if (this == &other) return *this;
        tables_ = other.tables_;
        own_ = {};
        return *this;
    }
    ~MapStore() = default;

    /// A new, empty map.
    Handle create() {
        for_each_kind([&]<class S>() {
            table<S>().pages.emplace_back();
            table<S>().rows.emplace_back();
        });
        return maps() - 1;
    }
    std::size_t maps() const { return std::get<0>(tables_).rows.size(); }

    /// Map `to` becomes what map `from` is, at a cost of its pages' number.
    void copy(Handle from, Handle to, Worker& worker) {
        if (from == to) return;
        for_each_kind([&]<class S>() {
            LandmarkTable<S>& all = table<S>();
            auto& caches = worker.caches<S>();
            all.pages[to].reserve(all.pages[from].size());  // what may fail comes first
            all.list(from, caches).share();
            all.list(to, caches).drop();
            all.rows[to] = all.rows[from];
            all.pages[to] = all.pages[from];
        });
    }
    void copy(Handle from, Handle to) { copy(from, to, own_); }

    // A selection: every map becomes one of those that there are. Any worker may do any of these
    // calls, all that select before all that let go.
    void begin_selection() {
        for_each_kind([&]<class S>() {
            table<S>().next_rows.resize(maps());
            table<S>().next_pages.resize(maps());
        });
    }
    /// Map `to` will be what `from` is, `again` where another will be that too.
    void select(Handle from, Handle to, bool again, Worker& worker) {
        for_each_kind([&]<class S>() {
            LandmarkTable<S>& all = table<S>();
            all.next_rows[to] = all.rows[from];
            if (!again) return;
            all.next_pages[to] = all.pages[from];
            all.list(from, worker.caches<S>()).share();
        });
    }
    /// Of all that will be what `from` is map `to` takes over what `from` holds.
    void take_over(Handle from, Handle to) {
        for_each_kind([&]<class S>() { table<S>().next_pages[to].swap(table<S>().pages[from]); });
    }
    /// Nobody will be what `from` is.
    void pass_over(Handle from, Worker& worker) {
        for_each_kind([&]<class S>() { table<S>().list(from, worker.caches<S>()).drop(); });
    }
    void end_selection() {
        for_each_kind([&]<class S>() {
            table<S>().rows.swap(table<S>().next_rows);
            table<S>().pages.swap(table<S>().next_pages);
        });
    }

    template <Sensor S>
    typename S::Columns landmarks(Handle handle, Worker& worker) {
        LandmarkTable<S>& all = table<S>();
        return {all.pools, all.rows[handle], all.pages[handle], worker.caches<S>()};
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
    /// Throws std::logic_error where maps contradict themselves (map_check.hpp); `workers` are all
    /// that write them. To be called between steps.
    void check(std::vector<Worker*> workers);

    /// Landmarks of all kinds in a map.
    std::size_t size(Handle handle) const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() { sum += landmarks<S>(handle).size(); });
        return sum;
    }
    /// Leaves of all maps, and those that are ready to become some.
    std::size_t leaves() const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() { sum += table<S>().pools.leaves.size(); });
        return sum;
    }
    std::size_t bytes() const {
        std::size_t sum = 0;
        for_each_kind([&]<class S>() {
            const LandmarkTable<S>& all = table<S>();
            sum +=
                all.pools.bytes() + (all.rows.size() + all.next_rows.size()) * sizeof(LandmarkRow);
            for (const auto* const of : {&all.pages, &all.next_pages}) {
                for (const auto& pages : *of) {
                    sum += sizeof(pages) + pages.capacity() * sizeof(std::uint32_t);
                }
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
