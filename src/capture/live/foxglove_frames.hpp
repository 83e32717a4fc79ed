// SPDX-License-Identifier: GPL-3.0-or-later
// What a server of the Foxglove WebSocket protocol says, and what is asked of it [Foxglove
// WebSocket protocol v1, docs/spec.md].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/base/message.hpp"
#include "live/received_mcap.hpp"

namespace hitos {

struct FoxgloveChannel {
    std::uint64_t id = 0;
    ReceivedTopic topic;
};

/// One frame of text. What it does not know of, and does not need, is left out.
struct FoxgloveSaid {
    std::optional<std::string> server;  ///< its name, which it tells first
    std::vector<FoxgloveChannel> channels;
    std::vector<Message> problems;     ///< of channels that are left out
    std::vector<std::uint64_t> gone;   ///< channels that are no longer there
    std::optional<std::string> alarm;  ///< a warning or an error of the server's
};

/// Throws FormatError where it is no JSON, or not what the protocol says.
FoxgloveSaid foxglove_said(std::string_view text);

/// One frame of bytes; nothing where it is no message of a topic. Throws FormatError where it ends
/// early.
struct FoxgloveMessage {
    std::uint32_t subscription = 0;
    std::uint64_t received_ns = 0;
    std::string_view bytes;  ///< of the frame
};
std::optional<FoxgloveMessage> foxglove_message(std::string_view frame);

/// Asks for channels; of each the number of the subscription and of the channel.
std::string foxglove_subscribe(
    const std::vector<std::pair<std::uint32_t, std::uint64_t>>& subscriptions);

}  // namespace hitos
