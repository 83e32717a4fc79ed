// A log file as a source [T 9.2.2], plain or gzip, streamed in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hitos/capture/fuente.hpp"

namespace hitos {

/// A longer line is damage: it is skipped, counted and never held in memory whole.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// A text log on disk. Each cursor has its own file handle, so memory does not grow with the file.
/// Derived kinds say which lines concern which cursor.
class Archivo : public Fuente {
  public:
    /// What a line is to the two cursors. `other` is a line of the format that neither needs;
    /// `damaged` is none that the format knows.
    enum class LineKind { scan, odometry, both, other, damaged };

    ~Archivo() override;
    Archivo(const Archivo&) = delete;
    Archivo& operator=(const Archivo&) = delete;

    std::optional<RawLine> read_scan_line() override;
    std::optional<RawLine> read_odometry_line() override;
    std::optional<double> progress() const override;
    std::string name() const override;
    std::optional<std::pair<std::uint64_t, std::string>> take_damage() override;
    std::unique_ptr<Fuente> reopen() const override;

    /// Which cursors want the line. Pure text look-up, no parsing of numbers; `text` is trimmed,
    /// not empty and no comment.
    virtual LineKind classify(std::string_view text) const = 0;

  protected:
    /// Throws FileError where the path is missing, a directory, or cannot be read.
    explicit Archivo(std::filesystem::path path);

  private:
    struct Cursor;
    std::optional<RawLine> read(Cursor& cursor, LineKind wanted);
    void note_damage(std::uint64_t line, std::string reason);

    std::filesystem::path path_;
    std::unique_ptr<Cursor> scans_;
    std::unique_ptr<Cursor> odometry_;
    std::deque<std::pair<std::uint64_t, std::string>> damage_;
    std::uint64_t damage_untold_ = 0;  ///< lines beyond those that damage_ may hold
};

/// Player/Stage writelog files [T A.1]; see docs/formats.md for the grammar and its variants.
class ArchivoPlayer final : public Archivo {
  public:
    explicit ArchivoPlayer(std::filesystem::path path) : Archivo(std::move(path)) {}
    LogFormat format() const override { return LogFormat::player; }
    LineKind classify(std::string_view text) const override;
};

/// The text format of [T A.2].
class ArchivoRadish final : public Archivo {
  public:
    explicit ArchivoRadish(std::filesystem::path path) : Archivo(std::move(path)) {}
    LogFormat format() const override { return LogFormat::radish; }
    LineKind classify(std::string_view text) const override;
};

/// The normalised format of [T A.3].
class ArchivoNormalizado final : public Archivo {
  public:
    explicit ArchivoNormalizado(std::filesystem::path path) : Archivo(std::move(path)) {}
    LogFormat format() const override { return LogFormat::normalized; }
    LineKind classify(std::string_view text) const override;
};

/// CARMEN logs (.log, .clf, .gfs.log).
class ArchivoCarmen final : public Archivo {
  public:
    explicit ArchivoCarmen(std::filesystem::path path) : Archivo(std::move(path)) {}
    LogFormat format() const override { return LogFormat::carmen; }
    LineKind classify(std::string_view text) const override;
};

/// Opens a log. With `automatic` the format is found from the first lines; an explicit format is
/// held against them. Throws FileError (missing, directory, unreadable) or FormatError (empty, not
/// text, of another format than said, of none that Hitos reads), naming what was found and
/// expected.
std::unique_ptr<Archivo> open_log(const std::filesystem::path& path,
                                  LogFormat format = LogFormat::automatic);

}  // namespace hitos
