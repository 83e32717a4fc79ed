// The lines of a source, made once and read by many runs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/fuente.hpp"

namespace hitos {

/// All that a source has to hand out; immutable and so safe to share between threads.
class RecordedLines {
  public:
    /// Reads the source, which must stand at its beginning, to its end.
    explicit RecordedLines(Fuente& fuente);

    std::optional<RawLine> scan_line(std::size_t k) const { return scans_.line(k); }
    std::optional<RawLine> odometry_line(std::size_t k) const { return odometry_.line(k); }
    std::size_t scan_lines() const { return scans_.lines.size(); }

  private:
    struct Lines {
        struct Place {
            std::size_t end = 0;  ///< in the text; the line begins where the one before ends
            std::uint64_t number = 0;
        };
        std::string text;
        std::vector<Place> lines;

        void add(const RawLine& line);
        std::optional<RawLine> line(std::size_t k) const;
    };
    Lines scans_;
    Lines odometry_;
};

/// Hands out recorded lines of the normalised format; they are asked for at the first line.
class FuenteGrabada final : public Fuente {
  public:
    using Lines = std::shared_ptr<const RecordedLines>;

    FuenteGrabada(std::string name, std::function<Lines()> open)
        : name_(std::move(name)), open_(std::move(open)) {}

    LogFormat format() const override { return LogFormat::normalized; }
    std::optional<RawLine> read_scan_line() override;
    std::optional<RawLine> read_odometry_line() override;
    std::optional<double> progress() const override;
    std::string name() const override { return name_; }
    std::optional<std::pair<std::uint64_t, std::string>> take_damage() override { return {}; }
    std::unique_ptr<Fuente> reopen() const override;

  private:
    const RecordedLines& lines();

    std::string name_;
    std::function<Lines()> open_;
    Lines lines_;
    std::size_t scan_ = 0;
    std::size_t reading_ = 0;
};

}  // namespace hitos
