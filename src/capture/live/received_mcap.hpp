// SPDX-License-Identifier: GPL-3.0-or-later
// What comes in over a network, as an MCAP that is whole at every moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hitos {

/// A topic as whoever sends it describes it.
struct ReceivedTopic {
    std::string name;
    std::string encoding;  ///< of its messages: "cdr", "ros1"
    std::string type;      ///< "sensor_msgs/msg/LaserScan"
    std::string definition_encoding;
    std::string definition;
    friend bool operator==(const ReceivedTopic&, const ReceivedTopic&) = default;
};

/// Every message stands by itself, neither packed nor in a chunk, so that who reads along has it at
/// once and a file that was broken off lacks nothing that came before. The file's bytes are
/// appended to what the caller gives.
class ReceivedMcap {
  public:
    static void begin(std::string& out);
    /// The number by which messages are put on it; the same where it is known already.
    std::uint16_t add(std::string& out, const ReceivedTopic& topic);
    void put_message(std::string& out, std::uint16_t topic, std::uint64_t time_ns,
                     std::string_view bytes);
    /// Nothing may follow.
    static void finish(std::string& out);

  private:
    std::vector<ReceivedTopic> topics_;
    std::vector<std::uint32_t> messages_;
};

}  // namespace hitos
