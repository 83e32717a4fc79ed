// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/text_limits.hpp"

#include <algorithm>
#include <cstdint>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos::input {
namespace {

constexpr std::size_t kDeepest = 64;      // brackets in brackets
constexpr std::size_t kLongestKey = 16;   // parts between dots, each a table in a table
constexpr std::size_t kMost = 1'000'000;  // values of TOML, some 100 bytes each

/// Goes through a text by its brackets, strings and comments. Where the text is wrong the library
/// stops, so what is counted behind that place does not matter.
class Scan {
  public:
    Scan(std::string_view text, const std::string& file, bool toml)
        : text_(text), file_(file), toml_(toml) {}

    void run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || (toml_ && c == '\'')) {
                pass_string(c);
            } else if (toml_ && c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else {
                take(c);
                ++at_;
            }
        }
    }

  private:
    void take(char c) {
        if (c == '.') {
            if (toml_ && ++dots_ >= kLongestKey) {
                fail(message(HITOS_TEXT("Errors", "has a key of more than %1 parts between dots"),
                             kLongestKey));
            }
            return;
        }
        if (c == '[' || c == '{') {
            if (++depth_ > kDeepest) {
                fail(message(HITOS_TEXT("Errors", "is nested deeper than %1 levels"), kDeepest));
            }
        } else if (c == ']' || c == '}') {
            depth_ -= depth_ > 0 ? 1 : 0;
        } else if (c != ',' && c != '\n' && c != '=') {
            return;
        }
        dots_ = 0;
        if (!toml_ || c == '\n' || c == ']' || c == '}') return;
        if (++values_ > kMost)
            fail(message(HITOS_TEXT("Errors", "has more than %1 values"), kMost));
    }

    void pass_string(char quote) {
        const std::string three(3, quote);
        const bool lines = toml_ && text_.substr(at_).starts_with(three);
        at_ += lines ? three.size() : 1;
        while (at_ < text_.size()) {
            if (quote == '"' && text_[at_] == '\\') {
                at_ += 2;
            } else if (lines && text_.substr(at_).starts_with(three)) {
                at_ += three.size();  // of its own, the string may have two before them
                for (int own = 0; own < 2 && at_ < text_.size() && text_[at_] == quote; ++own)
                    ++at_;
                return;
            } else if (!lines && (text_[at_] == quote || text_[at_] == '\n')) {
                if (text_[at_] == quote) ++at_;
                return;
            } else {
                ++at_;
            }
        }
    }

    [[noreturn]] void fail(const Message& problem) const {
        const std::size_t end = std::min(at_, text_.size());
        const auto line = 1 + std::ranges::count(text_.substr(0, end), '\n');
        throw FormatError(file_, static_cast<std::uint64_t>(line), problem);
    }

    std::string_view text_;
    const std::string& file_;
    bool toml_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    std::size_t dots_ = 0;
    std::size_t values_ = 0;
};

}  // namespace

std::string_view checked_toml(std::string_view text, const std::string& file) {
    if (text.size() > kLargestSettings) {
        throw FormatError(file, 0, HITOS_TEXT("Errors", "is greater than %1 MiB"),
                          kLargestSettings >> 20U);
    }
    Scan(text, file, true).run();
    return text;
}

std::string_view checked_json(std::string_view text, const std::string& file) {
    Scan(text, file, false).run();
    return text;
}

}  // namespace hitos::input
