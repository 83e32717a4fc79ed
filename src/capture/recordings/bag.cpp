// SPDX-License-Identifier: GPL-3.0-or-later
// ROS 1 bags, version 2.0 [wiki.ros.org/Bags/Format/2.0]. They are read from front to back, so that
// a bag without its index, as after a recording that was broken off, is read as well.
//
// By our own reader, since Debian's rosbag_storage 1.15 is none for bad input: of 500 bags with
// some bytes changed or the tail cut off three crash it and two make it ask for more than 2 GiB.
#include <array>
#include <cstring>
#include <map>

#include "hitos/base/error.hpp"
#include "recordings/chunked_recording.hpp"

namespace hitos {
namespace {

constexpr std::string_view kBagMagic = "#ROSBAG V2.0\n";
constexpr std::string_view kMagicOfAnyBag = "#ROSBAG V";

enum Op : std::uint8_t {
    message_data = 0x02,
    bag_header = 0x03,
    index_data = 0x04,
    chunk = 0x05,
    chunk_info = 0x06,
    connection = 0x07
};

/// name=value pairs, each behind its length: the header of a record.
class Header {
  public:
    Header(Section& from, std::uint32_t length) {
        constexpr std::uint64_t kLongest = std::uint64_t{1} << 20;
        const std::string bytes = from.take_text(length, kLongest);
        std::string_view rest = bytes;
        while (!rest.empty()) {
            std::uint32_t size = 0;
            if (rest.size() < sizeof size) fail();
            for (std::size_t i = sizeof size; i-- > 0;) {
                size = size << 8 | static_cast<unsigned char>(rest[i]);
            }
            rest.remove_prefix(sizeof size);
            if (size > rest.size()) fail();
            const std::string_view field = rest.substr(0, size);
            rest.remove_prefix(size);
            const std::size_t equals = field.find('=');
            if (equals == std::string_view::npos) fail();
            fields_.emplace(field.substr(0, equals), field.substr(equals + 1));
        }
    }

    /// Throws FormatError where it is missing.
    const std::string& text(const char* name) const {
        const auto found = fields_.find(name);
        if (found != fields_.end()) return found->second;
        throw FormatError({}, 0, HITOS_TEXT("Errors", "found a record without the field \"%1\""),
                          name);
    }
    /// A field of so many bytes. Throws FormatError.
    template <class Number>
    Number number(const char* name) const {
        const std::string& bytes = text(name);
        if (bytes.size() != sizeof(Number)) {
            throw FormatError(
                {}, 0, HITOS_TEXT("Errors", "found %2 bytes in the field \"%1\", expected %3"),
                name, bytes.size(), sizeof(Number));
        }
        std::uint64_t value = 0;
        for (std::size_t i = sizeof(Number); i-- > 0;) {
            value = value << 8 | static_cast<unsigned char>(bytes[i]);
        }
        return static_cast<Number>(value);
    }
    bool has(const char* name) const { return fields_.contains(name); }

  private:
    [[noreturn]] static void fail() {
        throw FormatError({}, 0, HITOS_TEXT("Errors", "the header of a record is damaged"));
    }
    std::map<std::string, std::string, std::less<>> fields_;
};

class Bag final : public ChunkedRecording {
  public:
    Bag(const std::filesystem::path& path, RecordingUse use)
        : ChunkedRecording(path, std::move(use)) {
        std::array<char, kBagMagic.size()> magic{};
        const std::size_t got = records().read(magic);
        const std::string_view found{magic.data(), got};
        if (found == kBagMagic) return;
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors",
                                     "is a ROS bag that begins with \"%1\", expected version 2.0; "
                                     "convert it with \"rosbag fix\""),
                          found.substr(0, found.find('\n')));
    }

