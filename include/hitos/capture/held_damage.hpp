// SPDX-License-Identifier: GPL-3.0-or-later
// Damage that was met in a source and is still to be told.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "hitos/base/message.hpp"

namespace hitos {

/// Reports are for people: beyond so many between two scans damage is only counted, so that a file
/// of nothing else costs no memory.
class HeldDamage {
  public:
    /// By the number of its line or message.
    void note(std::uint64_t number, Message reason) {
        if (held_.size() < kMost) {
            held_.emplace_back(number, std::move(reason));
        } else {
            ++untold_;
        }
    }
    /// The first that was not taken yet; the last one held stands for those that were only counted.
    std::optional<std::pair<std::uint64_t, Message>> take() {
        if (held_.empty()) return std::nullopt;
        if (held_.size() == 1 && untold_ > 0) {
            --untold_;
            return held_.front();
        }
        std::pair<std::uint64_t, Message> first = std::move(held_.front());
        held_.pop_front();
        return first;
    }

  private:
    static constexpr std::size_t kMost = 64;

    std::deque<std::pair<std::uint64_t, Message>> held_;
    std::uint64_t untold_ = 0;
};

}  // namespace hitos
