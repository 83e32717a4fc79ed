// SPDX-License-Identifier: GPL-3.0-or-later
// Writes MCAP, the container of ROS 2 recordings [mcap.dev/spec].
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hitos {

using McapWords = std::map<std::string, std::string>;

/// What is said of a topic.
struct McapTopic {
    std::string name;
    std::string type;        ///< by ROS 2's names: "sensor_msgs/msg/LaserScan"
    std::string definition;  ///< of the type, with those that it is made of
    McapWords metadata;
};

/// Messages in chunks of zstd, with every index, sum and count that a reader may want. The bytes of
/// the file are appended to what the caller gives; memory holds one chunk, and some hundred bytes
/// for each one before.
class McapOut {
  public:
    McapOut();
    ~McapOut();
    McapOut(const McapOut&) = delete;
    McapOut& operator=(const McapOut&) = delete;

    /// What the file begins with; `library` is the program's name and version.
    void begin(std::string& out, std::string_view library);
    /// Words that are no message, by a name.
    void put_metadata(std::string& out, std::string_view name, const McapWords& words);
    /// A topic that messages can be put on by the number that is given back.
    std::size_t add(McapTopic topic);
    void put_message(std::string& out, std::size_t topic, std::uint64_t time_ns,
                     std::string_view bytes);
    /// The last chunk and the summary; nothing may follow.
    void finish(std::string& out);

  private:
    struct Times {
        std::uint64_t first_ns = 0;
        std::uint64_t last_ns = 0;
        std::uint64_t messages = 0;
        void take(std::uint64_t time_ns);
    };
    struct Channel {
        McapTopic topic;
        std::uint16_t schema = 0;  ///< 0 as long as there is no message
        std::uint32_t messages = 0;
        std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  ///< of the chunk: time, place
    };
    struct Packer;

    void tell(Channel& channel, std::uint16_t id);
    void close_chunk();
    void put_summary();
    void hand_out(std::string& out);
    /// Of the next byte, from the beginning of the file.
    std::uint64_t position() const { return handed_out_ + part_.size(); }

    std::unique_ptr<Packer> packer_;
    std::string part_;  ///< of the file, not handed out yet
    std::uint64_t handed_out_ = 0;
    std::uint32_t sum_ = 0;  ///< of all that was handed out
    std::vector<Channel> channels_;
    std::vector<std::string> schemas_;  ///< their records
    std::string chunk_;                 ///< its records
    Times chunk_times_;
    Times times_;
    std::string chunk_indexes_;     ///< their records
    std::string metadata_indexes_;  ///< their records
    std::uint32_t chunks_ = 0;
    std::uint32_t metadata_ = 0;
};

}  // namespace hitos
