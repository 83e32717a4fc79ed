// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_reader.hpp"

#include <cstring>

#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16;

/// No control characters but the blank ones; there is no LF in a line. Without an early way out
/// and with bytes alone, so that it vectorises.
bool is_text(std::string_view line) {
    unsigned char bad = 0;
    for (const char c : line) {
        const auto byte = static_cast<unsigned char>(c);
        const auto behind_tab = static_cast<unsigned char>(byte - '\t');
        const auto control = static_cast<unsigned char>((byte < 0x20) & (behind_tab > '\r' - '\t'));
        bad = static_cast<unsigned char>(bad | control | (byte == 0x7f));
    }
    return bad == 0;
}

Message too_long() {
    return message(HITOS_TEXT("Errors", "the line is longer than 1 MiB"));
}

}  // namespace

bool LineReader::fill() {
    if (begin_ > 0 && buffer_.size() - end_ < kChunk) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        scanned_ -= begin_;
        begin_ = 0;
    }
    if (buffer_.size() - end_ < kChunk) buffer_.resize(end_ + 2 * kChunk);
    const std::size_t got = bytes_.read({buffer_.data() + end_, buffer_.size() - end_});
    end_ += got;
    return got > 0;
}

LineReader::Line LineReader::make_line(std::string_view raw) {
    ++number_;
    if (!is_text(raw)) {
        return {{},
                number_,
                message(HITOS_TEXT("Errors", "the line is not text (it holds control characters)")),
                false};
    }
    if (number_ == 1) raw = input::without_mark(raw);
    return {input::trimmed(raw), number_, {}, false};
}

std::optional<LineReader::Line> LineReader::next() {
    for (;;) {
        if (scanned_ < end_) {
            const void* found = std::memchr(buffer_.data() + scanned_, '\n', end_ - scanned_);
            if (found != nullptr) {
                const auto at =
                    static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
                const std::string_view raw(buffer_.data() + begin_, at - begin_);
                consumed_ += raw.size() + 1;
                begin_ = at + 1;
                scanned_ = begin_;
                if (raw.size() > kLongestLine) {
                    return Line{{}, ++number_, too_long(), true};
                }
                return make_line(raw);
            }
            scanned_ = end_;
        }
        if (end_ - begin_ > kLongestLine) return skip_long_line();
        if (!fill()) return last_line();
    }
}

std::optional<LineReader::Line> LineReader::skip_long_line() {
    ++number_;
    bool found_end = false;
    while (!found_end) {
        consumed_ += end_ - begin_;
        begin_ = scanned_ = end_ = 0;
        if (!fill()) break;
        if (const void* found = std::memchr(buffer_.data(), '\n', end_)) {
            begin_ = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()) + 1;
            scanned_ = begin_;
            consumed_ += begin_;
            found_end = true;
        }
    }
    return Line{{}, number_, too_long(), true};
}

std::optional<LineReader::Line> LineReader::last_line() {
    const Message& damage = bytes_.damage();
    if (!damage.empty()) {
        if (told_damage_) return std::nullopt;
        // The unfinished line is part of the damage.
        told_damage_ = true;
        begin_ = scanned_ = end_;
        return Line{{}, number_ + 1, damage, false};
    }
    if (begin_ == end_) return std::nullopt;
    const std::string_view raw(buffer_.data() + begin_, end_ - begin_);
    consumed_ += raw.size();
    begin_ = scanned_ = end_;
    return make_line(raw);
}

}  // namespace hitos
