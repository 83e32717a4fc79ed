// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/message_bytes.hpp"

#include <cmath>

#include "fields.hpp"
#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// Words longer than any frame's name are damage.
constexpr std::uint32_t kLongestName = 4096;

}  // namespace

MessageBytes::MessageBytes(std::string_view bytes, Encoding encoding)
    : bytes_(bytes), cdr_(encoding == Encoding::cdr) {
    static_assert(std::endian::native == std::endian::little);
    if (!cdr_) return;
    constexpr std::size_t kHead = 4;
    const auto kind = bytes.size() < kHead
                          ? 0xffffU
                          : static_cast<unsigned>(static_cast<unsigned char>(bytes[0])) << 8 |
                                static_cast<unsigned char>(bytes[1]);
    constexpr std::string_view kZstd = "\x28\xb5\x2f\xfd";
    if (bytes.starts_with(kZstd)) {
        throw FormatError(
            {}, 0,
            HITOS_TEXT(
                "Errors",
                "the message is compressed by itself (rosbag2's compression_mode MESSAGE), which "
                "Hitos does not read; convert the recording with \"ros2 bag convert\""));
    }
    constexpr unsigned kPlain2 = 6;  // as 0 and 1, but for numbers of 8 bytes
    if (kind > 1 && kind != kPlain2 && kind != kPlain2 + 1) {
        throw FormatError({}, 0, HITOS_TEXT("Errors", "the message does not begin as CDR does"));
    }
    swapped_ = kind % 2 == 0;
    if (kind >= kPlain2) greatest_alignment_ = 4;
    bytes_.remove_prefix(kHead);
}

const char* MessageBytes::need(std::size_t bytes, const char* field) {
    if (at_ > bytes_.size() || bytes > bytes_.size() - at_) {
        throw FormatError({}, 0, HITOS_TEXT("Errors", "the message ends in the field \"%1\""),
                          field);
    }
    const char* place = bytes_.data() + at_;
    at_ += bytes;
    return place;
}

std::string MessageBytes::text(const char* field) {
    const auto length = take<std::uint32_t>(field);
    if (length > kLongestName) {
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors", "field \"%1\": found %2 bytes, expected at most %3"),
                          field, length, kLongestName);
    }
    std::string_view text{need(length, field), length};
    if (cdr_ && text.ends_with('\0')) text.remove_suffix(1);
    return std::string(text);
}

std::uint32_t MessageBytes::count(std::size_t item_bytes, const char* field) {
    const auto items = take<std::uint32_t>(field);
    const std::size_t left = bytes_.size() - at_;
    if (items > left / item_bytes) {
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors",
                                     "field \"%1\": found a count of %2, expected at most %3, for "
                                     "which there are bytes"),
                          field, items, left / item_bytes);
    }
    return items;
}

void MessageBytes::pass(std::size_t items, std::size_t item_bytes, const char* field) {
    if (items == 0) return;
    if (cdr_) {
        const std::size_t alignment = std::min(item_bytes, greatest_alignment_);
        at_ += (alignment - at_ % alignment) % alignment;
    }
    need(items * item_bytes, field);
}

void MessageBytes::expect_end() const {
    constexpr std::size_t kPadding = 7;  // some writers of CDR round the length up
    const std::size_t left = bytes_.size() - at_;
    if (left <= (cdr_ ? kPadding : 0)) return;
    throw FormatError({}, 0, HITOS_TEXT("Errors", "%1 bytes are left behind the last field"), left);
}

double MessageBytes::checked(double value, const char* field) {
    if (std::abs(value) <= kGreatestValue) return value;
    throw FormatError(
        {}, 0, HITOS_TEXT("Errors", "field \"%1\": found %2, expected a finite number up to 1e12"),
        field, value);
}

}  // namespace hitos
