// SPDX-License-Identifier: GPL-3.0-or-later
// What waits for a client, which may read slowly, not at all, or talk nonsense: of each channel the
// newest message, and some words.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "live_request.hpp"
#include "live_stage.hpp"

namespace hitos::live {

class Mailbox {
  public:
    static constexpr std::size_t kMostTexts = 64;  ///< that wait; more are left out
    static constexpr int kMostWrong = 100;         ///< requests of a client

    explicit Mailbox(Stage& stage);

    /// What the client says.
    void take(std::string_view text);
    /// It says nothing that could be taken.
    void complain(const std::string& words);
    /// It goes on saying so.
    bool hopeless() const { return wrong_ > kMostWrong; }

    bool wants(std::size_t channel) const { return subscriptions_[channel].has_value(); }
    void offer(std::size_t channel, std::shared_ptr<const Payload> payload);
    void put_text(std::string text);

    /// What is sent of it: a text, or a header and the payload.
    struct Message {
        std::string text;
        std::array<unsigned char, 13> header{};
        std::shared_ptr<const Payload> payload;  ///< null: it is a text
    };
    /// Texts first, then the channels in turn, so that none waits for the others for ever.
    std::optional<Message> next();

  private:
    bool subscribe(std::uint32_t id, std::uint32_t channel);
    bool unsubscribe(std::uint32_t id);

    Stage& stage_;
    std::vector<std::optional<std::uint32_t>> subscriptions_;  // the id, by channel
    std::vector<std::shared_ptr<const Payload>> waiting_;      // likewise
    std::deque<std::string> texts_;
    std::size_t turn_ = 0;
    int wrong_ = 0;
};

}  // namespace hitos::live
