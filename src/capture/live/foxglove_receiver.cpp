// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/foxglove_receiver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "recordings/recording.hpp"
#include "ros/survey.hpp"

namespace hitos {
namespace {

/// The older name of the protocol, and that of its newer servers; what is used is the same in both.
constexpr const char* kProtocols = "foxglove.websocket.v1, foxglove.sdk.v1";

RecordedTopic offer_of(const ReceivedTopic& topic) {
    Topics topics([](const Topic& told) { return use_of(told) != TopicUse::none; });
    const Topic& told = topics.of(topic.name, topic.type, topic.encoding);
    return {.name = told.name, .type = told.type, .use = use_of(told)};
}

}  // namespace

FoxgloveReceiver::FoxgloveReceiver(std::string url, std::chrono::seconds patience,
                                   const WebSocket::GoesOn& goes_on, std::chrono::seconds silence)
    : url_(std::move(url)),
      address_(url_),
      patience_(patience),
      silence_(silence),
      socket_(std::make_unique<WebSocket>(address_, url_, kProtocols, goes_on)) {}

void FoxgloveReceiver::receive(const std::stop_token& stop, const Put& put, const News& news) {
    std::string bytes;
    ReceivedMcap::begin(bytes);
    put(bytes);
    while (!stop.stop_requested()) {
        std::optional<Message> problem;
        try {
            if (const std::optional<WebSocket::Frame> frame = socket_->next())
                take(*frame, put, news);
            tell_silence(news);
            continue;
        } catch (const ConnectionError& error) {
            problem = error.why();
        }
        socket_.reset();
        {
            const std::scoped_lock lock(mutex_);
            link_.connected = false;
            ++link_.losses;
        }
        news(message(HITOS_TEXT("Errors", "%1; it is looked for again"), *problem));
        if (!connect_again(stop, news)) break;
    }
    bytes.clear();
    ReceivedMcap::finish(bytes);
    put(bytes);
}

bool FoxgloveReceiver::connect_again(const std::stop_token& stop, const News& news) {
    using Clock = std::chrono::steady_clock;
    using namespace std::chrono_literals;
    const Clock::time_point lost = Clock::now();
    if (tries_ == 0) silent_since_ = lost;
    topics_.clear();
    subscriptions_.clear();
    for (std::optional<Message> why; !stop.stop_requested();) {
        // At once, then after longer and longer, also where a connection that came about said
        // nothing.
        const auto pause = std::min<std::chrono::milliseconds>(100ms * tries_ * tries_, 2s);
        for (auto left = pause; left > 0ms && !stop.stop_requested(); left -= 20ms)
            std::this_thread::sleep_for(std::min<std::chrono::milliseconds>(left, 20ms));
        if (tries_++ > 0 && Clock::now() - silent_since_ > patience_) {
            news(message(
                HITOS_TEXT("Errors", "%1; it was looked for for %2 s, and the tour ends here"),
                why.value_or(marked(HITOS_TEXT("Errors", "the server says nothing"))),
                patience_.count()));
            const std::scoped_lock lock(mutex_);
            link_.given_up = true;
            return false;
        }
        try {
            socket_ = std::make_unique<WebSocket>(address_, url_, kProtocols,
                                                  [&stop] { return !stop.stop_requested(); });
            const double seconds = std::chrono::duration<double>(Clock::now() - lost).count();
            {
                const std::scoped_lock lock(mutex_);
                link_.connected = true;
            }
            news(message(HITOS_TEXT("Errors", "connected again after %1 s"),
                         std::round(10.0 * seconds) / 10.0));
            return true;
        } catch (const ConnectionError& error) {
            why = error.why();
        }
    }
    return false;
}

void FoxgloveReceiver::take(const WebSocket::Frame& frame, const Put& put, const News& news) {
    try {
        if (!frame.whole()) {
            tell_too_large(frame, news);
            return;
        }
        if (frame.text) {
            take_text(frame.bytes, put, news);
            return;
        }
        const std::optional<FoxgloveMessage> found = foxglove_message(frame.bytes);
        if (!found) return;
        const auto topic = topics_.find(found->subscription);
        if (topic == topics_.end()) return;  // of one that was given up
        std::string bytes;
        mcap_.put_message(bytes, topic->second.number, found->received_ns, found->bytes);
        came_ = true;
        put(bytes);
        tries_ = 0;
        const std::scoped_lock lock(mutex_);
        ++topic->second.offer->messages;
    } catch (const FormatError& error) {
        constexpr std::uint64_t kTold = 10;
        const std::scoped_lock lock(mutex_);
        if (++link_.passed_over <= kTold) news(error.problem());
    }
}

std::vector<RecordedTopic> FoxgloveReceiver::topics() const {
    const std::scoped_lock lock(mutex_);
    std::vector<RecordedTopic> all;
    all.reserve(offers_.size());
    for (const auto& [name, topic] : offers_) all.push_back(topic);
    return all;
}

LinkState FoxgloveReceiver::link() const {
    const std::scoped_lock lock(mutex_);
    return link_;
}

RecordedTopic* FoxgloveReceiver::note_offer(const ReceivedTopic& topic) {
    const std::scoped_lock lock(mutex_);
    RecordedTopic& known = offers_[topic.name];
    if (RecordedTopic now = offer_of(topic); now.type != known.type) known = std::move(now);
    return &known;
}

void FoxgloveReceiver::tell_too_large(const WebSocket::Frame& frame, const News& news) {
    std::string what = "JSON";
    if (!frame.text) {
        const std::optional<FoxgloveMessage> found = foxglove_message(frame.bytes);
        const auto topic = found ? topics_.find(found->subscription) : topics_.end();
        what = topic == topics_.end() ? "?" : topic->second.offer->name;
    }
    {
        const std::scoped_lock lock(mutex_);
        ++link_.passed_over;
    }
    if (!too_large_.insert(what).second) return;
    news(message(HITOS_TEXT("Errors",
                            "%1: a message of %2 bytes is passed over, and so is every one of more "
                            "than %3; have the robot tell less at a time"),
                 verbatim(what), frame.size, WebSocket::kLargest));
}

void FoxgloveReceiver::tell_silence(const News& news) {
    const auto silence = std::chrono::steady_clock::now() - waits_since_;
    if (came_ || told_silence_ || silence < silence_) return;
    if (offered_ && topics_.empty()) return;  // that was told
    told_silence_ = true;
    news(offered_ ? message(HITOS_TEXT("Errors",
                                       "nothing has come yet of the topics that are received; it "
                                       "is waited for: does the laser run?"))
                  : message(HITOS_TEXT("Errors",
                                       "the server offers no topic yet; they are waited for: does "
                                       "what drives the robot run?")));
}

void FoxgloveReceiver::take_text(std::string_view text, const Put& put, const News& news) {
    const FoxgloveSaid said = foxglove_said(text);
    if (said.alarm)
        news(message(HITOS_TEXT("Errors", "the server says: %1"), verbatim(*said.alarm)));
    for (const std::uint64_t id : said.gone) {
        const auto known = subscriptions_.find(id);
        if (known == subscriptions_.end()) continue;
        topics_.erase(known->second);
        subscriptions_.erase(known);
    }
    for (const Message& problem : said.problems) news(problem);
    std::vector<std::pair<std::uint32_t, std::uint64_t>> asked;
    bool laser = false;  // that can be read
    std::string offered;
    for (const FoxgloveChannel& channel : said.channels) {
        if (offered.size() < kLongestWord) offered += offered.empty() ? "" : ", ";
        if (offered.size() < kLongestWord) offered += channel.topic.name;
        RecordedTopic* offer = note_offer(channel.topic);
        laser = laser || offer->use == TopicUse::scans;
        if (subscriptions_.contains(channel.id) || offer->use == TopicUse::none) continue;
        std::string bytes;
        const std::uint16_t topic = mcap_.add(bytes, channel.topic);
        if (!bytes.empty()) put(bytes);
        asked.emplace_back(++last_subscription_, channel.id);
        subscriptions_.emplace(channel.id, last_subscription_);
        topics_.emplace(last_subscription_, Subscribed{topic, offer});
        if (told_.insert(channel.topic.name).second) {
            news(message(HITOS_TEXT("Errors", "receives %1 (%2)"), verbatim(channel.topic.name),
                         verbatim(channel.topic.type)));
        }
    }
    if (!asked.empty() && !came_) {  // from here on messages are waited for
        told_silence_ = false;
        waits_since_ = std::chrono::steady_clock::now();
    }
    if (!said.channels.empty() && !std::exchange(offered_, true) && !laser) {
        news(message(
            HITOS_TEXT("Errors", "no laser (sensor_msgs/LaserScan) is offered yet; there are: %1"),
            verbatim(offered)));
    }
    if (!asked.empty()) socket_->send(foxglove_subscribe(asked));
}

}  // namespace hitos
