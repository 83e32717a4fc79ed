// Trajectories in the TUM format: `t x y z qx qy qz qw`, one pose a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hitos/capture/geometry.hpp"

namespace hitos {

struct StampedPose {
    double time_s = 0.0;
    Pose pose;  ///< world from robot
    friend bool operator==(const StampedPose&, const StampedPose&) = default;
};

using Trajectory = std::vector<StampedPose>;

/// Reads plain or gzip TUM files. The heading is the yaw of the quaternion. Throws FileError or
/// FormatError with the line.
Trajectory read_trajectory(const std::filesystem::path& path);

std::string trajectory_to_text(const Trajectory& trajectory);
void write_trajectory(const Trajectory& trajectory, const std::filesystem::path& path);

}  // namespace hitos
