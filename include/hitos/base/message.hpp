// SPDX-License-Identifier: GPL-3.0-or-later
// What the libraries tell people: sentences in English that a window can say in another language.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/base/translatable.hpp"

namespace hitos {

/// Words that may hold what ends a C string or steers a terminal: control characters as `\x1b`, but
/// for line ends and tabulators.
std::string without_control(std::string_view words);
/// A name as it stands within a line: line ends and tabulators too.
std::string on_one_line(std::string_view name);

/// A sentence and what stands in it. The English text with its places %1 … %9 is the code by which
/// a translation is found; what goes to those places is told as it is (paths, numbers, keys, what
/// was found; control characters by their codes) or is a message itself. Only the functions below
/// make one, so that no sentence is told that nobody can translate.
class Message {
  public:
    /// What a text in English is in another language.
    using Translation = std::function<std::string(const char* text)>;

    Message() = default;
    bool empty() const { return text_ == nullptr && words_.empty(); }
    std::string english() const;
    std::string translated(const Translation& translation) const;
    /// With other words for every place where it says these.
    Message replaced(std::string_view words, std::string_view others) const;

    /// Whatever the language: what other programs say, names, numbers.
    friend Message verbatim(std::string words);
    /// A text that is marked by HITOS_TEXT("Errors", …) where it stands.
    friend Message marked(const char* text);

  private:
    template <class... Arguments>
    friend Message filled(const char* text, const Arguments&... arguments);

    const char* text_ = nullptr;      ///< null: words_ as they are
    std::string words_;               ///< told as they are
    std::vector<Message> arguments_;  ///< of %1 … %9 in text_
};

Message verbatim(std::string words);
Message marked(const char* text);

/// What may stand at a place of a message: another message, text or a number. Real numbers are
/// told by the shortest digits that read back.
class MessageArgument {
  public:
    MessageArgument(Message value) : value_(std::move(value)) {}
    MessageArgument(std::string value) : value_(verbatim(std::move(value))) {}
    MessageArgument(std::string_view value) : value_(verbatim(std::string(value))) {}
    MessageArgument(const char* value) : value_(verbatim(value)) {}
    MessageArgument(double value);
    template <std::integral Number>
    MessageArgument(Number value) : value_(verbatim(std::to_string(value))) {}

    Message take() && { return std::move(value_); }

  private:
    Message value_;
};

/// A literal with exactly the places %1 … %Count; another one does not compile.
template <std::size_t Count>
class MessageText {
  public:
    consteval MessageText(const char* text) : text_(text) {
        std::array<bool, 10> filled{};
        for (const char* at = text; *at != '\0'; ++at) {
            if (*at == '%' && at[1] >= '1' && at[1] <= '9')
                filled[static_cast<std::size_t>(at[1] - '0')] = true;
        }
        for (std::size_t place = 1; place < 10; ++place) {
            if (filled[place] != (place <= Count)) {
                throw std::logic_error("the places are not those of the arguments");
            }
        }
    }
    const char* text() const { return text_; }

  private:
    const char* text_;
};

template <class... Arguments>
Message filled(const char* text, const Arguments&... arguments) {
    Message message;
    message.text_ = text;
    message.arguments_.reserve(sizeof...(arguments));
    (message.arguments_.push_back(MessageArgument(arguments).take()), ...);
    return message;
}

/// message(HITOS_TEXT("Errors", "found %1 fields; expected %2"), 3, "x y"). A text without words of
/// its own ("%1: %2") needs no mark.
template <class... Arguments>
Message message(MessageText<sizeof...(Arguments)> text, const Arguments&... arguments) {
    return filled(text.text(), arguments...);
}

/// What the system says of an error number (errno).
Message system_message(int error);

/// "a, b or c"
Message either(std::span<const std::string_view> words);

}  // namespace hitos
