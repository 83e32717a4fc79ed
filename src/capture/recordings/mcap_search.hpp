// SPDX-License-Identifier: GPL-3.0-or-later
// Where MCAP's records stand one behind the other again, behind a length that is damaged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "recordings/mcap_ops.hpp"

namespace hitos {

class McapSearch {
  public:
    /// Reads at a byte of the file; gives how many bytes there were.
    using ReadAt = std::function<std::size_t(std::uint64_t offset, std::span<char> out)>;
    /// Whether a channel was described.
    using Knows = std::function<bool(std::uint16_t channel)>;

    /// `chunks`: the file's messages are in chunks, whose content, where it is not packed, looks
    /// like a file itself.
    /// `grows`: what it ends with now is not its end.
    McapSearch(ReadAt read_at, Knows knows, bool chunks, bool grows)
        : read_at_(std::move(read_at)), knows_(std::move(knows)), chunks_(chunks), grows_(grows) {}

    /// The first byte from `begin` on at which several records stand, each where the one before
    /// ends, all before `end`.
    std::optional<std::uint64_t> find(std::uint64_t begin, std::uint64_t end) const;

  private:
    /// The byte behind a record that may be one by what it begins with.
    std::optional<std::uint64_t> behind(std::span<const char> head, std::uint64_t begin,
                                        std::uint64_t end, bool first) const;
    bool is_chain(std::uint64_t begin, std::uint64_t end) const;

    ReadAt read_at_;
    Knows knows_;
    bool chunks_;
    bool grows_;
};

}  // namespace hitos
