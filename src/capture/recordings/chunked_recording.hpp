// SPDX-License-Identifier: GPL-3.0-or-later
// What bags and MCAP have in common: records one after another, some of them in chunks.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "recordings/byte_source.hpp"
#include "recordings/recording.hpp"

namespace hitos {

class ChunkedRecording : public Recording {
  public:
    std::optional<RecordedMessage> next() final;
    double progress() const final;
    std::uint64_t position() const final;

  protected:
    /// The derived kind reads what its file begins with.
    ChunkedRecording(const std::filesystem::path& path, RecordingUse use);

    /// What became of a record.
    enum class Step { passed, message, end };
    /// Reads the next record of the file or of a chunk. Throws FormatError.
    virtual Step read_record(Section& from, RecordedMessage& out) = 0;
    /// Called once behind the last byte: what is wrong with how the file ends; empty where nothing.
    virtual Message problem_at_end() = 0;
    /// The first byte from `begin` on, before `end`, at which records stand again; nothing where
    /// there is none, or the kind cannot tell.
    virtual std::optional<std::uint64_t> find_records(std::uint64_t begin, std::uint64_t end) const;

    /// What follows in the record is a chunk: its records come next. `size` is what it unpacks to,
    /// `checksum` the CRC-32 of that, 0 for none. Throws FormatError.
    void enter_chunk(Section& record, std::string_view compression, std::uint64_t size,
                     std::uint32_t checksum);
    /// Hands a message out, or passes over it where nobody wants it or where it is too large.
    Step take_message(Section& record, Topic& topic, std::int64_t log_time_ns,
                      RecordedMessage& out);
    /// The record that is stated to have so many bytes. The last one may have fewer, so that what
    /// there is of a chunk is read.
    Section open_record(Section& from, std::uint64_t length, bool may_be_cut);
    /// The record is of a kind that may be none.
    void note_unknown() { unknown_ = !chunk_; }
    bool in_chunk() const { return chunk_ != nullptr; }
    Topics& topics() { return use_.topics; }
    Section& records() { return records_; }
    const FileBytes& file() const { return file_; }
    /// Whether it is read as long as it is being written.
    bool grows() const { return grows_; }
    /// Whether it is read up to some byte alone: that it ends there is no damage.
    bool is_opening() const { return file_.extent().limit != FileExtent{}.limit; }
    bool is_followed() const { return file_.extent().growth != nullptr; }

  private:
    struct Chunk;
    void leave_chunk(bool short_of_size);
    /// Until all of the record is there, or nothing more comes. Throws FormatError where others
    /// stand within it.
    void await_record(std::uint64_t length);
    /// Behind a damaged length; what is still to come is waited for.
    std::optional<std::uint64_t> find_again();
    void no_more_comes();
    Message placed(const Message& problem) const;
    void note_here(const Message& problem);

    RecordingUse use_;
    FileBytes file_;
    bool grows_;
    Section records_;
    std::unique_ptr<Chunk> chunk_;
    std::uint64_t record_begin_ = 0;   ///< of the record, in its chunk or in the file
    std::uint64_t begin_ = 0;          ///< of the last record outside of chunks,
    std::uint64_t before_ = 0;         ///< and of the one of a known kind before it
    bool unknown_ = false;             ///< the last one is of none
    std::uint64_t behind_record_ = 0;  ///< bytes of the file behind the record outside of chunks
    bool opened_ = false;              ///< that record's length is sound
    std::string buffer_;
    bool cut_ = false;  ///< the last record is shorter than it says
    bool ended_ = false;

  public:
    ~ChunkedRecording() override;
    ChunkedRecording(const ChunkedRecording&) = delete;
    ChunkedRecording& operator=(const ChunkedRecording&) = delete;
};

}  // namespace hitos
