// SPDX-License-Identifier: GPL-3.0-or-later
// Walks over a message in ROS 1's serialisation [wiki.ros.org/msg] or in CDR [OMG DDS-XTypes 7.4],
// which aligns numbers to their size and ends texts by a zero.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "hitos/base/message.hpp"
#include "recordings/recording.hpp"

namespace hitos {

class MessageBytes {
  public:
    /// Throws FormatError where the head of a CDR message is missing or of an unknown kind.
    MessageBytes(std::string_view bytes, Encoding encoding);

    bool is_cdr() const { return cdr_; }
    /// The takers name the field in FormatError where the bytes end before.
    template <class Number>
    Number take(const char* field) {
        std::size_t alignment = sizeof(Number);
        if (alignment > greatest_alignment_) alignment = greatest_alignment_;
        if (cdr_) at_ += (alignment - at_ % alignment) % alignment;
        std::array<char, sizeof(Number)> raw;
        std::memcpy(raw.data(), need(sizeof(Number), field), sizeof(Number));
        if (swapped_) std::ranges::reverse(raw);
        Number value;
        std::memcpy(&value, raw.data(), sizeof(Number));
        return value;
    }
    std::string text(const char* field);
    /// How many items of at least so many bytes follow: no more than there is room for.
    std::uint32_t count(std::size_t item_bytes, const char* field);
    /// Passes over items of one size.
    void pass(std::size_t items, std::size_t item_bytes, const char* field);
    /// Throws where more is left than padding.
    void expect_end() const;

    /// A finite number of believable size. Throws FormatError.
    static double checked(double value, const char* field);

  private:
    const char* need(std::size_t bytes, const char* field);

    std::string_view bytes_;
    std::size_t at_ = 0;
    bool cdr_ = false;
    bool swapped_ = false;
    std::size_t greatest_alignment_ = 8;
};

}  // namespace hitos
