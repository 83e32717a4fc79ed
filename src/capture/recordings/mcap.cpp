// MCAP, the container of ROS 2 recordings [mcap.dev/spec]. It is read from front to back: neither
// index nor summary is needed.
#include <array>
#include <map>
#include <utility>

#include "hitos/base/error.hpp"
#include "recordings/chunked_recording.hpp"

namespace hitos {
namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

enum Op : std::uint8_t {
    footer = 0x02,
    schema = 0x03,
    channel = 0x04,
    message_data = 0x05,
    chunk = 0x06,
    data_end = 0x0f
};

class Mcap final : public ChunkedRecording {
  public:
    Mcap(const std::filesystem::path& path, RecordingUse use) : ChunkedRecording(path, use) {
        std::array<char, kMagic.size()> magic{};
        const std::size_t got = records().read(magic);
        if (std::string_view(magic.data(), got) != kMagic) {
            throw FormatError(path.string(), 0,
                              message(HITOS_TEXT("Errors", "does not begin as MCAP does")));
        }
        FileBytes tail(path);
        if (file_size() < 2 * kMagic.size()) return;
        tail.skip(file_size() - kMagic.size());
        tail.read(magic);
        closed_ = std::string_view{magic.data(), magic.size()} == kMagic;
    }

  protected:
    Step read_record(Section& from, RecordedMessage& out) override {
        std::array<char, 1> first{};
        if (from.read(first) == 0) return Step::end;
        const auto op = static_cast<std::uint8_t>(first.front());
        const std::uint64_t length = from.take_u64();
        const bool outside = !in_chunk();
        Section record = open_record(from, length, op == Op::chunk && outside);
        switch (op) {
            case Op::message_data:
                return read_message(record, out);
            case Op::schema:
                read_schema(record);
                break;
            case Op::channel:
                read_channel(record);
                break;
            case Op::chunk:
                read_chunk(record);
                return Step::passed;
            case 0:
                throw FormatError(
                    {}, 0,
                    message(HITOS_TEXT("Errors", "found a record of the unknown kind %1"),
                            unsigned{op}));
            default:
                // What follows repeats what was told before.
                if (outside && (op == Op::data_end || op == Op::footer)) return Step::end;
                break;  // indexes, attachments, metadata, and what later versions add
        }
        record.finish();
        return Step::passed;
    }

    Message problem_at_end() override {
        if (closed_) return {};
        return message(HITOS_TEXT("Errors",
                                  "the recording was not closed or is cut off, as its last bytes "
                                  "are not MCAP's; all before byte %1 was read"),
                       file_size());
    }

  private:
    static std::string take_word(Section& record) {
        const std::uint32_t length = record.take_u32();
        return record.take_text(length, kLongestWord);
    }

    void read_schema(Section& record) {
        const std::uint16_t id = record.take_u16();
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
                message(HITOS_TEXT("Errors",
                                   "found a message of the channel %1, which nothing describes"),
                        id));
        }
        return take_message(record, *known->second, static_cast<std::int64_t>(log_time_ns), out);
    }

    std::map<std::uint16_t, std::string> types_;
    std::map<std::uint16_t, Topic*> channels_;
    bool closed_ = false;
};

}  // namespace

bool begins_mcap(std::string_view beginning) {
    return beginning.starts_with(kMagic);
}

std::unique_ptr<Recording> open_mcap(const std::filesystem::path& path, RecordingUse use) {
    return std::make_unique<Mcap>(path, use);
}

}  // namespace hitos
