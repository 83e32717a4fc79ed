// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/received_mcap.hpp"

#include <algorithm>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "recordings/mcap_records.hpp"
#include "recordings/recording.hpp"

namespace hitos {
namespace {

constexpr std::string_view kWriter = "Hitos " HITOS_VERSION;

}  // namespace

void ReceivedMcap::begin(std::string& out) {
    out += kMcapMagic;
    put_record(out, McapOp::header, [&] {
        put_text(out, "");  // messages of ROS 1 or 2
        put_text(out, kWriter);
    });
}

std::uint16_t ReceivedMcap::add(std::string& out, const ReceivedTopic& topic) {
    const auto known = std::ranges::find(topics_, topic);
    const auto number = static_cast<std::uint16_t>(known - topics_.begin() + 1);  // never 0
    if (known != topics_.end()) return number;
    if (topics_.size() == kMostTopics)
        throw FormatError({}, 0, HITOS_TEXT("Errors", "more than %1 topics"), kMostTopics);
    topics_.push_back(topic);
    messages_.push_back(0);
    put_record(out, McapOp::schema, [&] {
        put(out, number);
        put_text(out, topic.type);
        put_text(out, topic.definition_encoding);
        put_text(out, topic.definition);
    });
    put_record(out, McapOp::channel, [&] {
        put(out, number);
        put(out, number);
        put_text(out, topic.name);
        put_text(out, topic.encoding);
        put_words(out, {});
    });
    return number;
}

void ReceivedMcap::put_message(std::string& out, std::uint16_t topic, std::uint64_t time_ns,
                               std::string_view bytes) {
    put_record(out, McapOp::message, [&] {
        put(out, topic);
        put(out, messages_[topic - 1]++);
        put(out, time_ns);
        put(out, time_ns);
        out += bytes;
    });
}

void ReceivedMcap::finish(std::string& out) {
    put_record(out, McapOp::data_end, [&] { put(out, std::uint32_t{0}); });  // no sum
    put_record(out, McapOp::footer, [&] {
        put(out, std::uint64_t{0});  // no summary, nor where its parts are
        put(out, std::uint64_t{0});
        put(out, std::uint32_t{0});
    });
    out += kMcapMagic;
}

}  // namespace hitos
