// Reads a whole log once and says what it holds.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hitos/capture/procesador.hpp"

namespace hitos {

/// Counts of a whole log, for dialogs and summaries.
struct LogSummary {
    LogFormat format = LogFormat::automatic;
    ReadReport report;
    double first_stamp_s = 0.0;
    double duration_s = 0.0;               ///< from the earliest stamp to the latest
    double distance_m = 0.0;               ///< length of the odometry's path
    Fan fan;                               ///< of the first scan
    std::vector<std::string> first_lines;  ///< raw, each cut to 200 bytes
    bool complete = true;                  ///< false where the caller stopped the reading
};

/// Told now and then how far the reading is, 0 … 1; false stops it.
using InspectProgress = std::function<bool(double)>;

/// Reads the log from one end to the other. Throws what open_log throws, and FormatError where not
/// one scan or odometry reading can be read.
LogSummary inspect_log(const std::filesystem::path& path, LogFormat format = LogFormat::automatic,
                       const ReadOptions& options = {}, const InspectProgress& progress = {});

}  // namespace hitos
