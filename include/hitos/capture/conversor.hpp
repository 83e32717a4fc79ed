// SPDX-License-Identifier: GPL-3.0-or-later
// From one raw format to the normalised record [T 9.2.2].
#pragma once

#include <memory>
#include <optional>

#include "hitos/capture/fuente.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Odometry as a log states it, before it becomes a twist held over an interval.
struct OdometryRecord {
    double time_s = 0.0;
    std::optional<Pose> pose_odom_robot;  ///< where the format logs poses
    std::optional<Twist> velocity;        ///< where the format logs velocities
    std::uint64_t line = 0;
};

/// Turns raw lines of one format into normalised records. A line of metadata updates the
/// converter and gives nothing. A damaged line throws FormatError with the field, what was found
/// and what was expected (path empty; the caller knows it).
class Conversor {
  public:
    virtual ~Conversor() = default;
    virtual std::optional<Scan> scan(const RawLine& line) = 0;
    /// Behind the last line: a scan of several lines, to which more might have come.
    virtual std::optional<Scan> last_scan() { return std::nullopt; }
    virtual std::optional<OdometryRecord> odometry(const RawLine& line) = 0;
};

}  // namespace hitos
