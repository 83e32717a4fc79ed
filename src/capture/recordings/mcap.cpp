// SPDX-License-Identifier: GPL-3.0-or-later
// MCAP, the container of ROS 2 recordings [mcap.dev/spec]. It is read from front to back: neither
// index nor summary is needed.
#include <array>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "hitos/base/error.hpp"
#include "recordings/chunked_recording.hpp"
#include "recordings/mcap_ops.hpp"
#include "recordings/mcap_search.hpp"

namespace hitos {
namespace {

constexpr std::uint64_t kDataEnd = 4;  // bytes of such records
constexpr std::uint64_t kFooter = 20;
constexpr std::string_view kMcapMagicOfAny = kMcapMagic.substr(0, 5);

class Mcap final : public ChunkedRecording {
  public:
    Mcap(const std::filesystem::path& path, RecordingUse use)
        : ChunkedRecording(path, std::move(use)) {
        std::array<char, kMcapMagic.size()> magic{};
        const std::string_view found{magic.data(), records().read(magic)};
        if (found != kMcapMagic && found.starts_with(kMcapMagicOfAny)) {
            throw FormatError(path.string(), 0,
                              HITOS_TEXT("Errors",
                                         "is MCAP of the version \"%1\", expected version 0; "
                                         "convert it with a program that knows both"),
                              found.substr(kMcapMagicOfAny.size(), 1));
        }
        if (found != kMcapMagic) {
            throw FormatError(path.string(), 0,
                              HITOS_TEXT("Errors", "does not begin as MCAP does"));
        }
        if (grows() || file().size() < 2 * kMcapMagic.size()) return;
        closed_ = ends_as_mcap();
    }

  protected:
    Step read_record(Section& from, RecordedMessage& out) override {
        const bool outside = !in_chunk();
        // Behind the last record, where no end of the data was written.
        if (outside && closed_ && from.left() <= kMcapMagic.size()) {
            if (from.left() < kMcapMagic.size() || has_footer()) refuse_length(from);
            return Step::end;
        }
        std::array<char, 1> first{};
        if (from.read(first) == 0) return Step::end;
        const auto op = static_cast<McapOp>(first.front());
        const std::uint64_t length = from.take_u64();
        const std::uint64_t most = outside ? longest(op) : length;
        if (length > most) {
            throw FormatError(
                {}, 0, HITOS_TEXT("Errors", "found a length of %1 bytes, expected at most %2"),
                length, most);
        }
        // Before its length is believed: zeros would be a record each nine.
        if (op == McapOp::none) {
            throw FormatError({}, 0, HITOS_TEXT("Errors", "found a record of the unknown kind %1"),
                              0);
        }
        chunks_ = chunks_ || (outside && op == McapOp::chunk);
        Section record = open_record(from, length, op == McapOp::chunk && outside);
        switch (op) {
            case McapOp::message:
                return read_message(record, out);
            case McapOp::schema:
                read_schema(record);
                break;
            case McapOp::channel:
                read_channel(record);
                break;
            case McapOp::chunk:
                read_chunk(record);
                return Step::passed;
            default:
                // What follows repeats what was told before.
                if (outside && (op == McapOp::data_end || op == McapOp::footer)) {
                    if (grows()) wait_for_end(op, from, record);
                    return Step::end;
                }
                if (op > McapOp::data_end) note_unknown();
                break;  // indexes, attachments, metadata, and what later versions add
        }
        record.finish();
        return Step::passed;
    }

    std::optional<std::uint64_t> find_records(std::uint64_t begin,
                                              std::uint64_t end) const override {
        const McapSearch search(
            [this](std::uint64_t at, std::span<char> out) { return file().read_at(at, out); },
            [this](std::uint16_t channel) { return channels_.contains(channel); }, chunks_,
            grows());
        return search.find(begin, end);
    }

