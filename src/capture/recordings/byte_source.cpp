// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/byte_source.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

[[noreturn]] void fail_early() {
    throw FormatError({}, 0, HITOS_TEXT("Errors", "the data end early"));
}

}  // namespace

std::uint64_t ByteSource::skip(std::uint64_t count) {
    std::array<char, 4096> scratch{};
    std::uint64_t skipped = 0;
    while (skipped < count) {
        const std::size_t wanted = std::min<std::uint64_t>(count - skipped, scratch.size());
        const std::size_t got = read({scratch.data(), wanted});
        skipped += got;
        if (got < wanted) break;
    }
    return skipped;
}

FileBytes::FileBytes(RegularFile file) : file_(std::move(file)), buffer_(kBufferBytes) {}

std::size_t FileBytes::read(std::span<char> out) {
    std::size_t done = 0;
    while (done < out.size()) {
        if (begin_ == end_) {
            begin_ = 0;
            end_ = file_.read(buffer_);
            if (end_ == 0) break;
        }
        const std::size_t count = std::min(out.size() - done, end_ - begin_);
        std::memcpy(out.data() + done, buffer_.data() + begin_, count);
        begin_ += count;
        done += count;
    }
    position_ += done;
    return done;
}

std::uint64_t FileBytes::skip(std::uint64_t count) {
    if (count > 0 && extent().growth) extent().growth->wait_beyond(position_ + count - 1);
    const std::uint64_t there = size() > position_ ? size() - position_ : 0;
    count = std::min(count, there);
    if (count <= end_ - begin_) {
        begin_ += count;
    } else {
        file_.seek(position_ + count);
        begin_ = end_ = 0;
    }
    position_ += count;
    return count;
}

void FileBytes::go_to(std::uint64_t position) {
    file_.seek(position);
    begin_ = end_ = 0;
    position_ = position;
}

std::size_t Section::read(std::span<char> out) {
    const std::size_t wanted = std::min<std::uint64_t>(out.size(), left_);
    const std::size_t got = whole_.read(out.first(wanted));
    left_ = got < wanted ? 0 : left_ - got;
    return got;
}

std::uint64_t Section::skip(std::uint64_t count) {
    const std::uint64_t wanted = std::min(count, left_);
    const std::uint64_t got = whole_.skip(wanted);
    left_ = got < wanted ? 0 : left_ - got;
    return got;
}

Section Section::section(std::uint64_t length) {
    if (length > left_) {
        throw FormatError(
            {}, 0, HITOS_TEXT("Errors", "found a length of %1 bytes, expected at most the %2 left"),
            length, left_);
    }
    return {*this, length};
}

void Section::take(std::span<char> out) {
    if (read(out) < out.size()) fail_early();
}

std::string Section::take_text(std::uint64_t length, std::uint64_t most) {
    if (length > left_ || length > most) {
        throw FormatError({}, 0,
                          HITOS_TEXT("Errors", "found a length of %1 bytes, expected at most %2"),
                          length, std::min(left_, most));
    }
    std::string text(length, '\0');
    take(text);
    return text;
}

void Section::finish() {
    const std::uint64_t rest = left_;
    if (skip(rest) < rest) fail_early();
}

std::uint64_t Section::take_little_endian(std::size_t bytes) {
    std::array<char, 8> raw{};
    take({raw.data(), bytes});
    std::uint64_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) value = value << 8 | static_cast<unsigned char>(raw[i]);
    return value;
}

}  // namespace hitos
