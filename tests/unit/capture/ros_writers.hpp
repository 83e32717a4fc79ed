// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny writers of ROS messages and of what holds them: the tests' own reading of the formats.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hitos::test {

/// Bytes of a message or a record. Numbers are little-endian unless `big`; in CDR they are aligned.
class Bytes {
  public:
    static Bytes plain() { return {}; }
    static Bytes ros1() { return {}; }
    static Bytes cdr(bool big = false) {
        Bytes bytes;
        bytes.text_ = std::string{'\0', big ? '\0' : '\1', '\0', '\0'};
        bytes.cdr_ = true;
        bytes.big_ = big;
        return bytes;
    }

    bool is_cdr() const { return cdr_; }
    template <class Number>
    Bytes& put(Number value) {
        if (cdr_) {
            while ((text_.size() - 4) % sizeof value != 0) text_ += '\0';
        }
        std::array<char, sizeof value> raw;
        std::memcpy(raw.data(), &value, sizeof value);
        if (big_) std::ranges::reverse(raw);
        text_.append(raw.data(), sizeof value);
        return *this;
    }
    Bytes& u8(std::uint8_t value) { return put(value); }
    Bytes& u16(std::uint16_t value) { return put(value); }
    Bytes& u32(std::uint64_t value) { return put(static_cast<std::uint32_t>(value)); }
    Bytes& u64(std::uint64_t value) { return put(value); }
    Bytes& f32(double value) { return put(static_cast<float>(value)); }
    Bytes& f64(double value) { return put(value); }
    Bytes& raw(std::string_view bytes) {
        text_ += bytes;
        return *this;
    }
    /// Its length, then the text; CDR counts and writes a zero at the end.
    Bytes& word(std::string_view text) {
        u32(text.size() + (cdr_ ? 1 : 0)).raw(text);
        return cdr_ ? raw({"\0", 1}) : *this;
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    bool cdr_ = false;
    bool big_ = false;
};

struct Stamp {
    std::uint32_t seconds = 0;
    std::uint32_t nanoseconds = 0;
};

inline Bytes& put_header(Bytes& bytes, Stamp stamp, std::string_view frame) {
    if (!bytes.is_cdr()) bytes.u32(7);  // seq
    return bytes.u32(stamp.seconds).u32(stamp.nanoseconds).word(frame);
}

struct LaserFields {
    Stamp stamp;
    std::string frame = "laser";
    double min_angle = -0.5;
    double step = 0.5;
    double min_range = 0.05;
    double max_range = 8.0;
    std::vector<float> ranges = {1.0F, 2.0F, 3.0F};
    std::vector<float> intensities = {};
    double ray_time = 0.0;
};

inline std::string laser_message(const LaserFields& laser, Bytes bytes = Bytes::ros1()) {
    put_header(bytes, laser.stamp, laser.frame);
    const auto steps = static_cast<double>(laser.ranges.size()) - 1.0;
    for (const double value : {laser.min_angle, laser.min_angle + steps * laser.step, laser.step,
                               laser.ray_time, 0.1, laser.min_range, laser.max_range}) {
        bytes.f32(value);
    }
    for (const std::vector<float>* values : {&laser.ranges, &laser.intensities}) {
        bytes.u32(values->size());
        for (const float value : *values) bytes.put(value);
    }
    return bytes.text();
}

/// sensor_msgs/MultiEchoLaserScan: of each ray the reading, and another echo one metre behind it.
inline std::string multi_echo_message(const LaserFields& laser, Bytes bytes = Bytes::ros1()) {
    put_header(bytes, laser.stamp, laser.frame);
    const auto steps = static_cast<double>(laser.ranges.size()) - 1.0;
    for (const double value : {laser.min_angle, laser.min_angle + steps * laser.step, laser.step,
                               laser.ray_time, 0.1, laser.min_range, laser.max_range}) {
        bytes.f32(value);
    }
    for (const float behind : {1.0F, 0.0F}) {
        bytes.u32(laser.ranges.size());
        for (const float value : laser.ranges) {
            bytes.u32(std::isfinite(value) ? 2 : 0);
            if (std::isfinite(value)) bytes.put(value).put(value + behind);
        }
    }
    return bytes.text();
}

struct Placing {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double roll = 0.0;  ///< then yaw, about the fixed axes
    double yaw = 0.0;
};

inline Bytes& put_pose(Bytes& bytes, const Placing& p) {
    bytes.f64(p.x).f64(p.y).f64(p.z);
    const double cr = std::cos(p.roll / 2.0);
    const double sr = std::sin(p.roll / 2.0);
    const double cy = std::cos(p.yaw / 2.0);
    const double sy = std::sin(p.yaw / 2.0);
    return bytes.f64(sr * cy).f64(sr * sy).f64(cr * sy).f64(cr * cy);
}

inline std::string odometry_message(Stamp stamp, const Placing& pose, double v = 0.0,
                                    double w = 0.0, Bytes bytes = Bytes::ros1(),
                                    std::string_view child = "base_link") {
    put_header(bytes, stamp, "odom").word(child);
    put_pose(bytes, pose);
    for (int i = 0; i < 36; ++i) bytes.f64(0.25);
    for (const double value : {v, 0.0, 0.0, 0.0, 0.0, w}) bytes.f64(value);
    for (int i = 0; i < 36; ++i) bytes.f64(0.5);
    return bytes.text();
}

struct Link {
    Stamp stamp;
    std::string parent;
    std::string child;
    Placing placing;
};

inline std::string transforms_message(const std::vector<Link>& links, Bytes bytes = Bytes::ros1()) {
    bytes.u32(links.size());
    for (const Link& link : links) {
        put_header(bytes, link.stamp, link.parent).word(link.child);
        put_pose(bytes, link.placing);
    }
    return bytes.text();
}

/// One message of a recording. Types by ROS 1's names.
struct Said {
    std::string topic;
    std::string type;
    std::string bytes;
    std::uint64_t log_time_ns = 0;
};

/// Packs the content of a chunk.
struct Packing {
    std::string name;  ///< as the container says it
    std::string (*pack)(const std::string& content) = nullptr;
};

inline std::string unpacked(const std::string& content) {
    return content;
}

// A bag.

inline std::string bag_record(const std::vector<std::pair<std::string, std::string>>& fields,
                              std::string_view data) {
    Bytes header;
    for (const auto& [name, value] : fields) header.word(std::string(name).append("=") += value);
    return Bytes().word(header.text()).word(data).text();
}

inline std::string bag_connection(std::uint32_t id, const Said& said) {
    Bytes about;
    about.word("topic=" + said.topic).word("type=" + said.type).word("md5sum=*");
    about.word("message_definition=# comment = strange\nfloat64 w 1\n").word("callerid=/test");
    return bag_record({{"op", "\x07"}, {"conn", Bytes().u32(id).text()}, {"topic", said.topic}},
                      about.text());
}

inline std::string bag_of(const std::vector<Said>& all,
                          const Packing& packing = Packing{"none", unpacked},
                          std::size_t in_chunk = 4) {
    constexpr std::string_view kOpChunk = "\x05";
    constexpr std::uint64_t kSecond = 1'000'000'000;
    std::string body;
    std::vector<std::string> topics;
    std::string connections;
    for (std::size_t begin = 0; begin < all.size(); begin += in_chunk) {
        std::string content;
        for (std::size_t i = begin; i < std::min(all.size(), begin + in_chunk); ++i) {
            const Said& said = all[i];
            const auto known = std::find(topics.begin(), topics.end(), said.topic);
            const auto id = static_cast<std::uint32_t>(known - topics.begin());
            if (known == topics.end()) {
                topics.push_back(said.topic);
                content += bag_connection(id, said);
                connections += bag_connection(id, said);
            }
            content += bag_record(
                {{"op", "\x02"},
                 {"conn", Bytes().u32(id).text()},
                 {"time",
                  Bytes().u32(said.log_time_ns / kSecond).u32(said.log_time_ns % kSecond).text()}},
                said.bytes);
        }
        body += bag_record({{"op", std::string(kOpChunk)},
                            {"compression", packing.name},
                            {"size", Bytes().u32(content.size()).text()}},
                           packing.pack(content));
        body += bag_record({{"op", "\x04"}, {"ver", Bytes().u32(1).text()}}, "index");
    }
    const std::string magic = "#ROSBAG V2.0\n";
    const auto head = [&](std::uint64_t index) {
        return bag_record({{"op", "\x03"}, {"index_pos", Bytes().u64(index).text()}},
                          std::string(64, ' '));
    };
    const std::uint64_t index = magic.size() + head(0).size() + body.size();
    return magic + head(index) + body + connections;
}

// MCAP.

inline std::string mcap_record(std::uint8_t op, std::string_view content) {
    return Bytes().u8(op).u64(content.size()).raw(content).text();
}

inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

struct McapLayout {
    Packing packing;  ///< of chunks; without a name there are no chunks
    std::uint16_t first_channel = 0;
    std::size_t in_chunk = 4;
    std::uint32_t checksum = 0;  ///< told of every chunk; 0: none
    std::string encoding = "cdr";
};

inline std::string mcap_of(const std::vector<Said>& all, const McapLayout& layout = McapLayout()) {
    std::string file(kMcapMagic);
    file += mcap_record(1, Bytes().word("ros2").word("tests").text());
    std::vector<std::string> topics;
    const bool chunks = layout.packing.pack != nullptr;
    for (std::size_t begin = 0; begin < all.size(); begin += layout.in_chunk) {
        std::string content;
        for (std::size_t i = begin; i < std::min(all.size(), begin + layout.in_chunk); ++i) {
            const Said& said = all[i];
            const auto known = std::find(topics.begin(), topics.end(), said.topic);
            const auto place = static_cast<std::uint16_t>(known - topics.begin());
            const auto channel = static_cast<std::uint16_t>(layout.first_channel + place);
            if (known == topics.end()) {
                topics.push_back(said.topic);
                std::string type = said.type;
                if (const std::size_t at = type.find('/'); at != std::string::npos) {
                    type.insert(at, "/msg");
                }
                const auto schema = static_cast<std::uint16_t>(type.empty() ? 0 : place + 1);
                if (schema > 0) {
                    content += mcap_record(
                        3, Bytes().u16(schema).word(type).word("ros2msg").word("# text").text());
                }
                content += mcap_record(4, Bytes()
                                              .u16(channel)
                                              .u16(schema)
                                              .word(said.topic)
                                              .word(schema == 0 ? "json" : layout.encoding)
                                              .u32(0)
                                              .text());
            }
            content += mcap_record(5, Bytes()
                                          .u16(channel)
                                          .u32(0)
                                          .u64(said.log_time_ns)
                                          .u64(said.log_time_ns)
                                          .raw(said.bytes)
                                          .text());
        }
        if (chunks) {
            const std::string packed = layout.packing.pack(content);
            content = mcap_record(6, Bytes()
                                         .u64(0)
                                         .u64(0)
                                         .u64(content.size())
                                         .u32(layout.checksum)
                                         .word(layout.packing.name)
                                         .u64(packed.size())
                                         .raw(packed)
                                         .text());
        }
        file += content;
    }
    file += mcap_record(0x0f, Bytes().u32(0).text());
    file += mcap_record(2, Bytes().u64(0).u64(0).u32(0).text());
    return file.append(kMcapMagic);
}

}  // namespace hitos::test
