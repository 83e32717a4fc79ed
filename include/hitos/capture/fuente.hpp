// SPDX-License-Identifier: GPL-3.0-or-later
// Where raw log lines come from [T 9.2.2].
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/tour_finding.hpp"

namespace hitos {

struct LogFormat;

/// One raw line of a log. `text` is valid until the next read on the same cursor.
struct RawLine {
    std::string_view text;
    std::uint64_t number = 0;  ///< 1-based
    /// Both cursors hand this line out; where it is damaged, the scan cursor's owner counts it.
    bool shared = false;
};

/// A source of raw lines with two independent cursors [T 9.2.2]: reading scans loses no odometry
/// and the other way round. Lines that set the stage for later ones (geometry, configuration,
/// parameters) are handed out by each cursor whose lines they concern.
class Fuente {
  public:
    virtual ~Fuente() = default;

    /// The format of the lines.
    virtual const LogFormat& format() const = 0;
    /// The next line that holds a scan, or metadata of scans; nothing at the end.
    virtual std::optional<RawLine> read_scan_line() = 0;
    /// The next line that holds odometry, or metadata of it; nothing at the end.
    virtual std::optional<RawLine> read_odometry_line() = 0;
    /// How far the scan cursor has come, 0 … 1; nothing where it cannot be known.
    virtual std::optional<double> progress() const = 0;
    /// What to call the source in messages: a path.
    virtual std::string name() const = 0;
    /// Reasons and line numbers of lines that no cursor could hand out (too long, no text); each
    /// such line is told once, to the scan cursor's owner.
    virtual std::optional<std::pair<std::uint64_t, Message>> take_damage() = 0;
    /// What there is to doubt about what it is read from.
    virtual std::vector<TourFinding> findings() const { return {}; }
    /// An equal source at its beginning.
    virtual std::unique_ptr<Fuente> reopen() const = 0;
    /// What is decided before the first scan is decided by this one: of a log that came in live
    /// (ReadOptions::opening_bytes) its first bytes alone, else an equal source.
    virtual std::unique_ptr<Fuente> opening() const { return reopen(); }
};

}  // namespace hitos
