// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/mcap_out.hpp"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <new>

#include "recordings/mcap_ops.hpp"
#include "recordings/mcap_records.hpp"

namespace hitos {
namespace {

/// A chunk is closed where it has so many bytes.
constexpr std::size_t kChunkBytes = std::size_t{4} << 20;
constexpr std::string_view kWrittenCompression = "zstd";
constexpr std::string_view kProfile = "ros2";
constexpr std::string_view kMessageEncoding = "cdr";
constexpr std::string_view kSchemaEncoding = "ros2msg";

std::uint32_t sum_of(std::uint32_t before, std::string_view bytes) {
    return static_cast<std::uint32_t>(
        ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void put_channel(std::string& out, std::uint16_t id, std::uint16_t schema, const McapTopic& topic) {
    put_record(out, McapOp::channel, [&] {
        put(out, id);
        put(out, schema);
        put_text(out, topic.name);
        put_text(out, kMessageEncoding);
        put_words(out, topic.metadata);
    });
}

/// Not 0: one known reader loses that channel.
std::uint16_t id_of(std::size_t channel) {
    return static_cast<std::uint16_t>(channel + 1);
}

}  // namespace

struct McapOut::Packer {
    struct Free {
        void operator()(ZSTD_CCtx* used) const { ::ZSTD_freeCCtx(used); }
    };
    std::unique_ptr<ZSTD_CCtx, Free> context{::ZSTD_createCCtx()};
    std::string packed;

    void pack(std::string_view bytes) {
        packed.resize(::ZSTD_compressBound(bytes.size()));
        const std::size_t size = ::ZSTD_compress2(context.get(), packed.data(), packed.size(),
                                                  bytes.data(), bytes.size());
        // There is room enough: only memory can be missing.
        if (::ZSTD_isError(size) != 0U) throw std::bad_alloc();
        packed.resize(size);
    }
};

McapOut::McapOut() : packer_(std::make_unique<Packer>()) {
    if (!packer_->context) throw std::bad_alloc();
}

McapOut::~McapOut() = default;

void McapOut::Times::take(std::uint64_t time_ns) {
    first_ns = messages == 0 ? time_ns : std::min(first_ns, time_ns);
    last_ns = std::max(last_ns, time_ns);
    ++messages;
}

void McapOut::begin(std::string& out, std::string_view library) {
    part_ += kMcapMagic;
    put_record(part_, McapOp::header, [&] {
        put_text(part_, kProfile);
        put_text(part_, library);
    });
    hand_out(out);
}

void McapOut::put_metadata(std::string& out, std::string_view name, const McapWords& words) {
    const std::uint64_t begin = position();
    put_record(part_, McapOp::metadata, [&] {
        put_text(part_, name);
        put_words(part_, words);
    });
    put_record(metadata_indexes_, McapOp::metadata_index, [&] {
        put(metadata_indexes_, begin);
        put(metadata_indexes_, position() - begin);
        put_text(metadata_indexes_, name);
    });
    ++metadata_;
    hand_out(out);
}

std::size_t McapOut::add(McapTopic topic) {
    channels_.push_back({std::move(topic), 0, 0, {}});
    return channels_.size() - 1;
}

/// A channel, and its schema where none before has it, stand before its first message.
void McapOut::tell(Channel& channel, std::uint16_t id) {
    const auto same = std::ranges::find_if(channels_, [&channel](const Channel& other) {
        return other.schema != 0 && other.topic.type == channel.topic.type;
    });
    if (same != channels_.end()) {
        channel.schema = same->schema;
    } else {
        channel.schema = static_cast<std::uint16_t>(schemas_.size() + 1);  // 0 means none
        std::string& record = schemas_.emplace_back();
        put_record(record, McapOp::schema, [&] {
            put(record, channel.schema);
            put_text(record, channel.topic.type);
            put_text(record, kSchemaEncoding);
            put_text(record, channel.topic.definition);
        });
        chunk_ += record;
    }
    put_channel(chunk_, id, channel.schema, channel.topic);
}

void McapOut::put_message(std::string& out, std::size_t topic, std::uint64_t time_ns,
                          std::string_view bytes) {
    Channel& channel = channels_[topic];
    if (channel.schema == 0) tell(channel, id_of(topic));
    channel.index.emplace_back(time_ns, chunk_.size());
    put_record(chunk_, McapOp::message, [&] {
        put(chunk_, id_of(topic));
        put(chunk_, channel.messages);
        put(chunk_, time_ns);
        put(chunk_, time_ns);  // published when it was logged
        chunk_ += bytes;
    });
    ++channel.messages;
    chunk_times_.take(time_ns);
    times_.take(time_ns);
    if (chunk_.size() < kChunkBytes) return;
    close_chunk();
    hand_out(out);
}

void McapOut::close_chunk() {
    if (chunk_.empty()) return;
    packer_->pack(chunk_);
    const std::uint64_t begin = position();
    put_record(part_, McapOp::chunk, [&] {
        put(part_, chunk_times_.first_ns);
        put(part_, chunk_times_.last_ns);
        put(part_, std::uint64_t{chunk_.size()});
        put(part_, sum_of(0, chunk_));
        put_text(part_, kWrittenCompression);
        put(part_, std::uint64_t{packer_->packed.size()});
        part_ += packer_->packed;
    });
    const std::uint64_t end = position();
    std::string places;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        auto& index = channels_[i].index;
        if (index.empty()) continue;
        put(places, id_of(i));
        put(places, position());
        put_record(part_, McapOp::message_index, [&] {
            put(part_, id_of(i));
            put_counted<std::uint32_t>(part_, [&] {
                for (const auto& [time_ns, place] : index) {
                    put(part_, time_ns);
                    put(part_, place);
                }
            });
        });
        index.clear();
    }
    std::string& record = chunk_indexes_;
    put_record(record, McapOp::chunk_index, [&] {
        put(record, chunk_times_.first_ns);
        put(record, chunk_times_.last_ns);
        put(record, begin);
        put(record, end - begin);
        put_text(record, places);
        put(record, position() - end);
        put_text(record, kWrittenCompression);
        put(record, std::uint64_t{packer_->packed.size()});
        put(record, std::uint64_t{chunk_.size()});
    });
    ++chunks_;
    chunk_.clear();
    chunk_times_ = {};
}

void McapOut::finish(std::string& out) {
    close_chunk();
    hand_out(out);
    put_record(part_, McapOp::data_end, [&] { put(part_, sum_); });
    put_summary();
    part_ += kMcapMagic;
    hand_out(out);
}

/// All that is needed to find a message without reading the others, from its beginning to the
/// footer.
void McapOut::put_summary() {
    const std::size_t begin = part_.size();
    const std::uint64_t summary_begin = position();
    std::string offsets;
    const auto put_group = [&](McapOp op, std::string_view records) {
        if (records.empty()) return;
        put_record(offsets, McapOp::summary_offset, [&] {
            put(offsets, op);
            put(offsets, position());
            put(offsets, std::uint64_t{records.size()});
        });
        part_ += records;
    };
    std::string records;
    for (const std::string& schema : schemas_) records += schema;
    put_group(McapOp::schema, records);
    records.clear();
    std::string counts;
    std::uint32_t told = 0;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        const Channel& channel = channels_[i];
        if (channel.schema == 0) continue;
        ++told;
        put_channel(records, id_of(i), channel.schema, channel.topic);
        put(counts, id_of(i));
        put(counts, std::uint64_t{channel.messages});
    }
    put_group(McapOp::channel, records);
    records.clear();
    put_record(records, McapOp::statistics, [&] {
        put(records, times_.messages);
        put(records, static_cast<std::uint16_t>(schemas_.size()));
        put(records, told);
        put(records, std::uint32_t{0});  // attachments
        put(records, metadata_);
        put(records, chunks_);
        put(records, times_.first_ns);
        put(records, times_.last_ns);
        put_text(records, counts);
    });
    put_group(McapOp::statistics, records);
    put_group(McapOp::chunk_index, chunk_indexes_);
    put_group(McapOp::metadata_index, metadata_indexes_);
    const std::uint64_t offsets_begin = position();
    part_ += offsets;
    // By hand, as the sum holds for the beginning of this record too.
    put(part_, McapOp::footer);
    put(part_, std::uint64_t{2 * sizeof(std::uint64_t) + sizeof(std::uint32_t)});
    put(part_, summary_begin);
    put(part_, offsets_begin);
    put(part_, sum_of(0, std::string_view(part_).substr(begin)));
}

void McapOut::hand_out(std::string& out) {
    sum_ = sum_of(sum_, part_);
    handed_out_ += part_.size();
    out += part_;
    part_.clear();
}

}  // namespace hitos
