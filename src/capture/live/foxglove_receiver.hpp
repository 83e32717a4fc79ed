// SPDX-License-Identifier: GPL-3.0-or-later
// Receives what a running robot tells by the Foxglove WebSocket protocol, as foxglove_bridge does.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/live_source.hpp"
#include "hitos/capture/log_format.hpp"
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
    /// somebody who does not speak the protocol. What is waited for in vain for as long as
    /// `silence` is told.
    FoxgloveReceiver(
        std::string url, std::chrono::seconds patience,
        const WebSocket::GoesOn& goes_on = [] { return true; },
        std::chrono::seconds silence = std::chrono::seconds(5));

    /// Until it is asked to stop, or a lost connection was not found again for as long as patience
    /// goes. Throws what `put` throws.
    void receive(const std::stop_token& stop, const Put& put, const News& news);
    /// Whether a message of a topic came; for `put`.
    bool came() const { return came_; }

    // By any thread:
    /// What the server has offered, with how many messages have come.
    std::vector<RecordedTopic> topics() const;
    LinkState link() const;

  private:
    void take(const WebSocket::Frame& frame, const Put& put, const News& news);
    RecordedTopic* note_offer(const ReceivedTopic& topic);
    void take_text(std::string_view text, const Put& put, const News& news);
    /// Passed over; told once for each topic.
    void tell_too_large(const WebSocket::Frame& frame, const News& news);
    /// Once, what is waited for in vain.
    void tell_silence(const News& news);
    /// False where it is over.
    bool connect_again(const std::stop_token& stop, const News& news);

    std::string url_;
    WebSocketAddress address_;
    std::chrono::seconds patience_;
    std::chrono::seconds silence_;
    std::unique_ptr<WebSocket> socket_;
    ReceivedMcap mcap_;
    struct Subscribed {
        std::uint16_t number = 0;        ///< of the topic in the file
        RecordedTopic* offer = nullptr;  ///< among offers_
    };
    std::map<std::uint32_t, Subscribed> topics_;            ///< by subscription
    std::map<std::uint64_t, std::uint32_t> subscriptions_;  ///< by channel
    std::set<std::string> told_;                            ///< topics
    std::uint32_t last_subscription_ = 0;
    mutable std::mutex mutex_;
    std::map<std::string, RecordedTopic> offers_;  ///< guarded by it, by name
    LinkState link_;                               ///< likewise
    std::set<std::string> too_large_;              ///< topics that were told
    bool offered_ = false;                         // what there is was told
    bool came_ = false;                            // a message of a topic
    bool told_silence_ = false;                    // of what is waited for since
    std::chrono::steady_clock::time_point waits_since_ = std::chrono::steady_clock::now();
    // Since the last message of a topic, or the beginning.
    std::chrono::steady_clock::time_point silent_since_ = std::chrono::steady_clock::now();
    int tries_ = 0;
};

}  // namespace hitos
