// The typed errors of Hitos. Every message says what was found, where, what was expected and what
// to do; nothing in the libraries prints.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace hitos {

/// Base of every error that bad data, bad arguments or the file system can cause.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file that cannot be opened, read, written or renamed.
class FileError : public Error {
  public:
    FileError(std::string path, const std::string& problem)
        : Error(path + ": " + problem), path_(std::move(path)) {}
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// A file whose content is not what it should be; `line` is 1-based, 0 where no line applies. The
/// path is empty where the thrower does not know it.
class FormatError : public Error {
  public:
    FormatError(std::string path, std::uint64_t line, std::string problem)
        : Error(place(path, line) + problem),
          path_(std::move(path)),
          line_(line),
          problem_(std::move(problem)) {}
    const std::string& path() const { return path_; }
    std::uint64_t line() const { return line_; }
    /// The message without the place.
    const std::string& problem() const { return problem_; }

  private:
    static std::string place(const std::string& path, std::uint64_t line) {
        if (path.empty()) return line == 0 ? "" : "line " + std::to_string(line) + ": ";
        return line == 0 ? path + ": " : path + ":" + std::to_string(line) + ": ";
    }

    std::string path_;
    std::uint64_t line_;
    std::string problem_;
};

/// A parameter that does not exist or a value that it cannot take.
class ConfigError : public Error {
  public:
    ConfigError(std::string key, const std::string& problem)
        : Error(key + ": " + problem), key_(std::move(key)) {}
    const std::string& key() const { return key_; }

  private:
    std::string key_;
};

}  // namespace hitos
