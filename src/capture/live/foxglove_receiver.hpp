// SPDX-License-Identifier: GPL-3.0-or-later
// Receives what a running robot tells by the Foxglove WebSocket protocol, as foxglove_bridge does.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>

#include "hitos/base/message.hpp"
#include "live/foxglove_frames.hpp"
#include "live/received_mcap.hpp"
#include "live/websocket.hpp"

namespace hitos {

/// Asks for every topic of lasers, odometry and transforms, and hands on what comes as the bytes of
/// an MCAP. A connection that is lost is looked for again.
class FoxgloveReceiver {
  public:
    using Put = std::function<void(std::string_view bytes)>;
    using News = std::function<void(Message news)>;

    /// Connects. Throws ConfigError where the address is none, FileError where nobody answers or
    /// somebody who does not speak the protocol.
    FoxgloveReceiver(std::string url, std::chrono::seconds patience);

    /// Until it is asked to stop, or a lost connection was not found again for as long as patience
    /// goes. Throws what `put` throws.
    void receive(const std::stop_token& stop, const Put& put, const News& news);

  private:
    void take(const WebSocket::Frame& frame, const Put& put, const News& news);
    void take_text(std::string_view text, const Put& put, const News& news);
    /// False where it is over.
    bool connect_again(const std::stop_token& stop, const News& news);

    std::string url_;
    WebSocketAddress address_;
    std::chrono::seconds patience_;
    std::unique_ptr<WebSocket> socket_;
    ReceivedMcap mcap_;
    std::map<std::uint32_t, std::uint16_t> topics_;         ///< of the file, by subscription
    std::map<std::uint64_t, std::uint32_t> subscriptions_;  ///< by channel
    std::set<std::string> told_;                            ///< topics
    std::uint32_t last_subscription_ = 0;
    std::uint64_t malformed_ = 0;
    bool offered_ = false;  // what there is was told
    // Since the last message of a topic, or the beginning.
    std::chrono::steady_clock::time_point silent_since_ = std::chrono::steady_clock::now();
    int tries_ = 0;
};

}  // namespace hitos
