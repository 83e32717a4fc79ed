// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/foxglove_frames.hpp"

#include <cstring>
#include <nlohmann/json.hpp>

#include "hitos/base/error.hpp"
#include "hitos/base/message.hpp"
#include "hitos/base/translatable.hpp"
#include "recordings/recording.hpp"

namespace hitos {
namespace {

using nlohmann::json;

constexpr int kDeepest = 32;                                      // of nested JSON
constexpr std::size_t kLongestDefinition = std::size_t{1} << 20;  // of a type

[[noreturn]] void fail(const Message& what) {
    throw FormatError({}, 0, HITOS_TEXT("Errors", "found a frame that is not of the protocol: %1"),
                      what);
}

const json& member(const json& object, const char* key, json::value_t kind) {
    const auto found = object.find(key);
    if (found == object.end() || found->type() != kind)
        fail(message(HITOS_TEXT("Errors", "\"%1\" is missing or of another kind"), key));
    return *found;
}

std::uint64_t number(const json& value) {
    if (!value.is_number_unsigned())
        fail(message(HITOS_TEXT("Errors", "\"%1\" is missing or of another kind"), "id"));
    return value.get<std::uint64_t>();
}

std::string word(const json& object, const char* key, std::size_t most = kLongestWord) {
    const auto& text = member(object, key, json::value_t::string).get_ref<const std::string&>();
    if (text.size() > most) {
        fail(message(HITOS_TEXT("Errors", "found a length of %1 bytes, expected at most %2"),
                     text.size(), most));
    }
    return text;
}

FoxgloveChannel channel_of(const json& told) {
    if (!told.is_object()) fail(message(HITOS_TEXT("Errors", "a channel is no object")));
    FoxgloveChannel channel;
    channel.id = number(member(told, "id", json::value_t::number_unsigned));
    channel.topic.name = word(told, "topic");
    channel.topic.encoding = word(told, "encoding");
    channel.topic.type = word(told, "schemaName");
    channel.topic.definition = word(told, "schema", kLongestDefinition);
    const bool said = told.contains("schemaEncoding") && told["schemaEncoding"].is_string();
    channel.topic.definition_encoding = said ? word(told, "schemaEncoding")
                                        : channel.topic.encoding == "cdr" ? "ros2msg"
                                                                          : "ros1msg";
    return channel;
}

/// Parsed no deeper than the protocol goes, whatever comes.
json parsed(std::string_view text) {
    bool deep = false;
    const auto shallow = [&deep](int depth, json::parse_event_t, const json&) {
        deep = deep || depth > kDeepest;
        return !deep;
    };
    json said = json::parse(text, shallow, false);
    if (said.is_discarded() || deep || !said.is_object())
        fail(message(HITOS_TEXT("Errors", "it is no JSON object")));
    return said;
}

}  // namespace

FoxgloveSaid foxglove_said(std::string_view text) {
    const json said = parsed(text);
    const std::string op = word(said, "op");
    FoxgloveSaid found;
    if (op == "serverInfo") {
        found.server = word(said, "name");
    } else if (op == "advertise") {
        for (const json& told : member(said, "channels", json::value_t::array)) {
            try {
                found.channels.push_back(channel_of(told));
            } catch (const FormatError& error) {  // the others may be of use
                found.problems.push_back(error.problem());
            }
        }
    } else if (op == "unadvertise") {
        for (const json& id : member(said, "channelIds", json::value_t::array))
            found.gone.push_back(number(id));
    } else if (op == "status") {
        const bool grave = number(member(said, "level", json::value_t::number_unsigned)) > 0;
        if (grave) found.alarm = word(said, "message", kLongestDefinition);
    }
    return found;
}

std::optional<FoxgloveMessage> foxglove_message(std::string_view frame) {
    constexpr char kMessageData = 0x01;
    if (frame.empty()) fail(message(HITOS_TEXT("Errors", "it is empty")));
    if (frame.front() != kMessageData) return std::nullopt;  // times, answers
    frame.remove_prefix(1);
    FoxgloveMessage found;
    if (frame.size() < sizeof found.subscription + sizeof found.received_ns)
        fail(message(HITOS_TEXT("Errors", "the data end early")));
    std::memcpy(&found.subscription, frame.data(), sizeof found.subscription);
    frame.remove_prefix(sizeof found.subscription);
    std::memcpy(&found.received_ns, frame.data(), sizeof found.received_ns);
    frame.remove_prefix(sizeof found.received_ns);
    found.bytes = frame;
    return found;
}

std::string foxglove_subscribe(
    const std::vector<std::pair<std::uint32_t, std::uint64_t>>& subscriptions) {
    json asked{{"op", "subscribe"}, {"subscriptions", json::array()}};
    for (const auto& [id, channel] : subscriptions)
        asked["subscriptions"].push_back({{"id", id}, {"channelId", channel}});
    return asked.dump();
}

}  // namespace hitos
