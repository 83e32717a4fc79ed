// SPDX-License-Identifier: GPL-3.0-or-later
// The typed errors of Hitos. Every message says what was found, where, what was expected and what
// to do; nothing in the libraries prints.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "hitos/base/message.hpp"

namespace hitos {

/// Base of every error that bad data, bad arguments or the file system can cause. `what()` says it
/// in English. Those below take their problem as a message, or as its text and what stands in it.
class Error : public std::runtime_error {
  public:
    explicit Error(Message message)
        : std::runtime_error(message.english()), message_(std::move(message)) {}
    /// All of it, the place too.
    const Message& message() const { return message_; }

  private:
    Message message_;
};

/// A file that cannot be opened, read, written or renamed.
class FileError : public Error {
  public:
    template <class... Arguments>
    FileError(std::string path, MessageText<sizeof...(Arguments)> text,
              const Arguments&... arguments)
        : FileError(std::move(path), hitos::message(text, arguments...)) {}
    FileError(std::string path, const Message& problem)
        : Error(hitos::message("%1: %2", on_one_line(path), problem)), path_(std::move(path)) {}
    const std::string& path() const { return path_; }
    /// The same of another place: wherever it says `words`, it says `others`.
    FileError replaced(std::string_view words, std::string_view others) const {
        return {verbatim(path_).replaced(words, others).english(),
                message().replaced(words, others), nullptr};
    }

  private:
    /// `whole`: with the path in it.
    FileError(std::string path, Message&& whole, std::nullptr_t)
        : Error(std::move(whole)), path_(std::move(path)) {}

    std::string path_;
};

/// A file whose content is not what it should be; `line` is 1-based, 0 where no line applies. The
/// path is empty where the thrower does not know it.
class FormatError : public Error {
  public:
    FormatError(std::string path, std::uint64_t line, Message problem)
        : Error(placed(path, line, problem)),
          path_(std::move(path)),
          line_(line),
          problem_(std::move(problem)) {}
    template <class... Arguments>
    FormatError(std::string path, std::uint64_t line, MessageText<sizeof...(Arguments)> text,
                const Arguments&... arguments)
        : FormatError(std::move(path), line, hitos::message(text, arguments...)) {}
    const std::string& path() const { return path_; }
    std::uint64_t line() const { return line_; }
    /// The message without the place.
    const Message& problem() const { return problem_; }

  private:
    static Message placed(const std::string& path, std::uint64_t line, const Message& problem) {
        if (path.empty() && line == 0) return problem;
        if (path.empty()) {
            return hitos::message(HITOS_TEXT("Errors", "line %1: %2"), line, problem);
        }
        if (line == 0) return hitos::message("%1: %2", on_one_line(path), problem);
        return hitos::message("%1:%2: %3", on_one_line(path), line, problem);
    }

    std::string path_;
    std::uint64_t line_;
    Message problem_;
};

/// A parameter that does not exist or a value that it cannot take.
class ConfigError : public Error {
  public:
    ConfigError(std::string key, const Message& problem)
        : Error(hitos::message("%1: %2", on_one_line(key), problem)),
          key_(std::move(key)),
          problem_(problem) {}
    template <class... Arguments>
    ConfigError(std::string key, MessageText<sizeof...(Arguments)> text,
                const Arguments&... arguments)
        : ConfigError(std::move(key), hitos::message(text, arguments...)) {}
    const std::string& key() const { return key_; }
    /// Without the key.
    const Message& problem() const { return problem_; }

  private:
    std::string key_;
    Message problem_;
};

inline Message out_of_memory() {
    return message(HITOS_TEXT("Errors",
                              "out of memory; fewer particles, coarser cells of the grid or fewer "
                              "runs at a time take less"));
}

/// What an error says; what is none of Hitos' has only its own words.
inline Message message_of(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return out_of_memory();
    const auto* known = dynamic_cast<const Error*>(&error);
    return known != nullptr ? known->message() : verbatim(error.what());
}

}  // namespace hitos
