// SPDX-License-Identifier: GPL-3.0-or-later
// Trajectories in the TUM format: `t x y z qx qy qz qw`, one pose a line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// Reads plain or gzip TUM files, in the file's order; `#` comments and empty lines are passed
/// over. Commas or semicolons may stand between the fields, a first line may name the columns (qw
/// before qx, more behind them), and stamps of a clock of today may be milliseconds, microseconds
/// or nanoseconds. The heading is the yaw of the quaternion; z is not used. Throws FileError or
/// FormatError with the line; a file without any pose is an error.
Trajectory read_trajectory(const std::filesystem::path& path);

/// As read_trajectory(), from text; `name` stands in messages.
Trajectory parse_trajectory(std::string_view text, const std::string& name);

/// `t x y 0 0 0 qz qw`: t in the shortest digits that read back to the same value, the others with
/// nine decimals. Throws Error for a pose that is not finite.
std::string trajectory_to_text(const Trajectory& trajectory);
/// Writes trajectory_to_text() atomically.
void write_trajectory(const Trajectory& trajectory, const std::filesystem::path& path);

}  // namespace hitos
