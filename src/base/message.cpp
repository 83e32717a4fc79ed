// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/message.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <iterator>
#include <system_error>

namespace hitos {
namespace {

std::string escaped(std::string_view words, std::string_view but) {
    std::string shown;
    for (const char c : words) {
        const auto byte = static_cast<unsigned char>(c);
        const bool steers = byte < 0x20 || byte == 0x7f;
        if (steers && but.find(c) == std::string_view::npos) {
            fmt::format_to(std::back_inserter(shown), "\\x{:02x}", byte);
        } else {
            shown += c;
        }
    }
    return shown;
}

}  // namespace

std::string without_control(std::string_view words) {
    return escaped(words, "\n\t");
}

std::string on_one_line(std::string_view name) {
    return escaped(name, {});
}

Message verbatim(std::string words) {
    Message message;
    message.words_ = std::move(words);
    return message;
}

Message marked(const char* text) {
    Message message;
    message.text_ = text;
    return message;
}

MessageArgument::MessageArgument(double value) : value_(verbatim(fmt::format("{}", value))) {}

std::string Message::english() const {
    return translated([](const char* text) { return std::string(text); });
}

std::string Message::translated(const Translation& translation) const {
    if (text_ == nullptr) return words_;
    const std::string text = translation(text_);
    std::string said;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t place =
            text[i] == '%' && i + 1 < text.size() ? static_cast<std::size_t>(text[i + 1] - '0') : 0;
        if (place < 1 || place > arguments_.size()) {
            said += text[i];
            continue;
        }
        said += without_control(arguments_[place - 1].translated(translation));
        ++i;
    }
    return said;
}

Message Message::replaced(std::string_view words, std::string_view others) const {
    Message changed = *this;
    for (std::size_t at = changed.words_.find(words); at != std::string::npos;
         at = changed.words_.find(words, at + others.size())) {
        changed.words_.replace(at, words.size(), others);
    }
    for (Message& argument : changed.arguments_) argument = argument.replaced(words, others);
    return changed;
}

Message system_message(int error) {
    // The system speaks the language of its own settings at best; these are what users meet.
    switch (error) {
        case EACCES:
            return message(HITOS_TEXT("Errors", "Permission denied"));
        case EIO:
            return message(HITOS_TEXT("Errors", "Input/output error"));
        case EISDIR:
            return message(HITOS_TEXT("Errors", "Is a directory"));
        case ENAMETOOLONG:
            return message(HITOS_TEXT("Errors", "File name too long"));
        case ENOENT:
            return message(HITOS_TEXT("Errors", "No such file or directory"));
        case ENOSPC:
            return message(HITOS_TEXT("Errors", "No space left on device"));
        case ENOTDIR:
            return message(HITOS_TEXT("Errors", "Not a directory"));
        case EPERM:
            return message(HITOS_TEXT("Errors", "Operation not permitted"));
        case EROFS:
            return message(HITOS_TEXT("Errors", "Read-only file system"));
        default:
            return verbatim(std::generic_category().message(error));
    }
}

Message either(std::span<const std::string_view> words) {
    if (words.empty()) return {};
    Message list = verbatim(std::string(words.front()));
    for (std::size_t i = 1; i + 1 < words.size(); ++i) list = message("%1, %2", list, words[i]);
    if (words.size() == 1) return list;
    return message(HITOS_TEXT("Errors", "%1 or %2"), list, words.back());
}

}  // namespace hitos
