// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_mailbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "live_channels.hpp"

namespace hitos::live {
namespace {

/// Of a message with data: its kind, the subscription and the time, lowest byte first.
std::array<unsigned char, 13> header_of(std::uint32_t subscription, std::uint64_t time) {
    constexpr unsigned char kMessageData = 1;
    std::array<unsigned char, 13> header{kMessageData};
    std::size_t at = 1;
    const auto put = [&](std::uint64_t value, unsigned bytes) {
        for (unsigned i = 0; i < bytes; ++i) {
            header[at++] = static_cast<unsigned char>(value >> (8U * i) & 255U);
        }
    };
    put(subscription, sizeof(subscription));
    put(time, sizeof(time));
    return header;
}

}  // namespace

Mailbox::Mailbox(Stage& stage)
    : stage_(stage), subscriptions_(channels().size()), waiting_(channels().size()) {}

void Mailbox::take(std::string_view text) {
    const Request request = parsed_request(text);
    if (!request.wrong.empty()) {
        complain(request.wrong);
        return;
    }
    if (request.unknown) {
        put_text(status(StatusLevel::warning,
                        fmt::format("op \"{}\" is not known; this server knows subscribe and "
                                    "unsubscribe",
                                    *request.unknown)));
    }
    for (const auto& [id, channel] : request.subscribe) {
        if (!subscribe(id, channel)) break;
    }
    for (const std::uint32_t id : request.unsubscribe) {
        if (!unsubscribe(id)) break;
    }
}

void Mailbox::complain(const std::string& words) {
    ++wrong_;
    put_text(status(StatusLevel::error, words));
}

bool Mailbox::subscribe(std::uint32_t id, std::uint32_t channel) {
    std::string wrong;
    if (channel >= subscriptions_.size()) {
        wrong = fmt::format("there is no channel {}; expected 0 to {}", channel,
                            subscriptions_.size() - 1);
    } else if (subscriptions_[channel]) {
        wrong = fmt::format("channel {} is subscribed to already", channel);
    } else if (std::ranges::count(subscriptions_, std::optional(id)) > 0) {
        wrong = fmt::format("subscription {} is there already", id);
    }
    if (!wrong.empty()) {
        complain(wrong);
        return false;
    }
    subscriptions_[channel] = id;
    offer(channel, stage_.payload(channel));
    return true;
}

bool Mailbox::unsubscribe(std::uint32_t id) {
    const auto found = std::ranges::find(subscriptions_, std::optional(id));
    if (found == subscriptions_.end()) {
        complain(fmt::format("there is no subscription {}", id));
        return false;
    }
    found->reset();
    waiting_[static_cast<std::size_t>(found - subscriptions_.begin())].reset();
    return true;
}

void Mailbox::offer(std::size_t channel, std::shared_ptr<const Payload> payload) {
    if (wants(channel) && payload) waiting_[channel] = std::move(payload);
}

void Mailbox::put_text(std::string text) {
    if (texts_.size() < kMostTexts) texts_.push_back(std::move(text));
}

std::optional<Mailbox::Message> Mailbox::next() {
    if (!texts_.empty()) {
        Message message;
        message.text = std::move(texts_.front());
        texts_.pop_front();
        return message;
    }
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
        const std::size_t channel = (turn_ + i) % waiting_.size();
        if (!waiting_[channel]) continue;
        turn_ = channel + 1;
        Message message;
        message.header = header_of(*subscriptions_[channel], waiting_[channel]->time_ns);
        message.payload = std::exchange(waiting_[channel], nullptr);
        return message;
    }
    return std::nullopt;
}

}  // namespace hitos::live
