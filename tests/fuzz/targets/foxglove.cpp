// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a server that a running robot is heard by.
#include <optional>
#include <string>

#include "laws.hpp"
#include "live/foxglove_frames.hpp"
#include "live/received_mcap.hpp"
#include "recordings/recording.hpp"
#include "targets.hpp"

namespace hitos::fuzz {
namespace {

/// What is asked of a server is what it understands, whatever its channels are called.
void require_kept(const FoxgloveChannel& channel) {
    const static ScratchFolder folder;
    std::string file;
    ReceivedMcap mcap;
    ReceivedMcap::begin(file);
    const std::uint16_t topic = mcap.add(file, channel.topic);
    require(mcap.add(file, channel.topic) == topic, "a topic has one number");
    mcap.put_message(file, topic, channel.id, "bytes");
    ReceivedMcap::finish(file);
    folder.put("kept.mcap", file);
    Topics topics([](const Topic&) { return true; });
    const auto recording = open_mcap(folder.path() / "kept.mcap", {topics, true});
    const std::optional<RecordedMessage> found = recording->next();
    require(found && found->bytes == "bytes" && found->topic->name == channel.topic.name &&
                found->topic->encoding == channel.topic.encoding,
            "what is received is read again");
    require(!recording->next() && !recording->take_problem(), "and nothing else");
}

}  // namespace

bool check_foxglove(std::string_view input) {
    if (input.empty()) return false;
    const bool binary = input.front() == 'b';
    input.remove_prefix(1);
    if (binary) {
        const auto message = unless_refused([&] { return foxglove_message(input); });
        if (!message || !*message) return false;
        require((*message)->bytes.size() + 13 == input.size(), "a message is all that follows");
        return true;
    }
    const auto said = unless_refused([&] { return foxglove_said(input); });
    if (!said) return false;
    for (std::size_t i = 0; i < said->channels.size() && i < 4; ++i)
        require_kept(said->channels[i]);
    return true;
}

}  // namespace hitos::fuzz
