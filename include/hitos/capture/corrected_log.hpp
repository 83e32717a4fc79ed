// SPDX-License-Identifier: GPL-3.0-or-later
// Logs whose scans stand where an algorithm found them.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "hitos/capture/log_writer.hpp"

namespace hitos {

/// A writer of CARMEN logs with the robot's pose at every scan as an algorithm corrected it, in the
/// order of the scans; `first` is the tour's first scan, which decides how all are written. In a
/// FLASER line the laser's pose is the corrected one and the odometry's stays what it was, so that
/// the log read again is the same tour. A laser that FLASER cannot say is written as ROBOTLASER1,
/// whose two poses are both corrected ones; then there are no ODOM lines, and the log read again
/// has the corrected path for its odometry. Throws what make_log_writer() does, and FormatError
/// where the first scan cannot be said.
std::unique_ptr<LogWriter> make_corrected_log_writer(const std::filesystem::path& path,
                                                     std::vector<Pose> poses, const Scan& first);

}  // namespace hitos