    Message problem_at_end() override {
        if (closed_ || is_opening() || (is_followed() && ends_as_mcap())) return {};
        return message(HITOS_TEXT("Errors",
                                  "the recording was not closed or is cut off, as its last bytes "
                                  "are not MCAP's; all before byte %1 was read"),
                       file().size());
    }

  private:
    /// Of the records behind the data.
    static std::uint64_t longest(McapOp op) {
        if (op == McapOp::data_end) return kDataEnd;
        return op == McapOp::footer ? kFooter : std::numeric_limits<std::uint64_t>::max();
    }
    bool has_footer() const {
        constexpr std::uint64_t kLength = 1 + sizeof(std::uint64_t) + kFooter + kMcapMagic.size();
        std::array<char, kLength> last{};
        return file().read_end(last) == last.size() &&
               static_cast<McapOp>(last.front()) == McapOp::footer &&
               static_cast<std::uint64_t>(last[1]) == kFooter;
    }
    /// Of the record before, which took in what the file ends with.
    [[noreturn]] static void refuse_length(const Section& from) {
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors",
                                     "the record before is longer than can be: it takes in the end "
                                     "of the data, and leaves %1 bytes"),
                          from.left());
    }
    bool ends_as_mcap() const {
        std::array<char, kMcapMagic.size()> last{};
        const std::size_t got = file().read_end(last);
        return std::string_view(last.data(), got) == kMcapMagic;
    }

    /// Passes over what is being written behind the messages.
    static void wait_for_end(McapOp op, Section& from, Section& record) {
        try {
            record.finish();
            while (op != McapOp::footer) {
                op = static_cast<McapOp>(from.take_u8());
                from.section(from.take_u64()).finish();
            }
            from.section(kMcapMagic.size()).finish();
        } catch (const FormatError&) {  // it ended before that
        }
    }

    static std::string take_word(Section& record) {
        const std::uint32_t length = record.take_u32();
        return record.take_text(length, kLongestWord);
    }

    void read_schema(Section& record) {
        const std::uint16_t id = record.take_u16();
        if (types_.size() == kMostTopics && !types_.contains(id)) {
            throw FormatError({}, 0, HITOS_TEXT("Errors", "more than %1 types"), kMostTopics);
        }
        types_.insert_or_assign(id, take_word(record));
    }

    void read_channel(Section& record) {
        const std::uint16_t id = record.take_u16();
        const std::uint16_t type = record.take_u16();
        std::string name = take_word(record);
        std::string encoding = take_word(record);
        const auto known = types_.find(type);
        channels_.insert_or_assign(
            id, &topics().of(std::move(name), known == types_.end() ? "" : known->second,
                             std::move(encoding)));
    }

    void read_chunk(Section& record) {
        record.take_u64();  // first and last log time
        record.take_u64();
        const std::uint64_t size = record.take_u64();
        const std::uint32_t checksum = record.take_u32();
        const std::string compression = take_word(record);
        record.take_u64();  // how many bytes follow, which the record's length says too
        enter_chunk(record, compression, size, checksum);
    }

    Step read_message(Section& record, RecordedMessage& out) {
        const std::uint16_t id = record.take_u16();
        record.take_u32();  // sequence
        const std::uint64_t log_time_ns = record.take_u64();
        record.take_u64();  // when it was published
        const auto known = channels_.find(id);
        if (known == channels_.end()) {
            throw FormatError(
                {}, 0,
                HITOS_TEXT("Errors", "found a message of the channel %1, which nothing describes"),
                id);
        }
        return take_message(record, *known->second, static_cast<std::int64_t>(log_time_ns), out);
    }

    std::map<std::uint16_t, std::string> types_;
    std::map<std::uint16_t, Topic*> channels_;
    bool closed_ = false;
    bool chunks_ = false;  // there are some
};

}  // namespace

bool begins_mcap(std::string_view beginning) {
    return beginning.starts_with(kMcapMagicOfAny);
}

std::unique_ptr<Recording> open_mcap(const std::filesystem::path& path, RecordingUse use) {
    return std::make_unique<Mcap>(path, std::move(use));
}

}  // namespace hitos
