// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/chunked_recording.hpp"

#include <zlib.h>

#include <algorithm>
#include <utility>

#include "hitos/base/error.hpp"
#include "recordings/unpack.hpp"

namespace hitos {
namespace {

/// Passes bytes on and remembers their checksum, so that those passed over are read too.
class Summed final : public ByteSource {
  public:
    explicit Summed(ByteSource& source) : source_(source) {}
    std::size_t read(std::span<char> out) override {
        const std::size_t got = source_.read(out);
        sum_ = ::crc32_z(sum_, reinterpret_cast<const Bytef*>(out.data()), got);
        return got;
    }
    std::uint32_t sum() const { return static_cast<std::uint32_t>(sum_); }

  private:
    ByteSource& source_;
    uLong sum_ = 0;
};

}  // namespace

/// Each source reads from the one before it.
struct ChunkedRecording::Chunk {
    Chunk(ByteSource& file, std::uint64_t length, std::string_view compression,
          std::uint64_t stated_size, std::uint64_t begin)
        : packed(file, length),
          offset(begin),
          size(stated_size),
          unpacker(compression.empty() || compression == "none"
                       ? nullptr
                       : make_unpacker(compression, packed)),
          summed(unpacker ? *unpacker : static_cast<ByteSource&>(packed)) {}
    Section packed;
    std::uint64_t offset;  ///< in the file, of the chunk's record
    std::uint64_t size;
    std::unique_ptr<ByteSource> unpacker;
    Summed summed;
    bool sums = false;
    std::uint32_t checksum = 0;
    std::unique_ptr<Section> content;
};

ChunkedRecording::ChunkedRecording(const std::filesystem::path& path, RecordingUse use)
    : use_(std::move(use)),
      file_(open_unpacked(path, use_.extent)),
      grows_(file_.extent().grows()),
      records_(file_, grows_ ? FileExtent{}.limit : file_.size()) {}

ChunkedRecording::~ChunkedRecording() = default;

double ChunkedRecording::progress() const {
    if (file_.size() == 0) return 1.0;
    return std::min(1.0, static_cast<double>(file_.position()) / static_cast<double>(file_.size()));
}

std::uint64_t ChunkedRecording::position() const {
    return file_.position() + (chunk_ ? chunk_->packed.left() : 0);
}

std::optional<RecordedMessage> ChunkedRecording::next() {
    RecordedMessage found;
    while (!ended_) {
        Section& from = chunk_ ? *chunk_->content : records_;
        if (!chunk_) {
            if (!std::exchange(unknown_, false)) before_ = begin_;
            begin_ = file_.position();
        }
        record_begin_ = chunk_ ? chunk_->size - from.left() : begin_;
        const std::uint64_t left = from.left();
        opened_ = false;
        try {
            const Step step = read_record(from, found);
            if (step == Step::message) return found;
            if (step == Step::passed) continue;
            if (chunk_) {
                leave_chunk(left > 0);
                continue;
            }
        } catch (const FormatError& error) {
            if (chunk_ && !cut_) {
                note_here(error.problem());
                chunk_->packed.skip(chunk_->packed.left());
                chunk_.reset();
                continue;
            }
            if (!chunk_ && opened_ && records_.left() >= behind_record_) {
                note_here(error.problem());
                records_.skip(records_.left() - behind_record_);
                continue;
            }
            // Its length does not say where the next record begins, or that of the one before did
            // not say where this one does.
            const auto again = chunk_ ? std::nullopt : find_again();
            if (!again) {
                if (!is_opening()) note_here(error.problem());
                ended_ = true;
                return std::nullopt;
            }
            note_here(message(HITOS_TEXT("Errors", "%1; reading goes on at byte %2"),
                              error.problem(), *again));
            file_.go_to(*again);
            begin_ = *again;  // what is wrong now lies behind it
            records_.set_left((grows_ ? FileExtent{}.limit : file_.size()) - *again);
            continue;
        }
        ended_ = true;
        if (const Message problem = problem_at_end(); !problem.empty()) {
            note(topics().count_damage(), problem);
        }
    }
    return std::nullopt;
}

Message ChunkedRecording::placed(const Message& problem) const {
    if (!chunk_) return message(HITOS_TEXT("Errors", "at byte %1: %2"), record_begin_, problem);
    return message(HITOS_TEXT("Errors", "in the chunk at byte %1, %2 bytes into it: %3"),
                   chunk_->offset, record_begin_, problem);
}

void ChunkedRecording::note_here(const Message& problem) {
    note(topics().count_damage(), placed(problem));
}

Section ChunkedRecording::open_record(Section& from, std::uint64_t length, bool may_be_cut) {
    // A record that is being written is waited for, so that it is read as from a whole file.
    if (grows_ && &from == &records_) await_record(length);
    const bool too_long = length > from.left();
    if (too_long && may_be_cut && !find_records(file_.position(), file_.size())) {
        cut_ = true;
        return {from, from.left()};
    }
    Section record = from.section(length);
    if (&from == &records_) {
        behind_record_ = records_.left() - length;
        opened_ = true;
    }
    return record;
}

void ChunkedRecording::no_more_comes() {
    records_.shorten(file_.size() - file_.position());
    grows_ = false;
}

void ChunkedRecording::await_record(std::uint64_t length) {
    constexpr std::uint64_t kLook = 4096;  // at what has come meanwhile, then at half as much again
    const std::uint64_t begin = file_.position();
    while (file_.size() - begin < length) {
        const std::uint64_t there = file_.size() - begin;
        if (find_records(begin, begin + there)) {
            throw FormatError(
                {}, 0,
                HITOS_TEXT("Errors",
                           "found a length of %1 bytes, within which other records stand"),
                length);
        }
        const std::uint64_t next = std::min(length, there + std::max(kLook, there / 2));
        if (!file_.extent().growth->wait_beyond(begin + next - 1)) {
            no_more_comes();
            return;
        }
    }
}

std::optional<std::uint64_t> ChunkedRecording::find_again() {
    const std::uint64_t begin = before_ + 1;
    for (;;) {
        const std::uint64_t end = file_.size();
        const auto found = find_records(begin, end);
        if (found || !grows_) return found;
        const std::uint64_t more = std::max<std::uint64_t>(1, (end - begin) / 2);
        if (!file_.extent().growth->wait_beyond(end + more - 1)) no_more_comes();
    }
}

std::optional<std::uint64_t> ChunkedRecording::find_records(std::uint64_t /*begin*/,
                                                            std::uint64_t /*end*/) const {
    return std::nullopt;
}

void ChunkedRecording::enter_chunk(Section& record, std::string_view compression,
                                   std::uint64_t size, std::uint32_t checksum) {
    if (chunk_) {
        throw FormatError({}, 0, HITOS_TEXT("Errors", "found a chunk inside a chunk"));
    }
    if (size > kLargestChunk) {
        throw FormatError(
            {}, 0,
            HITOS_TEXT("Errors", "found a chunk of %1 bytes once unpacked, expected at most %2"),
            size, kLargestChunk);
    }
    // The record's own section ends with the caller: the same bytes from the file.
    auto chunk = std::make_unique<Chunk>(records_, record.left(), compression, size, record_begin_);
    chunk->sums = use_.check_contents && checksum != 0;
    chunk->checksum = checksum;
    ByteSource& bare = chunk->unpacker ? *chunk->unpacker : static_cast<ByteSource&>(chunk->packed);
    chunk->content = std::make_unique<Section>(chunk->sums ? chunk->summed : bare, size);
    chunk_ = std::move(chunk);
}

void ChunkedRecording::leave_chunk(bool short_of_size) {
    const bool wrong = chunk_->sums && chunk_->summed.sum() != chunk_->checksum;
    char beyond = 0;
    const bool more =
        !cut_ && !short_of_size &&
        (chunk_->unpacker ? *chunk_->unpacker : static_cast<ByteSource&>(chunk_->packed))
                .read({&beyond, 1}) > 0;
    if (cut_ && is_opening()) {
        ended_ = true;
    } else if (cut_ || short_of_size) {
        note_here(message(HITOS_TEXT("Errors", "the data end early")));
        ended_ = cut_;
    } else if (more) {
        note_here(message(HITOS_TEXT("Errors", "found more than the %1 bytes that it says it has"),
                          chunk_->size));
    } else if (wrong) {
        note_here(message(HITOS_TEXT("Errors", "its checksum is not that of its content")));
    }
    chunk_->packed.skip(chunk_->packed.left());
    chunk_.reset();
}

ChunkedRecording::Step ChunkedRecording::take_message(Section& record, Topic& topic,
                                                      std::int64_t log_time_ns,
                                                      RecordedMessage& out) {
    const std::uint64_t number = topics().count(topic);
    if (topic.wanted && record.left() <= kLargestMessage) {
        buffer_.resize(record.left());
        record.take(buffer_);
        out = {&topic, number, log_time_ns, buffer_};
        return Step::message;
    }
    if (topic.wanted) {
        note(number, placed(message(
                         HITOS_TEXT("Errors", "found a message of %1 bytes, expected at most %2"),
                         record.left(), kLargestMessage)));
    }
    record.finish();
    return Step::passed;
}

}  // namespace hitos
