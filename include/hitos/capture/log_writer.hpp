// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a tour in a format of logs.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Takes scans and odometry in the order of time and writes them to a file that appears, whole,
/// at finish(). The poses that Player, radish and CARMEN log are the readings' twists summed from
/// (0, 0, 0). Without finish() nothing is left behind.
///
/// A scan is held until a reading reaches its time. One that carries odometry (a CARMEN line that
/// is both) waits for the reading of its own line and takes that reading's time where it is later,
/// which happens only in logs whose stamps go backwards.
class LogWriter {
  public:
    virtual ~LogWriter() = default;
    /// Throws FormatError where the scan cannot be said in the format (rays on no regular fan).
    virtual void write(const Scan& scan) = 0;
    /// Likewise of a scan of which is known which reading follows (null: none), so that nothing has
    /// to be held: however long the log is, and however little odometry it has.
    virtual void write(const Scan& scan, const Odometria* next) = 0;
    virtual void write(const Odometria& odometry) = 0;
    /// Throws FileError where the file cannot be put in place.
    virtual void finish() = 0;
};

/// Writes a whole tour, from where the reader stands, in the order of time; odometry first where
/// times are equal. `told` is called after every scan. The caller finishes the writer.
void write_tour(TourReader& reader, LogWriter& writer, const std::function<void()>& told = {});

/// A path that ends in .gz is compressed. Throws FileError where the folder cannot be written, and
/// ConfigError for a word that no format has (also "auto").
std::unique_ptr<LogWriter> make_log_writer(std::string_view format,
                                           const std::filesystem::path& path);

}  // namespace hitos
