// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_stream.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace hitos {
namespace {

bool is_gzip_magic(const char* bytes, std::size_t count) {
    return count >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

}  // namespace

struct ByteStream::Inflater {
    z_stream stream{};
    bool between_members = false;

    Inflater() {
        constexpr int kGzipWindow = 15 + 16;
        if (inflateInit2(&stream, kGzipWindow) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
};

ByteStream::ByteStream(const std::filesystem::path& path, FileExtent extent)
    : file_(path, std::move(extent)), input_(kInputBytes) {
    refill();
    if (is_gzip_magic(input_.data(), input_end_)) inflater_ = std::make_unique<Inflater>();
}

ByteStream::~ByteStream() = default;

bool ByteStream::refill() {
    // What is left goes to the front, so that a member's magic never straddles two reads.
    std::memmove(input_.data(), input_.data() + input_begin_, input_end_ - input_begin_);
    input_end_ -= input_begin_;
    input_begin_ = 0;
    const std::size_t got = take({input_.data() + input_end_, input_.size() - input_end_});
    input_end_ += got;
    return got > 0;
}

std::size_t ByteStream::take(std::span<char> out) {
    const std::size_t got = file_.read(out);
    taken_ += got;
    return got;
}

double ByteStream::progress() const {
    if (file_.size() == 0) return 1.0;
    return std::min(1.0, static_cast<double>(taken_) / static_cast<double>(file_.size()));
}

std::size_t ByteStream::read(std::span<char> out) {
    if (ended_ || out.empty()) return 0;
    if (inflater_) return read_inflated(out);
    if (input_begin_ == input_end_) {
        // Plain text goes where it is wanted; the buffer held the first bytes alone.
        const std::size_t got = take(out.first(std::min(out.size(), kInputBytes)));
        ended_ = got == 0;
        return got;
    }
    const std::size_t count = std::min(out.size(), input_end_ - input_begin_);
    std::memcpy(out.data(), input_.data() + input_begin_, count);
    input_begin_ += count;
    return count;
}

/// True where another gzip member follows. Zeros after a member are padding; anything else is not
/// part of the log.
bool ByteStream::next_member() {
    for (;;) {
        if (input_end_ - input_begin_ < 2 && refill()) continue;
        if (is_gzip_magic(input_.data() + input_begin_, input_end_ - input_begin_)) {
            inflateReset(&inflater_->stream);
            return true;
        }
        while (input_begin_ < input_end_ && input_[input_begin_] == '\0') ++input_begin_;
        if (input_begin_ < input_end_) {
            damage_ =
                message(HITOS_TEXT("Errors", "bytes that are not gzip follow the compressed data"));
            return false;
        }
        if (!refill()) return false;
    }
}

std::size_t ByteStream::read_inflated(std::span<char> out) {
    z_stream& stream = inflater_->stream;
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(std::min(out.size(), std::size_t{1} << 30));
    const uInt room = stream.avail_out;
    while (stream.avail_out == room && !ended_) {
        if (inflater_->between_members) {
            inflater_->between_members = false;
            if (!next_member()) {
                ended_ = true;
                break;
            }
        }
        if (input_begin_ == input_end_ && !refill()) {
            damage_ = message(HITOS_TEXT("Errors", "the compressed data end early"));
            ended_ = true;
            break;
        }
        stream.next_in = reinterpret_cast<Bytef*>(input_.data() + input_begin_);
        stream.avail_in = static_cast<uInt>(input_end_ - input_begin_);
        const int result = inflate(&stream, Z_NO_FLUSH);
        input_begin_ = input_end_ - stream.avail_in;
        if (result == Z_STREAM_END) {
            inflater_->between_members = true;
        } else if (result != Z_OK && result != Z_BUF_ERROR) {
            damage_ = message(HITOS_TEXT("Errors", "the compressed data are damaged"));
            ended_ = true;
        }
    }
    return room - stream.avail_out;
}

}  // namespace hitos