  protected:
    Step read_record(Section& from, RecordedMessage& out) override {
        std::array<char, 4> length{};
        const std::size_t got = from.read(length);
        if (got == 0) return Step::end;
        if (got < length.size()) {
            throw FormatError({}, 0, HITOS_TEXT("Errors", "the data end early"));
        }
        std::uint32_t header_length = 0;
        for (std::size_t i = length.size(); i-- > 0;) {
            header_length = header_length << 8 | static_cast<unsigned char>(length[i]);
        }
        const Header header(from, header_length);
        const auto op = header.number<std::uint8_t>("op");
        const std::uint32_t data_length = from.take_u32();
        Section data = open_record(from, data_length, op == Op::chunk && !in_chunk());
        switch (op) {
            case Op::chunk:
                enter_chunk(data, header.text("compression"), header.number<std::uint32_t>("size"),
                            0);
                return Step::passed;
            case Op::message_data:
                return read_message(header, data, out);
            case Op::connection:
                read_connection(header, data);
                break;
            case Op::bag_header:
                index_begin_ = header.number<std::uint64_t>("index_pos");
                break;
            case Op::index_data:
            case Op::chunk_info:
                break;
            default:
                throw FormatError({}, 0,
                                  HITOS_TEXT("Errors", "found a record of the unknown kind %1"),
                                  unsigned{op});
        }
        data.finish();
        return Step::passed;
    }

    Message problem_at_end() override {
        if (index_begin_ > 0 && index_begin_ <= file().size()) return {};
        return message(HITOS_TEXT("Errors",
                                  "the bag was not closed or is cut off, as it has no index; all "
                                  "before byte %1 was read"),
                       file().size());
    }

  private:
    Step read_message(const Header& header, Section& data, RecordedMessage& out) {
        const auto id = header.number<std::uint32_t>("conn");
        const auto time = header.number<std::uint64_t>("time");
        const auto known = connections_.find(id);
        if (known == connections_.end()) {
            throw FormatError(
                {}, 0,
                HITOS_TEXT("Errors",
                           "found a message of the connection %1, which nothing describes"),
                id);
        }
        constexpr std::int64_t kSecond = 1'000'000'000;
        const auto seconds = static_cast<std::int64_t>(time & 0xffff'ffffU);
        return take_message(data, *known->second,
                            seconds * kSecond + static_cast<std::int64_t>(time >> 32), out);
    }

    void read_connection(const Header& header, Section& data) {
        const auto id = header.number<std::uint32_t>("conn");
        if (connections_.contains(id)) return;  // each chunk and the index tell it again
        if (connections_.size() == kMostTopics) {
            throw FormatError({}, 0, HITOS_TEXT("Errors", "more than %1 topics"), kMostTopics);
        }
        // Behind a message definition of any length comes what matters: its fields are pairs too.
        constexpr std::uint64_t kLongest = std::uint64_t{8} << 20;
        if (data.left() > kLongest) {
            throw FormatError(
                {}, 0, HITOS_TEXT("Errors", "found a length of %1 bytes, expected at most %2"),
                data.left(), kLongest);
        }
        std::string type;
        while (data.left() > 0) {
            const std::uint32_t length = data.take_u32();
            Section field = data.section(length);
            constexpr std::string_view kType = "type=";
            constexpr std::uint64_t kMostOfType = 1024;
            if (length <= kMostOfType) {
                std::string text = field.take_text(length, kMostOfType);
                if (text.starts_with(kType)) type = text.substr(kType.size());
            }
            field.finish();
        }
        if (header.text("topic").size() > kLongestWord) {
            throw FormatError(
                {}, 0, HITOS_TEXT("Errors", "found a length of %1 bytes, expected at most %2"),
                header.text("topic").size(), kLongestWord);
        }
        connections_.emplace(id, &topics().of(header.text("topic"), std::move(type), "ros1"));
    }

    std::map<std::uint32_t, Topic*> connections_;
    std::uint64_t index_begin_ = 0;
};

}  // namespace

bool begins_bag(std::string_view beginning) {
    return beginning.starts_with(kMagicOfAnyBag);
}

std::unique_ptr<Recording> open_bag(const std::filesystem::path& path, RecordingUse use) {
    return std::make_unique<Bag>(path, std::move(use));
}

}  // namespace hitos
