// SPDX-License-Identifier: GPL-3.0-or-later
// Messages come in the order in which they were received; a tour is in the order of its stamps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace hitos {

/// Holds so many items, or so many bytes of them, and gives the earliest beyond that; equal stamps
/// in the order of arrival. An item that is later than this window can see is given late.
template <class Item>
class StampQueue {
  public:
    StampQueue(std::size_t most_items, std::size_t most_bytes)
        : most_items_(most_items), most_bytes_(most_bytes) {}

    /// `turn`: how often its device's clock has gone back; what came before that goes first.
    void push(Item item, std::size_t bytes, std::uint64_t turn) {
        bytes_ += bytes;
        const std::int64_t stamp_ns = item.stamp_ns;
        items_.insert(Entry{turn, stamp_ns, arrivals_++, bytes, std::move(item)});
    }
    /// The earliest where there are more than may be held, or where `all` shall go.
    std::optional<Item> pop(bool all) {
        if (items_.empty()) return std::nullopt;
        if (!all && items_.size() <= most_items_ && bytes_ <= most_bytes_) return std::nullopt;
        auto first = items_.extract(items_.begin());
        bytes_ -= first.value().bytes;
        return std::move(first.value().item);
    }
    /// The one that comes next.
    const Item* earliest() const { return items_.empty() ? nullptr : &items_.begin()->item; }

  private:
    struct Entry {
        std::uint64_t turn;
        std::int64_t stamp_ns;
        std::uint64_t arrival;
        std::size_t bytes;
        Item item;
        bool operator<(const Entry& other) const {
            return std::tie(turn, stamp_ns, arrival) <
                   std::tie(other.turn, other.stamp_ns, other.arrival);
        }
    };
    std::size_t most_items_;
    std::size_t most_bytes_;
    std::size_t bytes_ = 0;
    std::uint64_t arrivals_ = 0;
    std::multiset<Entry> items_;
};

}  // namespace hitos
