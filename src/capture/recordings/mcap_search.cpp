// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/mcap_search.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include "recordings/recording.hpp"

namespace hitos {
namespace {

constexpr std::size_t kRecordHead = 9;              // kind and length
constexpr std::size_t kLongHead = kRecordHead + 2;  // and a message's channel
constexpr std::size_t kBlock = std::size_t{1} << 16;
constexpr int kChain = 3;  // records that chance does not put together
constexpr std::uint64_t kLargestImage = 4 * kLargestMessage;

/// What a record of the kind has at least and at the most; nothing has so little as {1, 0}.
struct Lengths {
    std::uint64_t least = 1;
    std::uint64_t most = 0;
};

Lengths lengths_of(McapOp op) {
    constexpr std::uint64_t kSome = std::uint64_t{1} << 24;
    switch (op) {
        case McapOp::schema:
            return {14, kSome};
        case McapOp::channel:
            return {16, kSome};
        case McapOp::message:
            return {22, kLargestImage};
        case McapOp::chunk:
            return {40, 2 * kLargestChunk};
        case McapOp::message_index:
            return {6, kSome};
        case McapOp::metadata:
            return {8, kSome};
        case McapOp::footer:
            return {20, 20};
        case McapOp::data_end:
            return {4, 4};
        default:
            return {};
    }
}

bool is_content(McapOp op) {
    return op == McapOp::schema || op == McapOp::channel || op == McapOp::message;
}

}  // namespace

std::optional<std::uint64_t> McapSearch::behind(std::span<const char> head, std::uint64_t begin,
                                                std::uint64_t end, bool first) const {
    const auto op = static_cast<McapOp>(head.front());
    const auto [least, most] = lengths_of(op);
    if (least > most || (chunks_ && is_content(op))) return std::nullopt;
    if (first && (op == McapOp::footer || op == McapOp::data_end)) return std::nullopt;
    std::uint64_t length = 0;
    std::memcpy(&length, head.data() + 1, sizeof length);
    if (length < least || length > most || length > end - begin - kRecordHead) return std::nullopt;
    std::uint16_t channel = 0;
    std::memcpy(&channel, head.data() + kRecordHead, sizeof channel);
    if (op == McapOp::message && !knows_(channel)) return std::nullopt;
    return begin + kRecordHead + length;
}

bool McapSearch::is_chain(std::uint64_t begin, std::uint64_t end) const {
    for (int records = 0; records < kChain; ++records) {
        std::array<char, kLongHead> head{};
        const std::size_t there = std::min<std::uint64_t>(end - begin, head.size());
        const std::size_t got = read_at_(begin, std::span(head).first(there));
        if (std::string_view(head.data(), got).starts_with(kMcapMagic)) return records > 1;
        if (got < kLongHead) return false;
        const auto next = behind(head, begin, end, records == 0);
        if (!next) return false;
        begin = *next;
        if (begin == end && !grows_) return records > 0;
    }
    return true;
}

std::optional<std::uint64_t> McapSearch::find(std::uint64_t begin, std::uint64_t end) const {
    std::vector<char> block(kBlock + kLongHead);
    while (begin + kLongHead <= end) {
        const std::size_t wanted = std::min<std::uint64_t>(end - begin, block.size());
        const std::size_t got = read_at_(begin, std::span(block).first(wanted));
        if (got < kLongHead) break;
        for (std::size_t at = 0; at + kLongHead <= got; ++at) {
            const auto head = std::span<const char>(block).subspan(at, kLongHead);
            if (behind(head, begin + at, end, true) && is_chain(begin + at, end)) return begin + at;
        }
        begin += got - kLongHead + 1;
    }
    return std::nullopt;
}

}  // namespace hitos
